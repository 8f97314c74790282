"""What the finite element study is made of, each part against what shares no code with it."""

import io
import json
import pathlib
import re
import unittest
from contextlib import redirect_stdout

import numpy as np

import calculix
import draw
import half_space
import methods
import planes
import tables
from gap import basis_of, gap_on, lens_window
from mesh import EDGES, Mesh, least_volumes, onto_body, volumes
from superellipsoid import Body, matrix_of

FEM = pathlib.Path(calculix.__file__).parent
MODULUS = 1 / (2 * (1 - 0.3**2))  # of two bodies of Young's modulus 1


def ball(position=(0, 0, 0), radius=1.0):
    return Body(np.full(3, radius), np.array([2.0, 2.0]), np.array(position, float), np.eye(3))


def block():
    return Body(np.array([1, 0.7, 0.5]), np.array([5.0, 3.0]), np.array([0.3, -1, 2]), matrix_of([1, 0.4, -0.2, 0.3]))


class Shape(unittest.TestCase):
    def test_gauge_is_the_formula(self):
        x, y, z = 0.2, -0.3, 0.4
        wanted = ((abs(x / 1) ** 3 + abs(y / 0.7) ** 3) ** (5 / 3) + abs(z / 0.5) ** 5) ** (1 / 5)
        self.assertAlmostEqual(block().gauge(np.array([[x, y, z]]))[0], wanted, delta=1e-15)

    def test_gradient_is_the_slope_of_the_gauge(self):
        points = np.random.default_rng(1).normal(size=(50, 3))
        points[:3] = np.diag(block().semi_axes)  # and the tips
        steps = 1e-6 * np.eye(3)
        slopes = [(block().gauge(points + s) - block().gauge(points - s)) / 2e-6 for s in steps]
        np.testing.assert_allclose(block().gradient(points), np.column_stack(slopes), atol=1e-8)

    def test_the_ball_goes_onto_the_body_and_back(self):
        points = np.random.default_rng(2).uniform(-1, 1, size=(200, 3))
        points[0] = 0
        local = block().of_sphere(points)
        np.testing.assert_allclose(block().gauge(local), np.linalg.norm(points, axis=1), atol=1e-14)
        np.testing.assert_allclose(block().to_sphere(local[1:]), points[1:], atol=1e-13)

    def test_heights_end_on_the_surface(self):
        body, along = block(), np.array([0.6, 0, 0.8])
        starts = body.position + np.random.default_rng(3).uniform(-0.3, 0.3, size=(100, 3))
        up, down = body.heights(starts, along, +1), body.heights(starts, along, -1)
        for heights in (up, down):
            np.testing.assert_allclose(body.gauge(body.to_body(starts + heights[:, None] * along)), 1, atol=1e-12)
        self.assertTrue((up > down).all())

    def test_a_line_that_misses_has_no_height(self):
        heights = ball().heights(np.array([[0, 0, 0], [1.1, 0, 0], [0.999, 0, 0]]), np.array([0, 0, 1.0]), +1)
        np.testing.assert_array_equal(np.isnan(heights), [False, True, False])


class Gaps(unittest.TestCase):
    def test_of_two_balls_is_that_of_circles(self):
        first, second = ball(), ball((0, 0, 1.98))
        gap = gap_on(first, second, np.eye(3), np.array([0, 0, 0.99]), [0.1, 0.1], 5)
        self.assertAlmostEqual(gap.values[2, 2], -0.02, delta=1e-13)
        self.assertAlmostEqual(gap.values[4, 2], 1.98 - 2 * np.sqrt(1 - 0.08**2), delta=1e-13)

    def test_the_window_holds_the_lens(self):
        first, second = ball(), ball((0, 0, 1.98))
        centre, half = lens_window(first, second, np.eye(3), np.array([0.02, 0.05, 0.99]))
        self.assertLess(np.abs(centre[:2]).max(), 0.01)
        radius = np.sqrt(1 - 0.99**2)
        self.assertTrue((half > radius).all() and (half < 1.6 * radius).all(), half)


