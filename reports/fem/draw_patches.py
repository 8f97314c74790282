#!/usr/bin/python3
"""reports/fem/draw_patches.py >patches.jsonl: faces on faces and edges on faces, cases whose overlap ratio the study sets.

Exponents are listed; semi-axes, offsets, tilts and turns are drawn, each geometry by itself, and none is left out whatever it shows. They are
rounded, so that they can be read. "control" lies face on face without offset or tilt: its force is known by symmetry.
"""

import json

import numpy as np

from draw import body, case

SEED = 34
# Name and exponents n1, n2 of body 1 and of body 2.
FACES = [
    ("face6", (6, 6), (6, 6)),
    ("face8", (8, 8), (8, 8)),
    ("face12", (12, 12), (12, 12)),
    ("face6-12", (6, 6), (12, 12)),
    ("face10-7", (10, 7), (7, 10)),
    ("face8-9", (8, 12), (9, 6)),
]
EDGES = [
    ("edge6", (6, 6), (6, 6)),
    ("edge8", (8, 8), (8, 8)),
    ("edge12", (12, 12), (12, 12)),
    ("edge8-12", (8, 8), (12, 12)),
]
ON_ITS_EDGE_DEG = 45  # a turn about body 2's x axis
LEAST_AXIS = 0.6
OFFSET_DEG = (3, 12)  # of the line of the centres from body 1's z axis
FACE_TILT_DEG = (0.1, 0.6)  # between the faces
EDGE_TURN_DEG = (0.1, 1)  # of body 2 about its z axis: its edge leaves the face by sin 45 degrees times that


def drawn(random, exponents, lean_deg, turn_deg):
    """Semi-axes, the line of the centres and Euler angles."""
    axes = np.round(random.uniform(LEAST_AXIS, 1, (2, 3)), 2).tolist()
    line = np.round([random.uniform(*OFFSET_DEG), random.uniform(0, 360)], 1).tolist()
    angles = [int(random.integers(360)), round(float(lean_deg(random)), 2), round(float(turn_deg(random)), 2)]
    return [body(axes[0], exponents[0]), body(axes[1], exponents[1], angles)], line


def cases():
    yield case("control", [body((0.8, 0.8, 0.8), (8, 8)), body((0.8, 0.8, 0.8), (8, 8), (0, 0, 0))], (0, 0))
    random = np.random.default_rng(SEED)
    for name, *exponents in FACES:
        yield case(name, *drawn(random, exponents, lambda r: r.uniform(*FACE_TILT_DEG), lambda r: r.integers(360)))
    for name, *exponents in EDGES:
        yield case(name, *drawn(random, exponents, lambda r: ON_ITS_EDGE_DEG, lambda r: r.uniform(*EDGE_TURN_DEG)))


if __name__ == "__main__":
    for each in cases():
        print(json.dumps(each))
