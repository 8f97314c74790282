"""One contact from end to end, where gmsh and CalculiX are installed: CI does not install them."""

import importlib.util
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from unittest import mock

import numpy as np

import calculix

HAS_ENGINES = shutil.which("ccx") is not None and importlib.util.find_spec("gmsh") is not None


def answer(normal, points):
    return {"normal": normal, "points": points, "contact_point": np.mean(points, axis=0).tolist()}


@unittest.skipUnless(HAS_ENGINES, "needs gmsh and calculix-ccx")
class Contact(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """Two balls, 2 % of their distance in each other, along a line that no mesh knows."""
        import contact

        line = np.array([0.48, -0.6, 0.64])
        ball = {"superellipsoid": {"semi_axes": [1, 1, 1], "exponents": [2, 2]}}
        upright = {"quaternion_wxyz": [1, 0, 0, 0]}
        places = [[0, 0, 0], (1.96 * line).tolist()]
        case = {"bodies": [{"shape": ball, "position": place, "orientation": upright} for place in places]}
        cls.line, cls.contact = line, contact
        cls.answer = answer(line.tolist(), [line.tolist(), (0.96 * line).tolist()])
        setting = calculix.Setting()
        meshes, deck = contact.meshes_and_deck(case, cls.answer, contact.Mode(order=1, division=3), setting)
        with tempfile.TemporaryDirectory() as folder:
            cls.result = calculix.run(pathlib.Path(folder), deck, meshes, setting)

    def test_the_force_is_along_the_line(self):
        judged = self.contact.judged(self.result, {"auto": self.answer}, radius=0.14)
        self.assertLess(judged["angles_deg"]["auto"], 0.05)
        self.assertLess(judged["centre_off"]["auto"], 0.02)
        self.assertLess(judged["balance"], 1e-5)
        self.assertLess(judged["elements_agree"], 1e-5)

    def test_the_force_is_of_hertzs_size(self):
        """Within what coarse meshes, an overlap that is not small and the half that is held leave."""
        hertz = 4 / 3 / (2 * (1 - 0.3**2)) * np.sqrt(0.5) * 0.04**1.5
        self.assertLess(abs(np.linalg.norm(self.result.forces[1]) / hertz - 1), 0.2)

    def test_a_kept_result_is_the_result(self):
        again = calculix.Result.from_json(self.result.to_json())
        np.testing.assert_array_equal(again.forces, self.result.forces)
        self.assertEqual((again.area, again.nodes), (self.result.area, self.result.nodes))


def pushed(force, at):
    """A calculation that ended with `force` on body 2 along a line through `at`."""
    forces, moments = np.array([-force, force]), np.array([-np.cross(at, force), np.cross(at, force)])
    return calculix.Result(forces, moments, force, np.array([1.0, 0, 0]), area=np.pi, iterations=1, nodes=1)


class Judging(unittest.TestCase):
    """Needs no engine, but what imports gmsh."""

    @unittest.skipUnless(HAS_ENGINES, "needs gmsh and calculix-ccx")
    def test_the_centre_is_on_the_line_of_action_by_the_patch(self):
        import contact

        result = pushed(np.array([0.0, 0, 2]), np.array([1.5, 0, -7]))
        np.testing.assert_allclose(contact.pressure_centre(result), [1.5, 0, 0])
        judged = contact.judged(result, {"auto": answer([0, 0, 1], [[1, 0, 5], [1, 0, 6]])}, radius=0.25)
        self.assertEqual((judged["force"], judged["balance"], judged["lines_apart"]), (2, 0, 0))
        self.assertAlmostEqual(judged["centre_off"]["auto"], 2)
        self.assertAlmostEqual(judged["fem_patch_radius"], 1)


@unittest.skipUnless(HAS_ENGINES, "needs gmsh and calculix-ccx")
class Checks(unittest.TestCase):
    def test_without_hertz_there_is_no_study(self):
        import checks

        with self.assertRaisesRegex(checks.NoCheck, "Hertz: ccx did not end"):
            list(checks.hertz(None, {"reason": "ccx did not end"}, "Hertz", (0.02, 0.01, 0.1)))

    def test_planes_that_end_apart_are_beyond_the_limit(self):
        import checks

        ends = [{"direction": [0, 0, 1], "fem_deg": 0.1}, {"direction": [0, 1e-3, 1]}, {"reason": "not settled"}]
        spread, to_fem = checks.half_spaces([{"planes": ends}])
        self.assertGreater(spread[1], spread[2])
        self.assertEqual(to_fem[1], 0.1)

    def test_the_worst_is_no_number_where_one_is_none(self):
        import checks

        (of,) = checks.variations([{"turned_deg": 0.1}, {"turned_deg": float("nan")}])
        self.assertFalse(of[1] <= of[2])


@unittest.skipUnless(HAS_ENGINES, "needs gmsh and calculix-ccx")
class Keeping(unittest.TestCase):
    def test_what_is_kept_is_not_made_again_and_what_is_broken_is(self):
        import tasks

        with tempfile.TemporaryDirectory() as folder:
            out = pathlib.Path(folder)
            (out / "kept").mkdir()

            def engine(work, *_):
                work.mkdir(parents=True)
                return pushed(np.array([0, 0, 1.0]), np.zeros(3))

            task = tasks.Task("G1", 0.01, {}, {"auto": None}, None)
            with (
                mock.patch.object(tasks.contact, "meshes_and_deck", return_value=([], "deck")),
                mock.patch.object(tasks.calculix, "run", side_effect=engine) as run,
            ):
                for text, runs in ((None, 1), (None, 1), ("{", 2), ('{"forces": 1}', 3), (None, 3)):
                    for path in (out / "kept").iterdir():
                        path.write_text(text or path.read_text())
                    self.assertEqual(tasks._result(task, out, "ccx").nodes, 1)
                    self.assertEqual(run.call_count, runs)

    def test_a_folder_is_one_runs_at_a_time(self):
        import tasks

        with tempfile.TemporaryDirectory() as folder, tasks._alone_in(pathlib.Path(folder)):
            with self.assertRaisesRegex(tasks.Busy, "another run is writing there"):
                tasks.run_all([], folder, "ccx", 1, print)


@unittest.skipUnless(HAS_ENGINES, "needs gmsh and calculix-ccx")
class Failure(unittest.TestCase):
    def test_an_engine_that_does_not_end_is_said(self):
        with tempfile.TemporaryDirectory() as folder, self.assertRaisesRegex(calculix.EngineFailure, "contact.log"):
            calculix.run(pathlib.Path(folder), "*NODE\n", [], calculix.Setting())


def is_of_session(entry, session):
    try:
        state, *numbers = (entry / "stat").read_text().rpartition(")")[2].split()
    except OSError:  # it has ended
        return False
    return int(numbers[2]) == session and state != "Z"


@unittest.skipUnless(HAS_ENGINES, "needs gmsh and calculix-ccx")
class Interrupting(unittest.TestCase):
    def test_ctrl_c_is_one_line_and_leaves_no_engine(self):
        study = pathlib.Path(calculix.__file__).with_name("study.py")
        with tempfile.TemporaryDirectory() as out:
            words = [sys.executable, "-B", study, "--quick", "--jobs", "1", "--out", out]
            # A session is the group that a terminal's Ctrl-C goes to.
            with subprocess.Popen(words, start_new_session=True, stderr=subprocess.PIPE, text=True) as running:
                while running.poll() is None and not any(pathlib.Path(out).glob("work/*/contact.inp")):
                    time.sleep(0.05)
                os.killpg(running.pid, signal.SIGINT)
                self.assertRegex(running.communicate()[1], r"\A\ninterrupted: [^\n]*\n\Z")
            self.assertEqual(running.returncode, 130)
            left = [e for e in pathlib.Path("/proc").iterdir() if e.name.isdigit() and is_of_session(e, running.pid)]
            self.assertEqual(left, [])


if __name__ == "__main__":
    unittest.main()
