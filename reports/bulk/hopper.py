"""Spheroids run out of a flat-bottomed hopper: how fast, and how steep what is left lies, by aspect.

The hopper is a slice: smooth walls in front and behind, rough ones at both sides. Its floor has a slit across the middle, and fixed balls on it, for on a
plane balls roll for ever. Bodies of one volume rain in while the slit is shut. Then it is open: they run out, and two heaps are left."""

import math
import random
import sys

import numpy as np

import runs
from scenes import body, frames_in

ASPECTS = (0.5, 0.7, 1.0, 1.5, 2.0)  # of the axis of revolution over the others
DIAMETER, DENSITY = 0.01, 2500.0     # of the ball of the same volume, m; kg/m^3
WIDTH, DEPTH, SLIT = 25, 5, 5        # in diameters
FILLING, RUNNING = 0.8, 2.5          # s
FRAME = 0.02                         # s


def spheroid(aspect):
    radius = DIAMETER / 2
    return [radius * aspect ** (-1 / 3)] * 2 + [radius * aspect ** (2 / 3)]


def floor(is_open):
    """z = 0: two rectangles with the slit between them, or without it."""
    edge, side, deep = (SLIT / 2 if is_open else 0) * DIAMETER, WIDTH * DIAMETER, DEPTH * DIAMETER
    triangles = []
    for sign in (-1, 1):
        a, b, c, d = [[sign * edge, -deep, 0], [sign * side, -deep, 0], [sign * side, deep, 0], [sign * edge, deep, 0]]
        triangles += [[a, b, c], [a, c, d]]
    return {"mesh": {"triangles": triangles}, "material": "grain"}


def walls(is_open):
    half, deep = WIDTH / 2 * DIAMETER, DEPTH / 2 * DIAMETER
    planes = [{"point": [-sign * half, 0, 0], "normal": [sign, 0, 0], "material": "grain"} for sign in (1, -1)]
    planes += [{"point": [0, -sign * deep, 0], "normal": [0, sign, 0], "material": "glass"} for sign in (1, -1)]
    return [floor(is_open), *planes]


def bumps():
    """Half-buried balls all over the floor but the slit."""
    return [body(spheroid(1), (2, 2), (sign * (SLIT / 2 + 0.5 + i) * DIAMETER, (j + 0.5 - DEPTH / 2) * DIAMETER, 0), fixed=True)
            for sign in (-1, 1) for i in range((WIDTH - SLIT) // 2) for j in range(DEPTH)]


def scene(bodies, is_open):
    grain = {"density": DENSITY, "linear": {"stiffness": 1000}, "damping": {"restitution": 0.4}, "friction": {"coefficient": 0.5}}
    smooth = {"coefficient": 0}
    return {"format": "plumb/scene-1", "name": "hopper", "bodies": [{**one, "material": "grain"} for one in bumps() + bodies], "walls": walls(is_open),
            "materials": {"grain": grain, "glass": {**grain, "friction": smooth}, "pairs": [{"between": ["grain", "glass"], "friction": smooth}]},
            "effects": {"gravity": {"acceleration": [0, 0, -9.81]}},
            "run": {"duration": RUNNING if is_open else FILLING, "accuracy": 1e-2, "outputs": {"every": FRAME, "write": ["dump"]}}}


def rained(aspect, bodies, seed):
    """A lattice whose bodies turn any way and cannot touch."""
    draw = random.Random(seed)
    pitch = 2.02 * max(spheroid(aspect))
    across, along = int(WIDTH * DIAMETER / pitch), int(DEPTH * DIAMETER / pitch)
    out = []
    for i in range(bodies):
        x, y, z = i % across, i // across % along, i // (across * along)
        place = ((x - (across - 1) / 2) * pitch, (y - (along - 1) / 2) * pitch, (z + 0.5) * pitch + DIAMETER / 2)
        velocity = (draw.gauss(0, 0.05), draw.gauss(0, 0.05), -0.5)
        out.append(body(spheroid(aspect), (2, 2), place, velocity, quaternion=[draw.gauss(0, 1) for _ in range(4)]))
    return out


def columns(frame, *names):
    """Of the bodies that can move, a row each."""
    return np.stack([frame["columns"][name][len(bumps()):] for name in names], axis=1)


def frames_of(folder):
    return list(frames_in((folder / "dump.lammpstrj").read_text()))


def outflow(gone):
    """Bodies a second, while from a fifth to three fifths of all that leave do so. `gone`: how many have, by frame."""
    steady = np.flatnonzero((0.2 * gone[-1] <= gone) & (gone <= 0.6 * gone[-1]))
    if len(steady) < 2:
        return math.nan
    first, last = steady[0], steady[-1]
    return (gone[last] - gone[first]) / ((last - first) * FRAME)


def slope_deg(places):
    """Of a line through the highest centres of each strip of a diameter, both heaps over one another; without the strips at wall and slit."""
    highest = {}
    for x, z in places:
        strip = int(abs(x) / DIAMETER)
        if z > 0 and SLIT / 2 + 1 <= strip <= WIDTH / 2 - 2:
            highest[strip, x > 0] = max(z, highest.get((strip, x > 0), 0))
    if len(highest) < 4:
        return math.nan
    rise, _ = np.polyfit([(strip + 0.5) * DIAMETER for strip, _ in highest], list(highest.values()), 1)
    return math.degrees(math.atan(rise))


def emptied(aspect, bodies, seed, out):
    name = f"{aspect:g}-{bodies}-{seed}"
    filled = frames_of(runs.kept(out / f"{name}-filled", scene(rained(aspect, bodies, seed), False)))[-1]
    start = [body(spheroid(aspect), (2, 2), row[:3], quaternion=row[3:]) for row in columns(filled, "x", "y", "z", "quatw", "quati", "quatj", "quatk").tolist()]
    frames = frames_of(runs.kept(out / f"{name}-open", scene(start, True)))
    places, stays = columns(frames[-1], "x", "z"), columns(frames[-1], "z")[:, 0] > 0
    speeds = np.linalg.norm(columns(frames[-1], "vx", "vy", "vz")[stays], axis=1)
    return {"rate": outflow(np.array([np.sum(columns(frame, "z") < 0) for frame in frames])), "slope": slope_deg(places), "left": 100 * stays.mean(),
            "moving": 100 * np.mean(speeds > 0.01)}


HEAD = f"{'aspect':>6}  {'outflow, bodies/s':<18} {'slope, deg':<14} {'left, %':<14} {'moving, %':>9}"


def row_of(aspect, ends):
    def of(name, digits):
        return runs.text_of([end[name] for end in ends], digits)
    return f"{aspect:6g}  {of('rate', 0):<18} {of('slope', 1):<14} {of('left', 1):<14} {max(end['moving'] for end in ends):9.1f}"


def main(arguments=None):
    parser = runs.options("hopper", __doc__.splitlines()[0], 1200, 5)
    parser.add_argument("--aspects", type=float, nargs="+", default=ASPECTS)
    asked = parser.parse_args(arguments)
    if min(asked.aspects) <= 0.2 or max(asked.aspects) >= 5:
        print("--aspects: between 0.2 and 5", file=sys.stderr)
        return 2
    asked.command = f"reports/bulk/run hopper --aspects {' '.join(f'{aspect:g}' for aspect in asked.aspects)} --bodies {asked.bodies} --seeds {asked.seeds}"
    return runs.study(asked, HEAD, asked.aspects, lambda aspect, seed: emptied(aspect, asked.bodies, seed, asked.out), row_of)


if __name__ == "__main__":
    sys.exit(main())
