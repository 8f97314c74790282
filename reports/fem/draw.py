#!/usr/bin/python3
"""reports/fem/draw.py >geometries.jsonl: the geometries of the study, cases whose overlap ratio the study sets.

G1 to G4 are the groups of plumb report-study (results/study.txt). The others are drawn, each by itself, and none is left out
whatever it shows; axes, exponents and angles are rounded, so that they can be read.
"""

import json
import sys

try:
    import numpy as np
except ModuleNotFoundError:
    print(f"{sys.executable} has no numpy: install python3-numpy and call Debian's own /usr/bin/python3", file=sys.stderr)
    sys.exit(2)

SEED = 2018
# Name, aspect, exponents, line and Euler angles of body 2 in degrees; both bodies are alike.
GROUPS = [
    ("G1", 0.5, (2, 2), (35, 0), (0, 80, 0)),
    ("G2", 2.5, (2, 2), (10, 0), (0, 95, 0)),
    ("G3", 2.5, (2, 2), (15, 0), (0, 130, 0)),
    ("G4", 0.75, (2, 2), (75, 0), (0, 90, 0)),
    ("S1", 0.75, (2.5, 4), (40, 0), (0, 165, 55)),
    ("S2", 2.5, (3, 3), (75, 0), (0, 90, 30)),
    ("S3", 2, (2, 3), (75, 0), (0, 115, 10)),
    ("S4", 0.5, (3, 3), (85, 0), (0, 60, 40)),
]
ASPECTS = [(1.5, 1.5), (2, 2), (3, 3), (0.5, 0.5), (0.4, 0.4), (3, 0.4), (2, 0.7), (1.5, 2.5)]
EXPONENTS = [(3, 3), (4, 4), (5, 5), (6, 6), (3, 6), (6, 3)]


def body(axes, exponents, angles=None):
    out = {"shape": {"superellipsoid": {"semi_axes": list(axes), "exponents": list(exponents)}}}
    if angles is None:
        return out | {"position": [0, 0, 0], "orientation": {"quaternion_wxyz": [1, 0, 0, 0]}}
    return out | {"orientation": {"euler_zxz_deg": list(angles)}}


def case(name, bodies, line_deg):
    placement = {"line_deg": list(line_deg), "overlap_ratio": 0.01}
    return {"format": "plumb/case-1", "name": name, "bodies": bodies, "placement": placement}


def drawn_angles(random):
    """A line and Euler angles, uniform over directions and rotations, in whole degrees."""
    azimuths = random.uniform(0, 2 * np.pi, 3)
    zeniths = np.arccos(random.uniform(-1, 1, 2))
    line, phi, theta, psi = zeniths[0], azimuths[1], zeniths[1], azimuths[2]
    angles = np.degrees([line, azimuths[0], phi, theta, psi]).round().astype(int).tolist()
    return angles[:2], angles[2:]


def cases():
    for name, aspect, exponents, line, angles in GROUPS:
        axes = (1, 1, aspect)
        yield case(name, [body(axes, exponents), body(axes, exponents, angles)], line)
    random = np.random.default_rng(SEED)
    for number, aspects in enumerate(ASPECTS, start=1):
        line, angles = drawn_angles(random)
        yield case(f"E{number}", [body((1, 1, aspects[0]), (2, 2)), body((1, 1, aspects[1]), (2, 2), angles)], line)
    for number, exponents in enumerate(EXPONENTS, start=1):
        line, angles = drawn_angles(random)
        axes = np.round(random.uniform(0.5, 1, (2, 3)), 2).tolist()
        yield case(f"Q{number}", [body(axes[0], exponents), body(axes[1], exponents, angles)], line)


def main():
    for each in cases():
        print(json.dumps(each))


if __name__ == "__main__":
    main()
