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

import numpy as np

import calculix
import contact
import tasks
from superellipsoid import pair_of

HAS_ENGINES = shutil.which("ccx") is not None and importlib.util.find_spec("gmsh") is not None


def answer(normal, points):
    return {"normal": normal, "points": points, "contact_point": np.mean(points, axis=0).tolist()}


@unittest.skipUnless(HAS_ENGINES, "needs gmsh and calculix-ccx")
class Contact(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        """Two balls, 2 % of their distance in each other, along a line that no mesh knows."""
        line = np.array([0.48, -0.6, 0.64])
        ball = {"superellipsoid": {"semi_axes": [1, 1, 1], "exponents": [2, 2]}}
        upright = {"quaternion_wxyz": [1, 0, 0, 0]}
        places = [[0, 0, 0], (1.96 * line).tolist()]
        case = {"bodies": [{"shape": ball, "position": place, "orientation": upright} for place in places]}
        cls.line = line
        cls.answer = answer(line.tolist(), [line.tolist(), (0.96 * line).tolist()])
        setting = calculix.Setting()
        pair = pair_of(case)
        lens = contact.Lens.of(pair, cls.answer)
        meshes, deck = contact.meshes_and_deck(pair, cls.answer, lens, contact.Mode(order=1, division=3), setting)
        with tempfile.TemporaryDirectory() as folder:
            cls.result = calculix.run(pathlib.Path(folder), deck, meshes, setting)

    def test_the_force_is_along_the_line(self):
        judged = contact.judged(self.result, {"auto": self.answer}, radius=0.14)
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
    def started(self, out):
        """A study of its own session, which is the group that a terminal's Ctrl-C goes to, once an engine is at work."""
        study = pathlib.Path(calculix.__file__).with_name("study.py")
        words = [sys.executable, "-B", study, "--quick", "--jobs", "1", "--out", out]
        running = subprocess.Popen(words, start_new_session=True, stderr=subprocess.PIPE, text=True)
        while running.poll() is None and not any(pathlib.Path(out).glob("work/*/contact.inp")):
            time.sleep(0.05)
        return running

    def left(self, session):
        return [e for e in pathlib.Path("/proc").iterdir() if e.name.isdigit() and is_of_session(e, session)]

    def test_ctrl_c_is_one_line_and_leaves_no_engine(self):
        with tempfile.TemporaryDirectory() as out, self.started(out) as running:
            os.killpg(running.pid, signal.SIGINT)
            self.assertRegex(running.communicate()[1], r"\A\s0 of \d+ calculations\ninterrupted: [^\n]*\n\Z")
            self.assertEqual(running.returncode, 130)
            self.assertEqual(self.left(running.pid), [])

    def test_a_killed_study_leaves_neither_engine_nor_lock(self):
        with tempfile.TemporaryDirectory() as out:
            with self.started(out) as running:
                running.kill()
            while self.left(running.pid):
                time.sleep(0.05)
            with tasks.alone_in(pathlib.Path(out)):
                pass


if __name__ == "__main__":
    unittest.main()
