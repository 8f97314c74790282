"""The suite of reports/verify: closed forms against published numbers and against each other, the table, and a few rows."""

import contextlib
import io
import math
import pathlib
import random
import shutil
import tempfile
import unittest
import unittest.mock

import numpy as np
from mpmath import mpf

import bodies
import exact
import impacts
import lammps
import ode
import resting
import rigid
import table
import verify
from scenes import Runner


class ClosedForms(unittest.TestCase):
    def test_of_two_balls_are_the_numbers_of_chung_and_ooi(self):
        for name, material, published in (("glass", impacts.GLASS, (274.113e-6, 10696.89, 40.3394e-6)),
                                          ("limestone", impacts.LIMESTONE, (368.304e-6, 7108.24, 54.2010e-6))):
            case = impacts.two_balls(name, material)
            for value, number in zip(case.exact.values(), published):
                self.assertAlmostEqual(float(value) / number, 1, delta=5e-6)

    def test_an_ellipse_that_is_almost_round_presses_as_a_circle(self):
        factor = exact.hertz_ellipse(mpf(3), mpf(2), mpf("2.0000001"))
        self.assertAlmostEqual(float(factor / exact.hertz_ball(mpf(3), 2)), 1, delta=1e-7)

    def test_a_body_that_tumbles_keeps_energy_and_momentum(self):
        free = exact.Tumbling((1, 2, 3), 0.6, 1)
        for time in (0.3, 1.7, 40):
            spin = free.spin(time)
            self.assertAlmostEqual(sum(i * w * w for i, w in zip(free.moments, spin)), mpf("3.36"), places=15)
            self.assertAlmostEqual(sum((i * w) ** 2 for i, w in zip(free.moments, spin)), free.momentum ** 2, places=15)

    def test_of_an_ellipsoid_moments_are_the_textbooks(self):
        mass, moments = rigid.mass_and_moments((1, 2, 3), (2, 2))
        self.assertAlmostEqual(mass, 8 * exact.pi, places=20)
        self.assertAlmostEqual(moments[0], mass * 13 / 5, places=20)

    def test_farthest_points_are_on_the_surface_and_farthest(self):
        draw = random.Random(1)
        for _ in range(20):
            axes, exponents, _ = bodies.drawn(draw, superquadric=True)
            n1, n2 = exponents
            direction = bodies.unit(draw)
            point = rigid.support(axes, exponents, direction)
            scaled = np.abs(point) / axes
            self.assertAlmostEqual((scaled[0] ** n2 + scaled[1] ** n2) ** (n1 / n2) + scaled[2] ** n1, 1, places=12)
            for other in (rigid.support(axes, exponents, bodies.unit(draw)) for _ in range(50)):
                self.assertLessEqual(other @ direction, point @ direction + 1e-12)

    def test_a_ball_that_slides_all_along_is_slowed_by_the_coefficient(self):
        normal, approach = np.array([0, 0, -1.0]), np.array([3.0, 0, -1])
        mobility = np.eye(3) + 2.5 * (np.eye(3) - np.outer(normal, normal))
        impulse = ode.frictional(mobility, approach, normal, 1.0, 0.2)
        np.testing.assert_allclose(impulse, (-0.4, 0, 2), atol=1e-6)

    def test_without_friction_the_impulse_is_that_of_rigid_bodies(self):
        body = rigid.Rigid((1, 0.8, 0.6), (2, 2), np.eye(3))
        normal, arm = np.array([0, 0, -1.0]), np.array([0.3, 0.2, -0.5])
        impulse = ode.frictional(body.mobility(arm), np.array([0.4, 0, -1]), normal, 0.6, 0.0)
        np.testing.assert_allclose(impulse, (0, 0, rigid.impulse(0.6, 1, body.yields(arm, normal))), atol=1e-6)


class Table(unittest.TestCase):
    def test_nothing_holds_without_its_number(self):
        row = table.Row("t", "s", "q", 2.0, [math.nan], 2.0, 1e-3)
        self.assertFalse(row.holds)
        self.assertIn("off", table.line(row))

    def test_the_order_is_that_of_the_time_step(self):
        row = table.Row("t", "s", "q", 1.0, [1.01, 1.001, 1.0001], 1.0, 1e-3)
        self.assertAlmostEqual(row.order((1e-2, 1e-3, 1e-4)), 2, places=9)
        self.assertTrue(row.holds)

    def test_the_worst_of_a_set_is_one_that_failed(self):
        good, failed = (table.Row("t", "s", "q", 1.0, [x], 1.0, 1e-3) for x in (1.5, math.nan))
        self.assertIs(verify.worst([good, failed]), failed)


