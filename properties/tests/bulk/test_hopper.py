"""The hopper's bodies have one volume and start apart, its measures find what is put in, and a short run ends in a table."""

import contextlib
import io
import itertools
import math
import tempfile
import unittest
from unittest import mock

import hopper
import numpy as np


class Scenes(unittest.TestCase):
    def test_all_have_the_volume_of_the_ball(self):
        for aspect in hopper.ASPECTS:
            a, b, c = hopper.spheroid(aspect)
            self.assertAlmostEqual(8 * a * b * c / hopper.DIAMETER ** 3, 1, places=12)
            self.assertAlmostEqual(c / a, aspect, places=12)

    def test_bodies_start_apart_above_the_bumps_and_within_the_walls(self):
        for aspect in hopper.ASPECTS:
            longest = max(hopper.spheroid(aspect))
            places = [body["position"] for body in hopper.rained(aspect, 100, 1)]
            self.assertGreater(min(math.dist(p, q) for p, q in itertools.combinations(places, 2)), 2 * longest)
            for x, y, z in places:
                self.assertLessEqual(abs(x) + longest, hopper.WIDTH / 2 * hopper.DIAMETER)
                self.assertLessEqual(abs(y) + longest, hopper.DEPTH / 2 * hopper.DIAMETER)
                self.assertGreater(z, longest + hopper.DIAMETER / 2)

    def test_the_slit_is_a_gap_in_floor_and_bumps(self):
        def corners(is_open):
            return [abs(corner[0]) for triangle in hopper.floor(is_open)["mesh"]["triangles"] for corner in triangle]
        self.assertEqual(min(corners(False)), 0)
        self.assertAlmostEqual(2 * min(corners(True)), hopper.SLIT * hopper.DIAMETER, places=12)
        for bump in hopper.bumps():
            self.assertGreaterEqual(abs(bump["position"][0]) + 1e-12, (hopper.SLIT + 1) / 2 * hopper.DIAMETER)
            self.assertLessEqual(abs(bump["position"][0]), (hopper.WIDTH - 1) / 2 * hopper.DIAMETER + 1e-12)


class Measures(unittest.TestCase):
    def test_of_a_steady_flow_the_rate_is_that(self):
        self.assertAlmostEqual(hopper.outflow(3 * np.arange(20)), 3 / hopper.FRAME, places=9)

    def test_of_two_heaps_the_slope_is_theirs(self):
        rise = math.tan(math.radians(27))
        places = [(x * hopper.DIAMETER / 4, rise * abs(x) * hopper.DIAMETER / 4 - deep) for x in range(-46, 47) for deep in (0, 0.003)]
        self.assertAlmostEqual(hopper.slope_deg(places), 27, delta=0.5)

    def test_of_nothing_there_is_none(self):
        self.assertTrue(math.isnan(hopper.slope_deg([])))
        self.assertTrue(math.isnan(hopper.outflow(np.array([0, 0, 100]))))


class Study(unittest.TestCase):
    def main(self, *arguments):
        said = io.StringIO()
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            code = hopper.main(["--out", folder, *arguments])
        return code, said.getvalue()

    def test_a_short_run_ends_in_a_table(self):
        with mock.patch.multiple(hopper, FILLING=0.1, RUNNING=0.1):
            code, said = self.main("--aspects", "2", "--bodies", "40", "--seeds", "1")
        self.assertEqual(code, 0, said)
        self.assertRegex(said, r"\n +2  \S+ ")

    def test_a_program_that_fails_is_said(self):
        with mock.patch.dict("os.environ", {"PLUMB_SCENE": "/bin/false"}):
            self.assertEqual(self.main("--aspects", "1", "--seeds", "1"), (1, "1-1200-1-filled.json: \n"))

    def test_what_has_no_meaning_is_refused(self):
        self.assertEqual(self.main("--aspects", "0"), (2, "--aspects: between 0.2 and 5\n"))


if __name__ == "__main__":
    unittest.main()
