"""One exception for each thing that is not legal; it names the argument."""

import dataclasses
import decimal
import unittest

import numpy as np

import plumb
from drawn import pairs

LONG = np.ones(3, np.longdouble)
ORIGIN = (0, 0, 0)
REACH = "the bounding radius, to the farthest point, must be finite"


class Refusals(unittest.TestCase):
    def expect(self, kind, text, call, *arguments, **named):
        with self.assertRaises(kind) as raised:
            call(*arguments, **named)
        self.assertEqual(str(raised.exception), text)

    def test_bodies_one_by_one(self):
        origin = (0, 0, 0)
        number = "must be of real numbers that fit in float64, not of "
        for kind, text, arguments in (
            (ValueError, "semi_axes: must have shape (3,), not (2,)", ((1, 1), origin)),
            (ValueError, "semi_axes: must have shape (3,), not (1, 3)", ([(1, 1, 1)], origin)),
            (ValueError, "semi_axes: must be an array of shape (3,)", ([1, [2, 3], 3], origin)),
            (ValueError, "semi_axes[1]: must be finite and above 0", ((1, 0, 1), origin)),
            (ValueError, "semi_axes[2]: must be finite and above 0", ((1, 1, np.nan), origin)),
            (TypeError, f"semi_axes: {number}{LONG.dtype}", (LONG, origin)),
            (TypeError, f"semi_axes: {number}complex128", ((1, 1, 1j), origin)),
            (TypeError, f"semi_axes: {number}object", ((decimal.Decimal(1),) * 3, origin)),
            (TypeError, f"semi_axes: {number}<U1", (("a", "b", "c"), origin)),
            (ValueError, "position: must be finite", ((1, 1, 1), (0, np.inf, 0))),
            (ValueError, "quaternion: must not be zero", ((1, 1, 1), origin, (0, 0, 0, 0))),
            (ValueError, "quaternion: must have shape (4,), not (3,)", ((1, 1, 1), origin, (0, 0, 0))),
            (ValueError, "exponents[0]: must be finite and above 1", ((1, 1, 1), origin, (1, 0, 0, 0), (1, 2))),
        ):
            with self.subTest(text):
                self.expect(kind, text, plumb.Body, *arguments)

    def test_solve(self):
        ball = plumb.Body((1, 1, 1), (0, 0, 0))
        names = ", ".join(method.name for method in plumb.methods())
        wanted = "overlap, normal, points, curvature, derivatives, patch"
        for kind, text, named in (
            (TypeError, "body2: must be a plumb.Body or a plumb.ConvexBody, not NoneType", {"body2": None}),
            (ValueError, f"method: no 'best' among {names}", {"method": "best"}),
            (ValueError, f"want: no 'depth' among {wanted}", {"want": "overlap,depth"}),
            (TypeError, "want: must be names, as a list or with commas", {"want": 3}),
            (ValueError, "motion: must have shape (3,), not (2,)", {"motion": (1, 2)}),
            (ValueError, "motion: must be finite", {"motion": (1, 2, np.nan)}),
            (TypeError, "last: must be a plumb.Contact", {"last": ball}),
            (ValueError, "iteration_limit: must be at least 1", {"iteration_limit": 0}),
            (TypeError, "iteration_limit: must be a whole number, not float", {"iteration_limit": 1.5}),
            (ValueError, "tolerance: must be 0 or more", {"tolerance": np.nan}),
            (TypeError, "tolerance: must be a number, not str", {"tolerance": "small"}),
            (ValueError, "patch_tolerance: must be above 0", {"patch_tolerance": 0}),
        ):
            with self.subTest(text):
                self.expect(kind, text, plumb.solve, **{"body1": ball, "body2": ball, **named})
        self.expect(TypeError, "contact: must be a plumb.Contact", plumb.diagnose, ball, ball, ball)

    def test_shapes(self):
        positive, not_negative = "must be finite and above 0", "must be finite and not below 0"
        for kind, text, call, arguments in (
            (ValueError, f"semi_axes[2]: {positive}", plumb.Superellipsoid, ((1, 1, np.nan),)),
            (ValueError, f"half_length: {not_negative}", plumb.Capsule, (-1, 1)),
            (ValueError, f"radius: {positive}", plumb.Capsule, (1, 0)),
            (ValueError, f"half_length: {positive}", plumb.Cylinder, (0, 1)),
            (ValueError, f"height: {positive}", plumb.Cone, (1, np.inf)),
            (ValueError, f"radii[1]: {not_negative}", plumb.Frustum, ((1, -1), 1)),
            (ValueError, "radii: must not both be 0", plumb.Frustum, ((0, 0), 1)),
            (ValueError, "radii: must have shape (2,), not (3,)", plumb.Frustum, ((1, 1, 1), 1)),
            (ValueError, f"half_extents[1]: {positive}", plumb.Box, ((1, 0, 1),)),
            (ValueError, f"semi_axes[5]: {positive}", plumb.PolySuperellipsoid, ((1, 1, 1, 1, 1, 0),)),
            (ValueError, "exponents[0]: must be finite and above 1", plumb.PolySuperellipsoid, ((1,) * 6, (1, 2))),
            (ValueError, "points: must have shape (n, 3), not (3,)", plumb.Polyhedron, (ORIGIN,)),
            (ValueError, "points: must be a point at least", plumb.Polyhedron, (np.empty((0, 3)),)),
            (ValueError, "points: must be finite", plumb.Polyhedron, ([(0, np.nan, 0)],)),
            (ValueError, f"points: {REACH}", plumb.Polyhedron, ([(1.7e308, 1.7e308, 0)],)),
            (ValueError, f"half_length, radius: {REACH}", plumb.Capsule, (1e308, 1e308)),
            (ValueError, "radius: must be a number, not of shape (1,)", plumb.Cone, ([1], 1)),
            (TypeError, "radius: must be of real numbers that fit in float64, not of object", plumb.Cone, (None, 1)),
            (TypeError, "points: must be of real numbers that fit in float64, not of complex128", plumb.Polyhedron, ([[1j] * 3],)),
        ):
            with self.subTest(text):
                self.expect(kind, text, call, *arguments)

    def test_convex_bodies(self):
        box = plumb.Box((1, 1, 1))
        for kind, text, named in (
            (TypeError, "shape: must be a shape, as plumb.Box or plumb.Capsule, not int", {"shape": 3}),
            (ValueError, "position: must be finite", {"position": (0, 0, np.inf)}),
            (ValueError, "quaternion: must not be zero", {"quaternion": (0, 0, 0, 0)}),
            (ValueError, "swept_radius: must be finite and not below 0", {"swept_radius": -1}),
            (ValueError, f"swept_radius: {REACH}", {"shape": plumb.Box((1e308, 1, 1)), "swept_radius": 1e308}),
        ):
            with self.subTest(text):
                self.expect(kind, text, plumb.ConvexBody, **{"shape": box, "position": ORIGIN, **named})
        self.expect(ValueError, "position: must be finite", plumb.ConvexBody(box, ORIGIN).moved, (0, np.nan, 0))

    def test_solve_of_shapes(self):
        brick, wall = (plumb.ConvexBody(shape, ORIGIN) for shape in (plumb.Box((1, 1, 1)), plumb.HalfSpace()))
        for kind, text, named in (
            (TypeError, "body1: must be a plumb.Body or a plumb.ConvexBody, not Box", {"body1": brick.shape}),
            (ValueError, "body2: two half-spaces have no lowest overlap", {"body1": wall, "body2": wall}),
            (ValueError, "method: 'new_cn' solves two plumb.Body alone, auto any pair", {"method": "new_cn"}),
        ):
            with self.subTest(text):
                self.expect(kind, text, plumb.solve, **{"body1": brick, "body2": brick, **named})
        self.expect(TypeError, "body1: must be a plumb.Body, not ConvexBody", plumb.case, brick, brick)

    def test_cases(self):
        ball = plumb.Body((1, 1, 1), (0, 0, 0))
        for kind, text, named in (
            (TypeError, "body1: must be a plumb.Body, not int", {"body1": 3}),
            (TypeError, "body2: must be a plumb.Body, not NoneType", {"body2": None}),
            (TypeError, "name: must be a text, not int", {"name": 3}),
            (TypeError, "motion: must be of real numbers that fit in float64", {"motion": "up"}),
            (ValueError, "motion: must have shape (3,), not (2,)", {"motion": (1, 2)}),
            (ValueError, "motion: must be finite", {"motion": (1, 2, np.nan)}),
        ):
            with self.subTest(text):
                self.expect(kind, text, plumb.case, **{"body1": ball, "body2": ball, **named})
        wanted = "of two bodies with shape, position and quaternion"
        self.expect(ValueError, f"case: has no field bodies, {wanted}", plumb.bodies_of, {})
        for one in (3, {"bodies": [1, 2]}, {"bodies": []}, {"bodies": 5}):
            with self.assertRaisesRegex(ValueError, "^case: has not two bodies with shape, position and quaternion: "):
                plumb.bodies_of(one)

    def test_arrays_of_bodies(self):
        rows = np.ones((5, 3))
        number = "must be of real numbers that fit in float64, not of "
        for kind, text, arguments in (
            (ValueError, "semi_axes: must have shape (n, 3) or (3,), not (5, 4)", (np.ones((5, 4)), rows)),
            (ValueError, "semi_axes: must have shape (n, 3) or (3,), not ()", (1.0, rows)),
            (ValueError, "semi_axes: must be an array of shape (n, 3)", ([[1, 2, 3], [1, 2]], rows)),
            (ValueError, "position: must have 5 rows as semi_axes has, not 4", (rows, rows[:4])),
            (TypeError, f"position: {number}{LONG.dtype}", (rows, rows.astype(np.longdouble))),
            (TypeError, f"quaternion: {number}object", (rows, rows, [None] * 4)),
            (ValueError, "exponents: must have shape (n, 2) or (2,), not (3,)", (rows, rows, (1, 0, 0, 0), (2, 2, 2))),
        ):
            with self.subTest(text):
                self.expect(kind, text, plumb.Bodies, *arguments)
        self.expect(IndexError, "index: 5 of 5 bodies", lambda: plumb.Bodies(rows, rows)[5])
        self.expect(TypeError, "index: must be a whole number, not str", lambda: plumb.Bodies(rows, rows)["x"])
        self.expect(TypeError, "bodies[0]: must be a plumb.Body, not int", plumb.Bodies.of, [1])
        self.expect(TypeError, "bodies: must be several plumb.Body, not int", plumb.Bodies.of, 1)

    def test_batch(self):
        bodies1, bodies2 = pairs(5)
        wanted = "overlap, normal, points, iterations, evaluations, charts"
        empty = plumb.Contacts.empty
        for kind, text, named in (
            (TypeError, "bodies1: must be plumb.Bodies, not Body", {"bodies1": bodies1[0]}),
            (ValueError, "bodies2: must be 5 as bodies1 are, not 4", {"bodies2": pairs(4)[1]}),
            (ValueError, f"want: no 'curvature' among {wanted}", {"want": ["curvature"]}),
            (ValueError, "want: must not be given with out, whose arrays say it", {"want": (), "out": empty(5)}),
            (TypeError, "out: must be plumb.Contacts, not dict", {"out": {}}),
            (TypeError, "last: must be plumb.Contacts, not dict", {"last": {}}),
            (ValueError, "last: has no charts; want them of the batch before", {"last": empty(5)}),
            (ValueError, "last.charts: must have shape (5, 2, 2, 3), not (4, 2, 2, 3)", {"last": empty(4, "charts")}),
            (ValueError, "out.status: must have shape (5,), not (4,)", {"out": empty(4)}),
            (ValueError, "threads: must be at least 1", {"threads": 0}),
            (TypeError, "threads: must be a whole number, not str", {"threads": "all"}),
            (ValueError, "iteration_limit: must be at least 1", {"iteration_limit": 0}),
            (ValueError, "tolerance: must be 0 or more", {"tolerance": -1}),
        ):
            with self.subTest(text):
                self.expect(kind, text, plumb.solve_batch, **{"bodies1": bodies1, "bodies2": bodies2, **named})
        self.expect(ValueError, "size: must be 0 or more", empty, -1)
        self.expect(TypeError, "size: must be a whole number, not str", empty, "5")
        self.expect(ValueError, "order: must be 'C' or 'F', not 'A'", empty, 5, order="A")

    def test_where_answers_go(self):
        bodies1, bodies2 = pairs(5)
        locked = np.empty((5, 3))
        locked.flags.writeable = False
        twice = np.empty((5, 3))
        for kind, text, changed in (
            (TypeError, "out.overlap: must be an array of float64", {"overlap": np.empty(5, np.float32)}),
            (TypeError, "out.status: must be an array of int32", {"status": None}),
            (ValueError, "out.points: must have shape (5, 2, 3), not (5, 6)", {"points": np.empty((5, 6))}),
            (ValueError, "out.normal: must be writeable and aligned", {"normal": locked}),
            (ValueError, "out.normal: shares memory with another array of the call", {"normal": bodies1.position}),
            (
                ValueError,
                "out.contact_point: shares memory with another array of the call",
                {"normal": twice, "contact_point": twice[::-1]},
            ),
        ):
            out = dataclasses.replace(plumb.Contacts.empty(5), **changed)
            with self.subTest(text):
                self.expect(kind, text, plumb.solve_batch, bodies1, bodies2, out=out)


if __name__ == "__main__":
    unittest.main()