class HalfSpaces(unittest.TestCase):
    line = np.array([0.3, 0.5, 0.81]) / np.linalg.norm([0.3, 0.5, 0.81])
    overlap = 4e-4

    def pressed(self, cells):
        second = ball((2 - self.overlap) * self.line)
        return half_space.press(ball(), second, self.line, self.line, MODULUS, cells)

    def test_of_balls_are_hertz(self):
        force = 4 / 3 * MODULUS * np.sqrt(0.5) * self.overlap**1.5  # Johnson, Contact Mechanics, 4.23
        for cells, error in ((32, 2e-3), (96, 3e-4)):
            pressed = self.pressed(cells)
            self.assertLess(abs(np.linalg.norm(pressed.force) / force - 1), error)
            self.assertLess(np.linalg.norm(np.cross(pressed.force, self.line)) / force, 1e-9)
            self.assertLess(abs(pressed.area / (np.pi * 0.5 * self.overlap) - 1), 10 / cells)

    def test_of_unlike_curvatures_are_hertz_with_elliptic_integrals(self):
        """A ball on an ellipsoid; Johnson 4.24 to 4.28 with the integrals by the arithmetic-geometric mean."""
        first = Body(np.array([1, 0.5, 0.25]), np.array([2.0, 2.0]), np.zeros(3), np.eye(3))
        overlap = 2e-5
        second = ball((0, 0, 0.25 + 1 - overlap))
        pressed = half_space.press(first, second, np.array([0, 0, 1.0]), np.array([0, 0, 0.25]), MODULUS, 128)
        small, large = 1 + 0.25 / 1**2, 1 + 0.25 / 0.5**2  # relative curvatures: 1/R of the ball, c/a^2, c/b^2
        self.assertLess(abs(np.linalg.norm(pressed.force) / hertz_force(small, large, overlap) - 1), 2e-3)

    def test_the_plane_settles_at_the_line_of_the_centres(self):
        second = ball((2 - self.overlap) * self.line)
        start = basis_of(self.line + [0.2, 0, -0.1])[2]
        pressed, planes = half_space.settle(ball(), second, start, self.line, MODULUS)
        self.assertLess(np.linalg.norm(np.cross(pressed.force, self.line)) / np.linalg.norm(pressed.force), 1e-8)
        self.assertGreater(planes, 1)

    def test_pressures_that_do_not_come_to_rest_are_said(self):
        gap = gap_on(ball(), ball((0, 0, 1.98)), np.eye(3), np.array([0, 0, 0.99]), [0.2, 0.2], 16)
        with self.assertRaises(half_space.NotSettled):
            half_space.pressures(gap.values, gap.step, MODULUS, limit=2)


def complete_elliptic(m):
    """K and E of the parameter m."""
    a, b, c, power, lost = 1.0, np.sqrt(1 - m), np.sqrt(m), 0.5, 0.0
    while abs(c) > 1e-16:
        lost += power * c * c
        a, b, c, power = (a + b) / 2, np.sqrt(a * b), (a - b) / 2, 2 * power
    whole = np.pi / (2 * a)
    return whole, whole * (1 - lost)


def hertz_force(small, large, overlap):
    """The ellipse whose integrals give the ratio of the curvatures, by bisection on its eccentricity squared."""
    low, high = 0.0, 1 - 1e-12
    for _ in range(200):
        m = (low + high) / 2
        k, e = complete_elliptic(m)
        ratio = (e / (1 - m) - k) / (k - e) if m > 1e-9 else 1.0
        low, high = (m, high) if ratio < large / small else (low, m)
    k, e = complete_elliptic(m)
    # Semi-axes a > b = a sqrt(1 - m), greatest pressure p0. Half the curvatures are p0 b / (E* a^2 m) times K - E and E / (1 - m) - K
    # (4.26), the overlap is p0 b K / E* (4.26c), the load 2/3 p0 pi a b.
    sum_ = ((e / (1 - m) - k) + (k - e)) / m
    square = 2 * overlap * sum_ / (k * (small + large))
    return 2 / 3 * np.pi * MODULUS * overlap * np.sqrt(square) / k


