"""The drum of the case study starts without overlaps, its model predicts what it was made from, and a short run ends in a table."""

import contextlib
import io
import itertools
import math
import os
import pathlib
import shutil
import tempfile
import unittest
from unittest import mock

import case_study
import cost
import drum

LOG = """  ghost atom cutoff = 0.012
Loop time of {seconds} on {ranks} procs for 200 steps with {bodies} atoms
Nghost:        {ghosts} ave         510 max         490 min
Maximum resident set size: {memory} Mbyte
"""


def run_of(bodies, ranks, seconds, ghosts, memory):
    return cost.read(LOG.format(bodies=bodies, ranks=ranks, seconds=seconds, ghosts=ghosts, memory=memory))


class Drum(unittest.TestCase):
    def test_the_stack_is_within_the_drum_and_bodies_within_their_boxes(self):
        radius, half_length = drum.drum(500)
        bodies = drum.scene(500, 1.0)["bodies"]
        self.assertEqual(len(bodies), 500)
        for body in bodies:
            (x, y, z), (a, b, c) = body["position"], body["shape"]["superellipsoid"]["semi_axes"]
            self.assertLessEqual(math.hypot(abs(x) + a, abs(z) + c), radius)
            self.assertLessEqual(abs(y) + b, half_length)
        for one, other in itertools.combinations(bodies, 2):
            gaps = [abs(p - q) - a - b for p, q, a, b in zip(one["position"], other["position"], one["shape"]["superellipsoid"]["semi_axes"],
                                                             other["shape"]["superellipsoid"]["semi_axes"])]
            self.assertGreater(max(gaps), 0)


class Model(unittest.TestCase):
    runs = (run_of(20000, 1, 20, 0, 230), run_of(20000, 2, 11, 500, 140), run_of(2000, 1, 2, 0, 50))

    def test_it_gives_back_what_it_was_made_from(self):
        one, two, small = self.runs
        model = cost.fitted(one, two, small, 5e-7)
        for run in (one, two):
            self.assertAlmostEqual(model.step(run.bodies, run.ranks, run.ghosts) / run.step, 1, places=12)
        for run in (one, small):
            self.assertAlmostEqual(model.mbyte(run.bodies, run.ranks, run.ghosts), run.memory, places=9)

    def test_ghosts_are_what_a_cube_has_around_it(self):
        model = cost.fitted(*self.runs, 1e-6)
        self.assertAlmostEqual(model.ghosts(8000, 8), ((0.1 + 0.024) ** 3 - 0.1 ** 3) / 1e-6, places=6)
        self.assertEqual(model.ghosts(8000, 1), 0)

    def test_a_lattice_has_the_cell_of_its_places(self):
        places = [(x * 0.01, y * 0.01, z * 0.01) for x, y, z in itertools.product(range(12), repeat=3)]
        self.assertAlmostEqual(cost.cell_inside(places, 0.042) / 1e-6, 1, delta=0.1)

    def test_a_log_without_a_number_is_not_read(self):
        with self.assertRaisesRegex(ValueError, "the log has no memory"):
            cost.read(LOG.format(seconds=1, ranks=1, bodies=9, ghosts=0, memory=1).rsplit("Maximum", 1)[0])


class Suite(unittest.TestCase):
    def main(self, *arguments):
        said = io.StringIO()
        with tempfile.TemporaryDirectory() as folder, contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            code = case_study.main(["--out", folder, *arguments])
        return code, said.getvalue()

    @unittest.skipUnless((pathlib.Path(os.environ["PLUMB_PROGRAMS"]) / "plumb-lammps").exists() and shutil.which("mpirun"), "LAMMPS is not there")
    def test_a_short_run_ends_in_a_table(self):
        with mock.patch.multiple(case_study, MEASURED=10, ROUNDS=1):
            code, said = self.main("--bodies", "120", "60", "--duration", "0.04")
        self.assertEqual(code, 0, said)
        self.assertRegex(said, r"\nheld +60 +2 ")
        self.assertRegex(said, r"\n 1000000 +512 ")

    @unittest.skipUnless((pathlib.Path(os.environ["PLUMB_PROGRAMS"]) / "plumb-lammps").exists() and shutil.which("mpirun"), "LAMMPS is not there")
    def test_a_run_is_kept_and_another_or_half_a_run_is_not(self):
        lammps = case_study.Lammps(pathlib.Path(os.environ["PLUMB_PROGRAMS"]) / "plumb-scene")
        with tempfile.TemporaryDirectory() as place, mock.patch.multiple(case_study, MEASURED=2, ROUNDS=1):
            folder = pathlib.Path(place) / "60"
            folder.mkdir()  # as a run that was interrupted leaves it
            for duration, is_new in ((0.01, True), (0.01, False), (0.02, True)):
                was = (folder / "log.run").stat().st_mtime_ns if (folder / "log.run").exists() else 0
                case_study.measured(lammps, folder, 60, duration)
                self.assertEqual((folder / "log.run").stat().st_mtime_ns != was, is_new)

    def test_a_program_that_fails_is_said(self):
        with mock.patch.dict("os.environ", {"PLUMB_PROGRAMS": "/nowhere"}):
            code, said = self.main()
        self.assertEqual((code, said), (1, "/nowhere/plumb-export-lammps: is not there\n"))

    def test_nothing_is_refused(self):
        self.assertEqual(self.main("--bodies", "0", "10"), (2, "--bodies and --duration: above 0\n"))

    def test_a_part_is_not_recorded(self):
        self.assertEqual(self.main("--record", "--duration", "0.1"),
                         (2, "--record: takes the case as it is: leave --bodies and --duration out\n"))


if __name__ == "__main__":
    unittest.main()
