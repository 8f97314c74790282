"""What the study of patches is made of, without an engine: lines of action, lenses, half-spaces of flat bodies, limits."""

import json
import math
import pathlib
import unittest

import numpy as np

import draw_patches
import half_space
import methods
import patch_contact
import patch_tables
import study
from flat_lens import FlatLens
from patch_contact import Line
from superellipsoid import Body, pair_of

GEOMETRIES = pathlib.Path(study.__file__).with_name("patches.jsonl")
MODULUS = 1 / (2 * (1 - 0.3**2))
UP = np.array([0, 0, 1.0])


def ball(position=(0, 0, 0)):
    return Body(np.ones(3), np.array([2.0, 2.0]), np.array(position, float), np.eye(3))


class Lines(unittest.TestCase):
    def test_of_a_wrench_has_its_moment(self):
        force, at = np.array([1.0, 2, 2]), np.array([3.0, -1, 2])
        line = Line.of_wrench(force, np.cross(at - UP, force), UP)
        np.testing.assert_allclose(3 * line.moment_about(UP), np.cross(at - UP, force), atol=1e-14)
        self.assertAlmostEqual(line.off(Line(force / 3, at + 5 * force)), 0)

    def test_off_is_across_the_force(self):
        self.assertAlmostEqual(Line(UP, np.zeros(3)).off(Line(np.array([1.0, 0, 0]), np.array([3.0, 4, 7]))), 5)

    def test_a_tilted_foundation_is_as_much_farther_from_the_middle_of_the_area(self):
        """A force at 0 of depth, a uniform one at x = -1: so that of tilt_ratio 1.4 at 0.4."""
        laws = patch_contact.laws_of({"normal": UP, "centre": 0 * UP, "area": 2.0, "area_moment": np.cross([-1.0, 0, 0], 2 * UP)})
        at = (patch_contact.TILT_RATIO - 1) * np.array([1.0, 0, 0])
        np.testing.assert_allclose(laws["tilted"].point, at, atol=1e-15)

    def test_between_a_foundation_and_half_spaces(self):
        fem, foundation, halves = (Line(UP, np.array([x, y, z])) for x, y, z in ((2.0, 1, 0), (1.0, 0, 9), (5.0, 0, 3)))
        self.assertAlmostEqual(patch_contact.between(fem, foundation, halves, 1), 0.25)
        self.assertIsNone(patch_contact.between(fem, foundation, halves, 100))


class Lenses(unittest.TestCase):
    def test_of_two_balls_are_caps(self):
        lens = FlatLens.of((ball(), ball([0, 0, 1.98])), UP, np.array([0, 0, 0.99]))
        square, height = 1 - 0.99**2, 0.01
        self.assertAlmostEqual(lens.area / (np.pi * square), 1, delta=0.01)
        self.assertAlmostEqual(lens.volume / (2 * np.pi * height**2 * (3 - height) / 3), 1, delta=1e-3)
        np.testing.assert_allclose(lens.half, np.sqrt(square), rtol=0.01)
        np.testing.assert_allclose([lens.centre, lens.centre_of_depth], [[0, 0, 0.99]] * 2, atol=1e-9)

    def test_of_a_strip_lies_along_it_and_is_plumbs_patch(self):
        """The two laws act where a pressure that is the same everywhere does, and one like the depth."""
        for asked, ratio in (("edge8-12", 0.02), ("edge12", 0.005)):  # the second is narrower than the first look's cells
            geometry = next(g for g in study.read_geometries(GEOMETRIES) if g["name"] == asked)
            (case,) = methods.placed([study.at_ratio(geometry, ratio)])
            cn = methods.patches([case])[0]["auto"]
            lens = FlatLens.of(pair_of(case), np.array(cn["normal"]), np.array(cn["contact_point"]), cells=64)
            self.assertGreater(lens.half[0], 5 * lens.half[1])
            for name, error in patch_contact.columns(lens, cn["patch"]).items():
                self.assertLess(error, 0.01, name)


class FlatHalfSpaces(unittest.TestCase):
    def test_of_powers_are_sneddons(self):
        """A gap of B r^n (Sneddon, Int. J. Eng. Sci. 3 (1965) 47): the approach is B a^n sqrt(pi) Gamma(n/2 + 1) / Gamma(n/2 + 1/2),
        the force 2 E* a approach n / (n + 1)."""
        power, overlap = 8, 1e-4
        flat = [Body(np.ones(3), np.array([power, 2.0]), np.array([0, 0, z]), np.eye(3)) for z in (0, 2 - overlap)]
        growth = math.sqrt(math.pi) * math.gamma(power / 2 + 1) / math.gamma(power / 2 + 1 / 2)
        radius = (overlap / growth / (2 / power)) ** (1 / power)
        pressed = half_space.press(*flat, UP, UP, MODULUS, 64)
        self.assertAlmostEqual(pressed.force[2] / (2 * MODULUS * radius * overlap * power / (power + 1)), 1, delta=0.01)


class Limits(unittest.TestCase):
    def line(self, name, off, degrees=0.1):
        laws = dict.fromkeys(patch_tables.LAWS, off)
        return {"geometry": name, "ratio": 0.005, "arm": 0.5, "angles_deg": {"auto": degrees}, "centre_off": laws, "moment_off": laws}

    def test_of_faces_are_centre_and_moment_of_each_law(self):
        self.assertEqual(patch_tables.patch_findings(self.line("face8", 0.05, degrees=3)), [])
        self.assertEqual(len(patch_tables.patch_findings(self.line("face8", 0.051))), 6)
        self.assertEqual(len(patch_tables.patch_findings(self.line("face8", float("nan")))), 6)

    def test_of_edges_are_the_common_normals(self):
        self.assertEqual(patch_tables.patch_findings(self.line("edge8", 9)), [])
        self.assertEqual(len(patch_tables.patch_findings(self.line("edge8", 0, degrees=0.2))), 1)

    def test_no_answer_is_a_finding(self):
        self.assertEqual(patch_tables.patch_findings({"geometry": "face8", "reason": "ccx did not end"}), ["ccx did not end"])


class Geometries(unittest.TestCase):
    def test_are_those_that_are_drawn(self):
        drawn = "".join(json.dumps(case) + "\n" for case in draw_patches.cases())
        self.assertEqual(drawn, GEOMETRIES.read_text())


if __name__ == "__main__":
    unittest.main()
