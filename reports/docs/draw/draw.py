#!/usr/bin/env python3
"""draw.py [--check] [--plumb PROGRAM]: the pictures of README.md and of the pages, as SVG in reports/docs/pictures.

The first one solves misaligned.json, so that it shows what plumb says. --check writes nothing: exit 1 where a picture is not what
this program draws.
"""
import argparse
import json
import subprocess
import sys
from pathlib import Path

sys.dont_write_bytecode = True
import contacts  # noqa: E402
import measured
import patch
import plans
import search
import terms
from shapes import degrees_between, dot, minus, plus, silhouette, times, unit
from svg import BODY1, BODY2, RIGHT, WRONG, Picture

PICTURES = Path(__file__).resolve().parents[1] / "pictures"
CASE = PICTURES / "misaligned.json"


def said(plumb, *arguments):
    return json.loads(subprocess.run([plumb, *arguments, "--json"], capture_output=True, text=True, check=True).stdout)


def certified(plumb):
    """The common normal, and the overlap that no direction is below."""
    proof = said(plumb, "certify", CASE)
    if proof["global"] != "proved":
        sys.exit(f"{CASE}: not proved, and so no truth to draw")
    numbers = lambda texts: [float(text) for text in texts]
    return {"normal": numbers(proof["normal"]), "points": [numbers(point) for point in proof["points"]], "overlap": float(proof["overlap"]["lower"])}


def plane_of(right, wrong):
    """Two axes of the plane that holds both normals; the first is the world's x as nearly as may be."""
    first = unit(minus(wrong, times(dot(wrong, right), right)))
    x, y = dot((1, 0, 0), right), dot((1, 0, 0), first)
    e1 = unit(plus(times(x, right), times(y, first)))
    return e1, unit(minus(right, times(dot(right, e1), e1)))


def draw_answer(picture, seen, answer, colour, reach):
    """Both points, the line through them, and the outward normals there."""
    p1, p2 = (seen(point) for point in answer["points"])
    n = seen(answer["normal"])
    picture.path([p1, p2], colour, width=2, dashes="5 4")
    picture.arrow(p1, plus(p1, times(reach, n)), colour)
    picture.arrow(p2, plus(p2, times(-reach, n)), colour)
    for point in (p1, p2):
        picture.dot(point, colour)


def words_of(right, wrong):
    residue = max(abs(wrong["residuals"][name]) for name in ("R1", "R2"))
    below = next(bound for bound in (1e-15, 1e-12, 1e-9, 1e-6, 1) if residue < bound)
    return [
        ("The common normal: opposite normals, on the line through both points.", RIGHT),
        (f"Overlap {right['overlap']:.3f}. Proved: no direction has less.", RIGHT),
        (f"The published equations: \"{wrong['status']}\", their residues below {below:.0e}.", WRONG),
        (f"The normals are {wrong['angles_deg']['d_n1']:.0f} degrees off the line through their points, and "
         f"{degrees_between(wrong['normal'], right['normal']):.0f} degrees off the common normal.", WRONG),
        (f"Overlap {wrong['overlap']:.3f}, {wrong['overlap'] / right['overlap']:.1f} times too large.", WRONG),
    ]


def misaligned(plumb):
    right, wrong = certified(plumb), said(plumb, "solve", CASE, "--method", "original_cn")
    e1, up = plane_of(right["normal"], wrong["normal"])
    e2 = times(-1, up) if up[2] < 0 else up
    seen = lambda point: (dot(point, e1), dot(point, e2))
    picture = Picture(880, 460, 216, (270, 120), "Two equal discs: the common normal, and a converged answer that is none")
    for body, colour, name in zip(json.loads(CASE.read_text())["bodies"], (BODY1, BODY2), ("body 1", "body 2")):
        centre = body["position"]
        picture.body(silhouette(body["shape"]["superellipsoid"]["semi_axes"], centre, e1, e2), colour)
        picture.text(plus(seen(centre), times(0.75, minus(seen(centre), (0.75, -0.2)))), name, colour, 16, "middle", "600")
    draw_answer(picture, seen, wrong, WRONG, 0.62)
    draw_answer(picture, seen, right, RIGHT, 0.5)
    for row, (words, colour) in enumerate(words_of(right, wrong)):
        picture.label((24, 346 + 23 * row), words, colour, 15)
    return picture


def drawn(plumb):
    return {"misaligned.svg": misaligned(plumb), **terms.pictures(), **contacts.pictures(), **patch.pictures(), **search.pictures(), **plans.pictures(), **measured.pictures(plumb, CASE)}


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--plumb", default=PICTURES.parents[2] / "build/release/bin/plumb")
    arguments = parser.parse_args()
    wrong = []
    for name, picture in drawn(arguments.plumb).items():
        path, text = PICTURES / name, picture.written()
        if not arguments.check:
            path.write_text(text)
        elif not path.exists() or path.read_text() != text:
            wrong.append(f"{name}: is not what reports/docs/draw/draw.py draws")
    print(*wrong or [f"{len(drawn(arguments.plumb))} pictures"], sep="\n")
    sys.exit(1 if wrong else 0)


main()