class Meshes(unittest.TestCase):
    corners = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], float)

    def test_a_tetrahedron_turned_inside_out_is_refused(self):
        with self.assertRaises(Exception) as refused:
            onto_body(ball(), self.corners, np.array([[0, 2, 1, 3]]), np.array([[1, 2, 3]]))
        self.assertIn("inside out", str(refused.exception))

    def test_second_order_tetrahedra_have_the_volume_of_their_maps(self):
        """A straight one's is that of its corners everywhere; one whose edge is bent through it is found, its corners say nothing."""
        halves = [(self.corners[a] + self.corners[b]) / 2 for a, b in EDGES]
        straight, element = np.vstack([self.corners, halves]), np.arange(10)[None]
        np.testing.assert_allclose(least_volumes(straight, element), 1 / 6)
        bent = straight.copy()
        bent[4] += [0, 0.45, 0.45]
        self.assertLess(least_volumes(bent, element)[0], 0)
        self.assertAlmostEqual(volumes(bent, element)[0], 1 / 6)

    def test_the_surface_is_found_and_on_the_body(self):
        mesh = onto_body(block(), self.corners.copy(), np.array([[0, 1, 2, 3]]), np.array([[3, 1, 2]]))
        self.assertEqual(mesh.faces.tolist(), [[0, 3]])
        np.testing.assert_allclose(block().gauge(block().to_body(mesh.nodes[1:])), 1, atol=1e-14)
        self.assertGreater(volumes(mesh.nodes, mesh.elements).min(), 0)


class Decks(unittest.TestCase):
    def deck(self, setting=calculix.Setting()):
        nodes = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [1e-17, -2e-5 / 3, 1 / 3]])
        mesh = Mesh(nodes, np.array([[0, 1, 2, 3]]), np.array([[0, 3]]))
        return calculix.deck_of([mesh, mesh], [np.zeros(3)] * 2, calculix.Zone(np.array([0.5, 0.5, 0]), 0.5, 0.7), setting)

    def test_no_field_is_longer_than_the_engine_reads(self):
        for line in self.deck().splitlines():
            if not line.startswith("*"):
                self.assertLessEqual(max(len(field.strip()) for field in line.split(",")), 20, line)

    def test_numbers_of_the_second_body_follow_the_first(self):
        self.assertIn("*ELEMENT, TYPE=C3D4, ELSET=BODY2\n2, 5, 6, 7, 8\n", self.deck())
        self.assertIn("*SURFACE, NAME=SKIN2, TYPE=ELEMENT\n2, S3\n", self.deck())

    def test_the_setting_is_in_it(self):
        deck = self.deck(calculix.Setting(penalty=100, increments=8, is_swapped=True, solver="SPOOLES"))
        self.assertIn("SURFACE TO SURFACE\nSKIN1, SKIN2\n", deck)
        self.assertIn("SOLVER=SPOOLES\n1.250000000000e-01, 1.,", deck)
        self.assertIn("OVERCLOSURE=LINEAR\n2.000000000000e+02\n", deck)


class Holding(unittest.TestCase):
    def test_the_far_half_is_beyond_the_centre(self):
        nodes = np.array([[0, 0, z] for z in (-1, -0.4, 0, 0.3, 1)], float)
        mesh = Mesh(nodes, np.zeros((0, 4), int), np.zeros((0, 2), int))
        held = [calculix.held_nodes(mesh, np.zeros(3), np.array([0, 0, 2.0]), part).tolist() for part in (0, 0.2, -0.2)]
        self.assertEqual(held, [[0, 1, 2], [0, 1, 2, 3], [0, 1]])


class Methods(unittest.TestCase):
    def case(self):
        spheroid = {"shape": {"superellipsoid": {"semi_axes": [1, 1, 2], "exponents": [2, 2]}}}
        poses = [([0, 0, 0], [1, 0, 0, 0]), ([0.3, 1.5, 1.2], [0.8, 0.6, 0, 0])]
        bodies = [spheroid | {"position": p, "orientation": {"quaternion_wxyz": q}} for p, q in poses]
        return {"format": "plumb/case-1", "bodies": bodies}

    def test_definitions_have_answers_with_points_as_they_ask(self):
        """GP: each point deepest in the other body; midway: as deep in one as in the other."""
        case = self.case()
        of = methods.answers([case])[0]
        self.assertEqual(set(of), {"auto", "original_cn", *methods.DEFINITIONS})
        first, second = methods.pair_of(case)
        x1, x2 = map(np.array, of["geometric_potential"]["points"])
        for on, other, point in ((first, second, x1), (second, first, x2)):
            self.assertAlmostEqual(on.gauge(on.to_body(point[None]))[0], 1, delta=1e-12)
            normals = [body.normals(point[None])[0] for body in (on, other)]
            self.assertLess(np.linalg.norm(np.cross(*normals)), 1e-9)
            self.assertLess(other.gauge(other.to_body(point[None]))[0], 1)
        middle = np.array(of["geometric_potential_midway"]["contact_point"])[None]
        self.assertAlmostEqual(first.gauge(first.to_body(middle))[0], second.gauge(second.to_body(middle))[0], delta=1e-12)

    def test_what_is_no_case_is_refused_with_the_commands_own_line(self):
        with self.assertRaisesRegex(methods.CommandFailure, "bodies"):
            methods.plumb(["solve", "-"], '{"format": "plumb/case-1"}')


