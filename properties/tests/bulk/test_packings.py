"""The packings' shapes are what they say, their scenes start apart, and a short run ends in a row of the table."""

import contextlib
import io
import itertools
import math
import pathlib
import random
import tempfile
import unittest
from unittest import mock

import packings
from shapes import SHAPES


def share_inside(shape, points):
    """Of a box around it, by points drawn in it."""
    draw = random.Random(1)
    inside = sum(sum(abs(draw.uniform(-1, 1)) ** shape.exponent for _ in range(3)) <= 1 for _ in range(points))
    return inside / points


class Shapes(unittest.TestCase):
    def test_all_have_the_volume_of_the_ball(self):
        for shape in SHAPES:
            a, b, c = shape.semi_axes()
            self.assertAlmostEqual(8 * a * b * c * share_inside(shape, 20000), math.pi / 6, delta=0.01, msg=shape.name)

    def test_the_ball_has_diameter_one(self):
        self.assertAlmostEqual(SHAPES[0].semi_axes()[0], 0.5, places=12)
        self.assertAlmostEqual(SHAPES[0].radius(), 0.5, places=12)


class Scenes(unittest.TestCase):
    def test_bodies_start_apart_in_every_image(self):
        for shape in SHAPES:
            scene = packings.scene_of(shape, 30, 2, packings.PROTOCOLS["damped"])
            side = scene["effects"]["periodic_box"]["sides"][0]
            for one, other in itertools.combinations(scene["bodies"], 2):
                apart = [(x - y + side / 2) % side - side / 2 for x, y in zip(one["position"], other["position"])]
                self.assertGreater(math.hypot(*apart), 2 * shape.radius(), shape.name)

    def test_seeds_differ_and_are_kept(self):
        damped, cooled = packings.PROTOCOLS.values()
        self.assertEqual(packings.scene_of(SHAPES[1], 30, 1, damped), packings.scene_of(SHAPES[1], 30, 1, damped))
        self.assertNotEqual(packings.scene_of(SHAPES[1], 30, 1, damped), packings.scene_of(SHAPES[1], 30, 2, damped))
        self.assertNotEqual(packings.scene_of(SHAPES[1], 30, 1, damped), packings.scene_of(SHAPES[1], 30, 1, cooled))


class Study(unittest.TestCase):
    def main(self, folder, *arguments):
        said = io.StringIO()
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(io.StringIO()):
            code = packings.main(["--shapes", "ball", "--bodies", "30", "--out", folder, *arguments])
        return code, said.getvalue()

    @mock.patch.object(packings, "PROTOCOLS", {"damped": packings.Protocol(2, 0.02, 0.5), "cooled": packings.Protocol(1, 5e-4, 0.99)})
    def test_a_run_is_a_row_and_is_not_run_twice(self):
        with tempfile.TemporaryDirectory() as folder:
            code, table = self.main(folder, "--seeds", "2")
            self.assertEqual(code, 0)
            ended = pathlib.Path(folder, "ball-30-damped-1", "bulk.jsonl")
            before = ended.stat().st_mtime_ns
            self.assertEqual(self.main(folder, "--seeds", "2"), (0, table))
            self.assertEqual(ended.stat().st_mtime_ns, before)
        self.assertRegex(table, r"\nball +damped +0\.\d{4} \+- 0\.\d{4} .*0\.64")
        self.assertRegex(table, r"\nball +cooled +0\.\d{4} \+- 0\.\d{4} .*0\.64")
        self.assertIn("\ncommand reports/bulk/run packings --shapes ball --bodies 30 --seeds 2\n", table)


if __name__ == "__main__":
    unittest.main()
