"""plumb.solve against the program's answers, bit for bit; warm starts; what is asked for."""

import copy
import json
import math
import os
import pathlib
import pickle
import subprocess
import unittest

import numpy as np

import plumb
from drawn import pairs

CASES = pathlib.Path(os.environ["PLUMB_SOURCE_DIR"], "corpus/cases/hard")
EVERYTHING = ("overlap", "normal", "points", "curvature", "derivatives")


def kept_cases():
    files = ("disc", "edge_face", "face_face", "exponent_large", "huge_numbers", "near_touching_separated", "tie")
    lines = [line for name in files for line in (CASES / f"{name}.jsonl").read_text().splitlines()[:3]]
    return [json.loads(line) for line in lines]


def answers_of_the_program(cases, *arguments):
    text = "".join(json.dumps(case) + "\n" for case in cases)
    command = [plumb.find_program(), "solve", "-", "--json", *arguments]
    printed = subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout
    return [json.loads(line) for line in printed.splitlines()]


class AsTheProgram(unittest.TestCase):
    def expect_same(self, contact, said):
        self.assertEqual(contact.method, said["method"])
        self.assertEqual(str(contact.status), said["status"])
        self.assertEqual(str(contact.verdict), said["verdict"])
        self.assertEqual((contact.iterations, contact.evaluations), (said["iterations"], said["evaluations"]))
        for field in ("overlap", "normal", "points", "contact_point"):
            if field in said:
                np.testing.assert_array_equal(getattr(contact, field), said[field])
            else:
                self.assertFalse(np.all(np.isfinite(getattr(contact, field))), field)

    def test_every_method(self):
        cases = kept_cases()
        names = [method.name for method in plumb.methods()]
        for said in answers_of_the_program(cases, "--method", ",".join(names)):
            case = next(case for case in cases if case["name"] == said["name"])
            with self.subTest(case=said["name"], method=said["method"]):
                self.expect_same(plumb.solve(*plumb.bodies_of(case), said["method"]), said)

    def test_curvature_and_derivatives(self):
        cases = [plumb.case(*bodies, name=str(i)) for i, bodies in enumerate(zip(*pairs(5)))]
        for case, said in zip(cases, answers_of_the_program(cases, "--want", ",".join(EVERYTHING))):
            contact = plumb.solve(*plumb.bodies_of(case), want=EVERYTHING)
            np.testing.assert_array_equal(contact.curvature_radii, [body["radii"] for body in said["curvature"]])
            np.testing.assert_array_equal(contact.curvature_directions, [body["directions"] for body in said["curvature"]])
            for mine, theirs in zip(contact.derivatives, said["derivatives"]):
                for field, value in theirs.items():
                    np.testing.assert_array_equal(getattr(mine, field), value)

    def test_motion(self):
        body1, body2 = (bodies[0] for bodies in pairs(1))
        case = plumb.case(body1, body2, motion=(1, 2, 3))
        said = answers_of_the_program([case], "--method", "first_touch")[0]
        self.expect_same(plumb.solve(body1, body2, "first_touch", motion=(1, 2, 3)), said)


class OnePair(unittest.TestCase):
    def setUp(self):
        self.body1, self.body2 = (bodies[0] for bodies in pairs(1, (2, 8)))

    def test_a_warm_start_takes_fewer_evaluations_to_the_same_contact(self):
        cold = plumb.solve(self.body1, self.body2)
        moved = self.body2.moved(self.body2.position + 1e-6)
        warm, again = plumb.solve(self.body1, moved, last=cold), plumb.solve(self.body1, moved)
        self.assertLess(warm.evaluations, again.evaluations)
        self.assertAlmostEqual(warm.overlap, again.overlap, delta=1e-14)

    def test_what_was_not_asked_for_is_not_a_number(self):
        contact = plumb.solve(self.body1, self.body2, want=())
        self.assertEqual(contact.status, plumb.Status.converged)
        self.assertNotEqual(contact.verdict, plumb.Verdict.undecided)
        for field in ("overlap", "normal", "points", "curvature_radii", "curvature_directions"):
            self.assertTrue(np.all(np.isnan(getattr(contact, field))), field)
        self.assertIsNone(contact.derivatives)
        self.assertIsNone(contact.patch)

    def test_derivatives_are_those_of_the_overlap(self):
        contact = plumb.solve(self.body1, self.body2, want="overlap,derivatives")
        step = 1e-6
        for axis in range(3):
            shift = step * np.eye(3)[axis]
            ends = [plumb.solve(self.body1, self.body2.moved(self.body2.position + s * shift)).overlap for s in (-1, 1)]
            slope = (ends[1] - ends[0]) / (2 * step)
            self.assertAlmostEqual(slope, contact.derivatives[1].overlap_by_shift[axis], delta=1e-8)

    def test_the_area_of_a_patch_is_the_derivative_of_its_volume(self):
        lower = plumb.Body((1, 0.8, 0.6), (0, 0, 0))
        upper = plumb.Body((0.9, 1, 0.7), (0.2, 0.1, 1.2), (1, 0.1, 0.2, 0))

        def patch_at(shift):
            return plumb.solve(lower, upper.moved(upper.position + shift), want="patch", patch_tolerance=1e-7).patch

        patch, step = patch_at(0), 1e-4
        self.assertLess(patch.error, 1e-7)
        for axis in range(3):
            shift = step * np.eye(3)[axis]
            slope = (patch_at(shift).volume - patch_at(-shift).volume) / (2 * step)
            self.assertAlmostEqual(slope, -patch.area * patch.normal[axis], delta=1e-3 * patch.area)
        offsets = patch.points - patch.centre
        spread = patch.axes.T @ np.diag(patch.second_moments) @ patch.axes
        np.testing.assert_allclose(offsets.mean(axis=0), 0, atol=1e-12)
        np.testing.assert_allclose(offsets.T @ offsets / 4, spread, rtol=0, atol=1e-12)

    def test_limits_of_the_solve(self):
        one = plumb.solve(self.body1, self.body2, "new_cn", iteration_limit=1)
        self.assertEqual((one.status, one.iterations), (plumb.Status.iteration_limit, 1))
        loose = plumb.solve(self.body1, self.body2, tolerance=1e-3)
        self.assertLess(loose.evaluations, plumb.solve(self.body1, self.body2).evaluations)

    def test_diagnosis(self):
        true = plumb.diagnose(self.body1, self.body2, plumb.solve(self.body1, self.body2))
        for angle in true[:3]:
            self.assertLess(angle, 1e-6)
        other = plumb.diagnose(self.body1, self.body2, plumb.solve(self.body1, self.body2, "geometric_potential"))
        self.assertGreater(other.d_n1, 0.1)
        self.assertEqual(other.residues.shape, (5,))

    def test_bodies_are_values(self):
        body = self.body2
        self.assertEqual(pickle.loads(pickle.dumps(body)), body)
        self.assertEqual(copy.deepcopy(body), body)
        self.assertEqual(len({body, body.moved(), self.body1}), 2)
        self.assertNotEqual(body, body.moved(position=(0, 0, 1)))
        self.assertEqual(eval(repr(body), {"Body": plumb.Body}), body)
        position = body.position
        position[0] = math.pi
        self.assertNotEqual(body.position[0], math.pi)

    def test_whole_and_short_numbers_are_taken(self):
        for axes in ([1, 2, 3], np.array([1, 2, 3], np.float32), np.array([1, 2, 3], np.uint8)[::1]):
            self.assertEqual(plumb.Body(axes, (0, 0, 0)), plumb.Body((1.0, 2.0, 3.0), (0, 0, 0)))


if __name__ == "__main__":
    unittest.main()
