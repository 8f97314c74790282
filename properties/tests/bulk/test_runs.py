"""Runs are kept and refused in one line; an interval is Student's; options without meaning are refused."""

import contextlib
import io
import math
import pathlib
import tempfile
import unittest
from unittest import mock

import packings
import runs
from scenes import Failed
from shapes import SHAPES


class Kept(unittest.TestCase):
    def test_a_scene_that_is_refused_is_said(self):
        with tempfile.TemporaryDirectory() as folder, mock.patch.object(packings, "STIFFNESS", -1):
            with self.assertRaisesRegex(Failed, "effects.linear.stiffness"):
                packings.packed(SHAPES[0], 30, 1, "damped", pathlib.Path(folder))

    def test_a_run_that_was_stopped_is_not_complete(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertFalse(runs.is_complete(pathlib.Path(folder)))
            pathlib.Path(folder, "run.json").write_text('{"complete": false}')
            self.assertFalse(runs.is_complete(pathlib.Path(folder)))


class Interval(unittest.TestCase):
    def test_it_is_students(self):
        mean, half = runs.interval([1.0, 2.0, 3.0])
        self.assertEqual(mean, 2.0)
        self.assertAlmostEqual(half, 4.303 / math.sqrt(3), places=12)
        self.assertEqual(runs.text_of([0.5], 2), "0.50")


class Study(unittest.TestCase):
    def study(self, run, **more):
        asked = runs.options("packings", "", 30, 1).parse_args([])
        for name, value in more.items():
            setattr(asked, name, value)
        said = io.StringIO()
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            asked.out, asked.command = pathlib.Path(folder), "x"
            code = runs.study(asked, "head", ["a", "b"], run, lambda kind, ends: f"{kind} {sum(ends)}")
        return code, said.getvalue()

    def test_seeds_begin_at_one_and_each_kind_has_a_line(self):
        code, said = self.study(lambda kind, seed: {"a": 1, "b": 10}[kind] * seed, seeds=3)
        self.assertEqual(code, 0)
        self.assertTrue(said.endswith("command x\nhead\na 6\nb 60\n"), said)

    def test_a_run_that_fails_ends_it(self):
        def fails(kind, _):
            raise Failed(f"{kind} fell over")
        self.assertEqual(self.study(fails), (1, "a fell over\n"))

    def test_what_has_no_meaning_is_refused(self):
        for wrong in ({"bodies": 29}, {"seeds": 0}, {"jobs": 0}):
            self.assertEqual(self.study(None, **wrong), (2, "--bodies: at least 30; --seeds and --jobs: at least 1\n"))


if __name__ == "__main__":
    unittest.main()
