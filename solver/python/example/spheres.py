"""A whole solver for plumb's process door: right for spheres, and it says that it knows nothing else.

    plumb campaign --family ellipsoid --cases 1000 --seed 1 --solver-command 'python3 solver/python/example/spheres.py' --out DIR
"""

import math
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from plumb_solver import serve  # noqa: E402


def is_sphere(body):
    return body.exponents == (2, 2) and len(set(body.semi_axes)) == 1


def solve(pair):
    one, two = pair.bodies
    distance = math.hypot(*two.position)  # body 1 is at the origin
    if not (is_sphere(one) and is_sphere(two)) or distance == 0:
        return None  # refused; of spheres about one point no direction is better than another
    radius1, radius2 = one.semi_axes[0], two.semi_axes[0]
    normal = [v / distance for v in two.position]
    points = [radius1 * n for n in normal], [p - radius2 * n for p, n in zip(two.position, normal)]
    return pair.answer(radius1 + radius2 - distance, normal, points)


serve(solve, {"name": "spheres.py", "version": "1", "licence": "BSD-3-Clause", "shapes": "spheres"})
