"""What the study makes of its calculations, without an engine: what is judged, checked, kept and told."""

import pathlib
import tempfile
import unittest
from unittest import mock

import numpy as np

import calculix
import checks
import contact
import study
import tables
import tasks
from superellipsoid import Body


def pushed(force, at):
    """A calculation that ended with `force` on body 2 along a line through `at`."""
    forces, moments = np.array([-force, force]), np.array([-np.cross(at, force), np.cross(at, force)])
    return calculix.Result(forces, moments, force, np.array([1.0, 0, 0]), area=np.pi, iterations=1, nodes=1)


class Judging(unittest.TestCase):
    def test_the_centre_is_on_the_line_of_action_by_the_patch(self):
        result = pushed(np.array([0.0, 0, 2]), np.array([1.5, 0, -7]))
        np.testing.assert_allclose(contact.pressure_centre(result), [1.5, 0, 0])
        judged = contact.judged(result, {"auto": {"normal": [0, 0, 1], "contact_point": [1, 0, 5.5]}}, radius=0.25)
        self.assertEqual((judged["force"], judged["balance"], judged["lines_apart"]), (2, 0, 0))
        self.assertAlmostEqual(judged["centre_off"]["auto"], 2)
        self.assertAlmostEqual(judged["fem_patch_radius"], 1)


class Checks(unittest.TestCase):
    def test_without_hertz_there_is_no_study(self):
        with self.assertRaisesRegex(checks.NoCheck, "Hertz: ccx did not end"):
            list(checks.hertz(None, {"reason": "ccx did not end"}, "Hertz", (0.02, 0.01, 0.1)))

    def test_planes_that_end_apart_are_beyond_the_limit(self):
        ends = [{"direction": [0, 0, 1], "fem_deg": 0.1}, {"direction": [0, 1e-3, 1]}, {"reason": "not settled"}]
        spread, to_fem = checks.half_spaces([{"planes": ends}])
        self.assertGreater(spread[1], spread[2])
        self.assertEqual(to_fem[1], 0.1)

    def test_the_worst_is_no_number_where_one_is_none(self):
        (of,) = checks.variations([{"turned_deg": 0.1}, {"turned_deg": float("nan")}])
        self.assertFalse(of[1] <= of[2])


class Keeping(unittest.TestCase):
    def test_what_is_kept_is_not_made_again_and_what_is_broken_is(self):
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
                for text, runs in ((None, 1), (None, 1), ("{", 2), ("null", 3), ('{"forces": 1}', 4), (None, 4)):
                    for path in (out / "kept").iterdir():
                        path.write_text(text or path.read_text())
                    self.assertEqual(tasks._result(task, None, None, out, "ccx").nodes, 1)
                    self.assertEqual(run.call_count, runs)

    def test_a_folder_is_one_runs_at_a_time(self):
        with tempfile.TemporaryDirectory() as folder, tasks.alone_in(pathlib.Path(folder)):
            with self.assertRaisesRegex(tasks.Busy, "another run is writing there"):
                tasks.run_all([], folder, "ccx", 1, print)


class Lens(unittest.TestCase):
    def test_of_two_balls_is_a_circle_and_hertzs_patch_half_of_it(self):
        pair = [Body(np.ones(3), np.array([2.0, 2.0]), np.array([0, 0, z]), np.eye(3)) for z in (0.0, 1.98)]
        lens = contact.Lens.of(pair, {"normal": [0, 0, 1.0], "contact_point": [0, 0, 0.99]})
        square = 1 - 0.99**2  # of the radius of the circle in which the balls meet
        self.assertAlmostEqual(lens.area / (np.pi * square), 1, delta=0.01)
        self.assertAlmostEqual(lens.patch_radius() / np.sqrt(square / 2), 1, delta=0.005)


class Labels(unittest.TestCase):
    def label(self, semi_axes, exponents):
        body = {"shape": {"superellipsoid": {"semi_axes": semi_axes, "exponents": exponents}},
                "orientation": {"quaternion_wxyz": [1, 0, 0, 0]}}  # fmt: skip
        return study.geometry_line({"name": "G1", "placement": {"line_deg": [0, 0]}}, {"bodies": [body, body]})["shape"]

    def test_are_of_shape(self):
        self.assertEqual(self.label([2, 1, 1], [2, 2]), "spheroid")
        self.assertEqual(self.label([3, 2, 1], [2, 2]), "ellipsoid")
        self.assertEqual(self.label([1, 1, 2], [2, 3]), "superquadric")


class Plan(unittest.TestCase):
    """Without asking plumb for any answer."""

    def study(self, ratios, mode):
        def asked(geometries, ratios):
            return [(g["name"], ratio, {}, {}) for g in geometries for ratio in ratios]

        with mock.patch.object(study, "asked", asked):
            return study.Study([{"name": name} for name in ("G1", "G3", "Q3", "S4")], ratios, mode)

    def test_settings_are_varied_at_a_ratio_of_the_study(self):
        for mode, ratios in study.RATIOS.items():
            varied = self.study(ratios, mode).varied
            self.assertEqual({base.geometry for base, *_ in varied}, set(study.VARIED_AT))
            self.assertEqual(len({base.ratio for base, *_ in varied}), 1)

    def test_full_mode_varies_what_the_direction_could_hang_on(self):
        varied = {what for _, what, *_ in self.study(study.RATIOS["full"], "full").varied}
        self.assertEqual(varied, {"swap", "held", "mesh", "order", "penalty", "increments", "solver"})

    def test_half_spaces_are_asked_at_small_overlaps_and_of_the_bent_one_at_all(self):
        asked = {(t.geometry, t.ratio) for t in self.study((0.005, 0.02), "quick").answered if t.has_planes}
        self.assertEqual(asked, {(name, 0.005) for name in ("G1", "G3", "Q3", "S4")} | {("S4", 0.02)})


class Medians(unittest.TestCase):
    def rows(self, *angles):
        lines = [{"ratio": 0.01, "angles_deg": of, "centre_off": {name: 0.5 for name in of}} for of in angles]
        return [line.split() for line in tables.medians(lines)][3:]

    def test_what_settings_may_turn_is_neither_nearer_nor_further(self):
        near, far = tables.SETTINGS_DEG * 0.9, tables.SETTINGS_DEG * 1.1
        rows = self.rows({"auto": 1, "geometric_potential": 1 + far}, {"auto": 1, "geometric_potential": 1 - near},
                         {"auto": 1, "geometric_potential": 1 - far}, {"auto": 1})  # fmt: skip
        self.assertEqual(rows[0], ["0.01", "CN", "4", "1", "0.5", "0", "0"])
        self.assertEqual(rows[1][:3] + rows[1][5:], ["0.01", "GP", "3", "1", "1"])
        self.assertEqual(rows[2][2:], ["0", "-", "-", "-", "-"])


if __name__ == "__main__":
    unittest.main()