class Suite(unittest.TestCase):
    def test_a_few_rows_hold(self):
        with tempfile.TemporaryDirectory() as folder:
            runner = Runner(pathlib.Path(folder))
            groups = [impacts.two_balls("glass", impacts.GLASS), impacts.on_plane("aluminium", impacts.ALUMINIUM),
                      bodies.a_set("another", bodies.on_another, True, 0.6, bodies.FRICTION, 2)]
            rows = list(verify.rows(runner, groups, (1e-2, 1e-4)))
        self.assertEqual(len(rows), 9)
        for row in rows:
            self.assertTrue(row.holds, table.line(row))
        for row in rows[:6]:
            self.assertGreater(row.order((1e-2, 1e-4)), 1, table.line(row))

    def test_a_program_that_fails_is_off_with_its_reason(self):
        with tempfile.TemporaryDirectory() as folder:
            case = impacts.two_balls("glass", impacts.GLASS)
            rows = list(verify.rows(Runner(pathlib.Path(folder), "/bin/false"), [case], (1e-2,)))
        self.assertFalse(any(row.holds for row in rows))
        self.assertIn("exit code 1", table.line(rows[0]))

    def test_what_is_not_there_is_said(self):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stderr(io.StringIO()) as said:
            self.assertEqual(verify.main(["--only", "nothing of this name", "--out", folder]), 2)
        self.assertIn("there is no such test", said.getvalue())

    def test_a_part_is_not_recorded(self):
        for part in (["--only", "rolls"], ["--quick"], ["--accuracy", "1e-2"]):
            with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stderr(io.StringIO()) as said:
                self.assertEqual(verify.main(["--record", "--out", folder, *part]), 2)
            self.assertEqual(said.getvalue(), "--record: takes all tests: leave --only, --quick and --accuracy out\n")


class ThroughLammps(unittest.TestCase):
    def frame(self, **changed):
        names = ("x", "y", "z", *lammps.TURNS[0], *lammps.TURNS[1], *lammps.DIAMETERS, "vx", "vy", "vz", *lammps.MOMENTA[0], *lammps.MOMENTA[1])
        return {"columns": {name: np.array([changed.get(name, 2.0)]) for name in names}}

    def test_any_part_of_a_state_counts(self):
        self.assertEqual(lammps.deviation(self.frame(), self.frame()), 0)
        for name in ("z", "c_body[4]", "vx", "c_body[9]"):
            self.assertGreaterEqual(lammps.deviation(self.frame(), self.frame(**{name: 2.5})), 0.25, name)

    def test_a_run_that_failed_is_off_and_a_refused_one_is_not(self):
        failed = lammps.Row("t", {1: 0.0, 2: math.nan}, 1, failed="lost atoms")
        self.assertFalse(failed.holds)
        self.assertIn("off   lost atoms", lammps.line(failed))
        self.assertTrue(lammps.Row("t", {1: 0.0}, 1, refused="no heat").holds)

    def test_where_the_scene_fails_lammps_is_off_too(self):
        with tempfile.TemporaryDirectory() as folder:
            found = lammps.rows(Runner(pathlib.Path(folder), "/bin/false"), [resting.drag()], 1e-2, (1, 2))
        self.assertFalse(found[0].holds)
        self.assertIn("off   exit code 1", lammps.line(found[0]))

    def test_no_process_is_refused(self):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stderr(io.StringIO()) as said:
            self.assertEqual(verify.main(["--ranks", "0", "--out", folder]), 2)
        self.assertEqual(said.getvalue(), "--ranks: at least 1\n")

    def test_without_lammps_it_is_said(self):
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stderr(io.StringIO()) as said:
            with unittest.mock.patch.dict("os.environ", {"PLUMB_SCENE": folder + "/plumb-scene"}):
                self.assertEqual(verify.main(["--ranks", "1", "--out", folder]), 2)
        self.assertRegex(said.getvalue(), "^--ranks: .*plumb-lammps: is not built: .*\n$")

    @unittest.skipUnless(lammps.Lammps().program.exists() and shutil.which("mpirun"), "LAMMPS is not there")
    def test_the_same_scenes_end_the_same(self):
        groups = [impacts.oblique("aluminium oxide", impacts.OXIDE, 45), resting.drag(), resting.heat()]
        with tempfile.TemporaryDirectory() as folder:
            found = lammps.rows(Runner(pathlib.Path(folder)), groups, 1e-2, (1, 2))
        self.assertEqual([row.largest for row in found[:2]], [{1: 0.0, 2: 0.0}] * 2, lammps.text(found, 1e-2))
        self.assertIn("temperatures", found[2].refused)


if __name__ == "__main__":
    unittest.main()
