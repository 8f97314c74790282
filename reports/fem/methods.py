"""What plumb says of a case: its own commands, asked once for a list of cases."""

import json
import pathlib
import subprocess

import numpy as np

from superellipsoid import pair_of

TOP = pathlib.Path(__file__).absolute().parents[2]
SOLVERS = ("auto", "original_cn")
# method -> the problem that it is to solve, as plumb certify names it: a solver of it may end elsewhere.
DEFINITIONS = {"geometric_potential": "deepest_points", "geometric_potential_midway": "midway", "first_touch": "first_touch"}


class CommandFailure(Exception):
    """plumb did not take the cases; its own line."""


def plumb(arguments, text):
    program = TOP / "build/release/bin/plumb"
    try:
        done = subprocess.run([program, *arguments], input=text, capture_output=True, text=True, check=False)
    except OSError as error:
        raise CommandFailure(f"{program}: {error.strerror}; reports/fem/run builds it") from None
    if done.returncode != 0:
        raise CommandFailure(done.stderr.strip() or f"plumb {arguments[0]}: exit {done.returncode}")
    return done.stdout


def lines_of(cases):
    return "".join(json.dumps(case) + "\n" for case in cases)


def placed(cases):
    """The same pairs with positions and quaternions, whatever they were given by: through a dump, a frame a case."""
    pairs = plumb(["import", "-"], plumb(["export", "-"], lines_of(cases)))
    out = [json.loads(line) for line in pairs.splitlines()]
    if len(out) != len(cases):
        raise CommandFailure(f"{len(cases) - len(out)} of {len(cases)} pairs do not overlap")
    return out


def answers(cases):
    """For each case: method -> {normal, points, contact_point, overlap}, of the methods that answer. What is defined is certified; the
    solvers' answers are those that they call converged."""
    for number, case in enumerate(cases):
        case["name"] = str(number)
    text = lines_of(cases)
    out = [{} for _ in cases]
    wanted = ["--method", ",".join(SOLVERS), "--want", "overlap,normal,points", "--json"]
    for answer in _objects(plumb(["solve", "-", *wanted], text)):
        if answer["status"] == "converged":
            out[int(answer["name"])][answer["method"]] = {name: answer[name] for name in ("normal", "points", "contact_point", "overlap")}
    for method, problem in DEFINITIONS.items():
        for proof in _objects(plumb(["certify", "-", "--problem", problem, "--json"], text)):
            if proof["verdict"] == "overlapping" and "normal" in proof:
                number = int(proof["name"])
                out[number][method] = _certified(proof, pair_of(cases[number]), problem)
    return out


def patches(cases):
    """For each case {"auto": normal, points, contact_point, overlap and the patch}, or {}."""
    for number, case in enumerate(cases):
        case["name"] = str(number)
    wanted = ["--method", "auto", "--want", "overlap,normal,points,patch", "--json"]
    return [{"auto": of} if of["status"] == "converged" else {} for of in _objects(plumb(["solve", "-", *wanted], lines_of(cases)))]


def _objects(text):
    return [json.loads(line) for line in text.splitlines()]


def _certified(proof, pair, problem):
    points = np.array(proof["points"], float)
    place = _midway(pair, points) if problem == "midway" else points.mean(axis=0)
    bounds = [float(proof["overlap"][side]) for side in ("lower", "upper")]
    normal = [float(x) for x in proof["normal"]]
    return {"normal": normal, "points": points.tolist(), "contact_point": place.tolist(), "overlap": sum(bounds) / 2}


def _midway(pair, points):
    """Where both gauges are the same, on the line between the points: as deep in one body as in the other."""

    def ahead(part):
        place = ((1 - part) * points[0] + part * points[1])[None]
        return (pair[0].gauge(pair[0].to_body(place)) - pair[1].gauge(pair[1].to_body(place)))[0]

    low, high = 0.0, 1.0  # on body 1 its gauge is 1 and the other's below it, on body 2 the other way
    for _ in range(60):
        middle = (low + high) / 2
        low, high = (low, middle) if ahead(middle) < 0 else (middle, high)
    return points[0] + low * (points[1] - points[0])
