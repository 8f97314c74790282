"""Convex shapes: plumb.solve against the program's answers, bit for bit; what is a value."""

import copy
import json
import os
import pathlib
import pickle
import subprocess
import unittest

import numpy as np

import plumb
from drawn import pairs

CASES = pathlib.Path(os.environ["PLUMB_SOURCE_DIR"], "corpus/cases/shapes")
ORIGIN = (0, 0, 0)
SHAPES = (
    plumb.Superellipsoid((1, 2, 3), (2, 8)),
    plumb.Capsule(0, 1),
    plumb.Cylinder(1, 2),
    plumb.Cone(1, 2),
    plumb.Frustum((0, 1), 2),
    plumb.Box((1, 2, 3)),
    plumb.Polyhedron([ORIGIN, (1, 0, 0), (0, 1, 0), (0, 0, 1), (0.25, 0.25, 0.25)]),
    plumb.PolySuperellipsoid((1, 2, 3, 4, 5, 6), (3, 2)),
    plumb.HalfSpace(),
)


def shape_of(shape):
    """The shape of a case and by how much it is swept."""
    ((word, fields),) = shape.items()
    if word == "sphere_swept":
        core, radius = shape_of(fields["core"])
        return core, radius + fields["radius"]
    return getattr(plumb, "".join(part.capitalize() for part in word.split("_")))(**fields), 0


def body_of(body):
    shape, swept = shape_of(body["shape"])
    return plumb.ConvexBody(shape, body["position"], body["orientation"]["quaternion_wxyz"], swept)


def kept_cases():
    lines = [line for file in sorted(CASES.glob("*.jsonl")) for line in file.read_text().splitlines()]
    cases = [json.loads(line) for line in lines]
    return [case for case in cases if all("quaternion_wxyz" in body.get("orientation", {}) for body in case["bodies"])]


class AsTheProgram(unittest.TestCase):
    def test_every_kept_case(self):
        cases = kept_cases()
        self.assertGreater(len(cases), 30)
        text = "".join(json.dumps(case) + "\n" for case in cases)
        command = [plumb.find_program(), "solve", "-", "--json"]
        printed = subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout
        for case, line in zip(cases, printed.splitlines(), strict=True):
            contact, said = plumb.solve(*map(body_of, case["bodies"])), json.loads(line)
            with self.subTest(case["name"]):
                self.assertEqual((contact.method, str(contact.status)), (said["method"], said["status"]))
                self.assertEqual(str(contact.verdict), said["verdict"])
                self.assertEqual(contact.evaluations, said["evaluations"])
                for field in ("overlap", "normal", "points", "contact_point"):
                    np.testing.assert_array_equal(getattr(contact, field), said.get(field, np.nan))


class Pairs(unittest.TestCase):
    def test_two_superellipsoids_are_two_bodies(self):
        for body1, body2 in zip(*pairs(20, (2, 8))):
            turned = [
                plumb.ConvexBody(plumb.Superellipsoid(b.semi_axes, b.exponents), b.position, b.quaternion) for b in (body1, body2)
            ]
            alone, mixed, convex = plumb.solve(body1, body2), plumb.solve(body1, turned[1]), plumb.solve(*turned)
            for field in ("overlap", "normal", "points", "evaluations"):
                np.testing.assert_array_equal(getattr(alone, field), getattr(mixed, field))
                np.testing.assert_array_equal(getattr(alone, field), getattr(convex, field))

    def test_a_body_on_a_wall(self):
        wall = plumb.ConvexBody(plumb.HalfSpace(), ORIGIN)
        contact = plumb.solve(plumb.Body((1, 1, 2), (0, 0, 1.5)), wall)
        self.assertEqual((contact.overlap, contact.verdict), (0.5, plumb.Verdict.overlapping))
        np.testing.assert_array_equal(contact.normal, (0, 0, -1))
        self.assertEqual(plumb.solve(plumb.ConvexBody(plumb.Box((1, 1, 1)), (0, 0, 2), swept_radius=0.5), wall).overlap, -0.5)

    def test_curvature_and_derivatives_are_those_of_the_face_and_the_corner(self):
        brick = plumb.ConvexBody(plumb.Box((1, 1, 1)), ORIGIN)
        corner = plumb.ConvexBody(plumb.Box((1, 1, 1)), (0, 0, 2.5), (0.9, 0.2, 0.3, 0.1))
        contact = plumb.solve(brick, corner, want="overlap,curvature,derivatives,patch")
        self.assertTrue(np.all(np.isnan(contact.normal)))
        np.testing.assert_array_equal(contact.curvature_radii, ((np.inf, np.inf), (0, 0)))
        face, other = contact.derivatives
        np.testing.assert_array_equal(other.overlap_by_shift, (0, 0, -1))
        np.testing.assert_allclose(face.normal_by_turn, ((0, 1, 0), (-1, 0, 0), (0, 0, 0)), atol=1e-15)
        self.assertIsNone(contact.patch)

    def test_faces_on_one_another_turn_no_normal(self):
        brick = plumb.ConvexBody(plumb.Box((1, 1, 1)), ORIGIN)
        contact = plumb.solve(brick, brick.moved((0, 0, 1.5)), want="overlap,derivatives")
        self.assertEqual(contact.overlap, 0.5)
        self.assertTrue(np.all(np.isnan(contact.derivatives[0].normal_by_turn)))


class Values(unittest.TestCase):
    def test_shapes_and_bodies_are_values(self):
        bodies = [plumb.ConvexBody(shape, (1, 2, 3), (1, 1, 0, 0), 0.5) for shape in SHAPES]
        for value in (*SHAPES, *bodies):
            with self.subTest(value):
                self.assertEqual(pickle.loads(pickle.dumps(value)), value)
                self.assertEqual(copy.deepcopy(value), value)
                self.assertEqual(eval(repr(value), dict(vars(plumb))), value)
        self.assertEqual(len({*SHAPES, *bodies, *map(copy.copy, SHAPES), *map(copy.copy, bodies)}), 18)
        self.assertNotEqual(plumb.Cylinder(1, 2), plumb.Capsule(1, 2))
        self.assertEqual([body.shape for body in bodies], list(SHAPES))
        self.assertEqual(bodies[0].moved((0, 0, 1)).position[2], 1)
        self.assertEqual(bodies[0].moved(quaternion=(0, 1, 0, 0)).swept_radius, 0.5)

    def test_a_polyhedron_has_its_corners(self):
        points = SHAPES[6].points
        np.testing.assert_array_equal(points, [ORIGIN, (1, 0, 0), (0, 1, 0), (0, 0, 1)])
        points[0] = 7
        np.testing.assert_array_equal(SHAPES[6].points[0], ORIGIN)
        self.assertEqual(plumb.Polyhedron(np.asfortranarray(SHAPES[6].points)), SHAPES[6])
        self.assertEqual(plumb.Polyhedron([[1, 2, 3]] * 5).points.shape, (1, 3))


if __name__ == "__main__":
    unittest.main()