class Bends(unittest.TestCase):
    def test_of_balls_are_the_sum_of_their_curvatures(self):
        pair = ball(), ball([0, 0, 1.5], 0.5)
        point, normal = np.array([0, 0, 1.0]), np.array([0, 0, 1.0])
        values = planes.curvatures(pair, normal, point, point + np.array([1e-3, 0, 0]), 0.01)
        np.testing.assert_allclose(values, 3, rtol=1e-3)

    def test_are_greater_towards_the_tip(self):
        """Of a spheroid on a ball, off its tip: the curvature grows along x towards it."""
        tilted = Body(np.array([1.0, 1.0, 2.0]), np.array([2.0, 2.0]), np.zeros(3), np.eye(3))
        point = tilted.of_sphere(np.array([[0.6, 0, 0.8]]))[0]
        normal = tilted.normals(point[None])[0]
        pair, along = (tilted, ball(point + 0.98 * normal)), np.array([normal[2], 0, -normal[0]])  # away from the tip
        away = planes.curvatures(pair, normal, point, point + 1e-3 * along, 0.1)
        self.assertGreater(away[0], 1.05 * away[2])
        np.testing.assert_allclose(planes.curvatures(pair, normal, point, point - 1e-3 * along, 0.1), away[::-1])


class Tables(unittest.TestCase):
    def answer(self, **fields):
        angles = {"auto": 0.1, "geometric_potential": 20.0}
        line = {"kind": "answer", "geometry": "G1", "ratio": 0.005, "angles_deg": angles, "cn_to_gp_deg": 20.0}
        return line | fields

    def test_a_force_off_the_common_normal_is_a_finding(self):
        self.assertEqual(tables.answer_findings(self.answer()), [])
        self.assertEqual(len(tables.answer_findings(self.answer(angles_deg={"auto": 0.2, "geometric_potential": 20}))), 1)
        self.assertEqual(tables.answer_findings(self.answer(ratio=0.02, angles_deg={"auto": 0.9, "geometric_potential": 20})), [])

    def test_a_geometric_potential_as_near_is_a_finding(self):
        near = self.answer(angles_deg={"auto": 0.1, "geometric_potential": 0.4})
        self.assertEqual(len(tables.answer_findings(near)), 1)
        self.assertEqual(tables.answer_findings(near | {"cn_to_gp_deg": 4}), [])

    def test_a_geometric_potential_without_an_answer_is_a_finding(self):
        self.assertEqual(tables.answer_findings(self.answer(cn_to_gp_deg=None)), ["GP has no answer"])

    def test_no_answer_is_a_finding(self):
        self.assertEqual(tables.answer_findings(self.answer(reason="ccx did not end")), ["ccx did not end"])

    def test_a_check_that_is_not_a_number_is_a_finding(self):
        check = {"kind": "check", "check": "hertz_force", "value": float("nan"), "limit": 0.02, "unit": "relative"}
        self.assertEqual(len(tables.findings([check])), 1)


class Geometries(unittest.TestCase):
    def test_are_those_that_are_drawn(self):
        with redirect_stdout(io.StringIO()) as out:
            draw.main()
        self.assertEqual(out.getvalue(), (FEM / "geometries.jsonl").read_text())

    def test_are_as_many_as_the_study_promises(self):
        cases = [json.loads(line) for line in (FEM / "geometries.jsonl").read_text().splitlines()]
        is_spheroid = [re.match("[GE]", case["name"]) is not None for case in cases]
        self.assertGreaterEqual(sum(is_spheroid), 12)
        self.assertGreaterEqual(len(cases) - sum(is_spheroid), 6)


if __name__ == "__main__":
    unittest.main()
