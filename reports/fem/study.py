#!/usr/bin/python3
"""The study: which method's normal is along the force that two bodies pressed into each other have upon each other.

reports/fem/run calls it. Prints the tables and writes DIR/fem.jsonl, the lines that corpus/formats/report.md describes.
"""

import argparse
import dataclasses
import json
import os
import pathlib
import shlex
import sys
import types
import typing
from concurrent.futures.process import BrokenProcessPool

import numpy as np

import calculix
import checks
import tables
from contact import Mode, degrees_between
from mesh import MeshFailure
from methods import TOP, CommandFailure, answers, placed, plumb
from tasks import Busy, Task, calculated, engine_versions, run_all

MODES = {"quick": Mode(order=1, division=4), "full": Mode(order=2, division=2.5)}
RATIOS = {"quick": (0.005, 0.02), "full": (0.002, 0.005, 0.01, 0.02)}
HELD = "all nodes of each body's far half: beyond the plane through its centre across the line to the contact"
HERTZ_RATIO = 2e-4
# Meshes of Hertz's two balls, with limits for force, direction (degrees) and the patch's radius: a fine one, and the study's own.
FINE = (Mode(order=2, division=4), "Hertz", (0.02, 0.01, 0.1))
HERTZ = {"quick": [FINE, (MODES["quick"], "Hertz, this mode's mesh", (0.15, 0.01, 0.2))],
         "full": [FINE, (MODES["full"], "Hertz, this mode's mesh", (0.05, 0.01, 0.2))]}  # fmt: skip
SMALL = 0.005  # up to this ratio half-spaces are asked,
BENT = "S4"  # and at every one of the geometry whose force leaves the common normal by more than the limits
VARIED_AT = ("G3", "Q3", BENT)
VARIED_RATIO = 0.01  # or the study's own nearest to it
SHOWN_AT = "G3"


class BadInput(Exception):
    """One line: file, field, reason."""


def read_geometries(path):
    plumb(["export", path], "")  # refuses what is no case file, with line, field and reason
    out = []
    for number, line in enumerate(pathlib.Path(path).read_text(encoding="utf-8").splitlines(), start=1):
        if line.strip():
            out.append(geometry_of(line, f"{path}:{number}"))
    names = [case["name"] for case in out]
    if len(set(names)) != len(names):
        raise BadInput(f"{path}: name: two geometries have one")
    return out


def geometry_of(line, where):
    try:
        case = json.loads(line)
    except ValueError:
        raise BadInput(f"{where}: is no whole case: one a line") from None
    for field in ("name", "placement"):
        if not case.get(field):
            raise BadInput(f"{where}: {field}: is missing; a geometry has a name and a placement")
    return case


def at_ratio(geometry, ratio):
    return geometry | {"placement": geometry["placement"] | {"overlap_ratio": ratio}}


def asked(geometries, ratios):
    """(name, ratio, case with positions, answers), of each geometry at each ratio."""
    pairs = [(g["name"], ratio) for g in geometries for ratio in ratios]
    cases = placed([at_ratio(g, ratio) for g in geometries for ratio in ratios])
    out = [(*pair, case, of) for pair, case, of in zip(pairs, cases, answers(cases))]
    for name, ratio, _, of in out:
        if "auto" not in of:
            raise BadInput(f"{name} at {ratio:g}: auto: no common normal to mesh by")
    return out


def spheres():
    """Two balls that overlap little against their size, off the axes of both meshes: Hertz's own case."""
    ball = {"superellipsoid": {"semi_axes": [1, 1, 1]}}
    turned = {"shape": ball, "orientation": {"euler_zxz_deg": [10, 50, 0]}}
    fixed = {"shape": ball, "position": [0, 0, 0], "orientation": {"quaternion_wxyz": [1, 0, 0, 0]}}
    placement = {"line_deg": [40, 20], "overlap_ratio": HERTZ_RATIO}
    return {"format": "plumb/case-1", "name": "spheres", "bodies": [fixed, turned], "placement": placement}


def variations(mode):
    """(what, which, mode, setting) beside the study's own; of quick meshes the two that say most for their time."""
    base = calculix.Setting()

    def changed(**fields):
        return mode, dataclasses.replace(base, **fields)

    yield "swap", "body 1 is the slave", *changed(is_swapped=True)
    yield "held", "up to 0.4 of the way to the contact", *changed(held=0.4)
    if mode.order == 1:
        return
    yield "held", "what is 0.5 of that way and more behind the centre", *changed(held=-0.5)
    for division in (1.5, 4):
        yield "mesh", f"{division} elements from the lens's middle to its rim, not {mode.division}", Mode(2, division), base
    yield "order", "linear tetrahedra, as in quick mode", MODES["quick"], base
    for penalty in (100, 1000):
        yield "penalty", f"{penalty} E / patch radius, not {base.penalty}", *changed(penalty=penalty)
    for increments in (1, 2, 8):
        yield "increments", f"{increments}, not {base.increments}", *changed(increments=increments)
    yield "solver", "SPOOLES, direct", *changed(solver="SPOOLES")


def geometry_line(geometry, case):
    shapes = [body["shape"]["superellipsoid"] for body in case["bodies"]]
    is_ellipsoid = all(s["exponents"] == [2, 2] for s in shapes)
    is_round = all(len(set(s["semi_axes"])) < 3 for s in shapes)
    return {
        "kind": "geometry",
        "name": geometry["name"],
        "shape": "superquadric" if not is_ellipsoid else "spheroid" if is_round else "ellipsoid",
        "bodies": shapes,
        "line_deg": geometry["placement"]["line_deg"],
        "quaternion": case["bodies"][1]["orientation"]["quaternion_wxyz"],
    }


def answer_line(task, result):
    of = task.answers
    gp = of.get("geometric_potential")
    angle = degrees_between(of["auto"]["normal"], gp["normal"]) if gp else None
    head = {"kind": "answer", "geometry": task.geometry, "ratio": task.ratio, "cn_to_gp_deg": angle}
    return head | {name: value for name, value in result.items() if name != "planes"}


def convergence_line(task, what, which, result, base):
    if "reason" in result or "reason" in base:
        return {"kind": "convergence", "geometry": task.geometry, "ratio": task.ratio, "varied": what, "setting": which,
                "reason": result.get("reason") or "the study's own setting has no answer"}  # fmt: skip
    shift = np.array(result["centre"]) - np.array(base["centre"])
    return {
        "kind": "convergence",
        "geometry": task.geometry,
        "ratio": task.ratio,
        "varied": what,
        "setting": which,
        "turned_deg": degrees_between(result["direction"], base["direction"]),
        "force_change": result["force"] / base["force"] - 1,
        "patch_change": result["fem_patch_radius"] / base["fem_patch_radius"] - 1,
        "centre_shift": float(np.linalg.norm(shift) / base["patch_radius"]),
    }


class Study:
    """All tasks of a mode, in one list, so that they run side by side, and the lines that they give."""

    held = HELD

    def __init__(self, geometries, ratios, mode):
        self.geometries, own = geometries, MODES[mode]
        self.answered = [
            Task(name, ratio, case, of, own, has_planes=ratio <= SMALL or name == BENT)
            for name, ratio, case, of in asked(geometries, ratios)
        ]
        balls = asked([spheres()], [HERTZ_RATIO])[0]
        self.hertz = [(Task(*balls, mesh), *limits) for mesh, *limits in HERTZ[mode]]
        nearest = min(ratios, key=lambda ratio: abs(ratio - VARIED_RATIO))
        self.varied = [
            (base, what, which, Task(base.geometry, base.ratio, base.case, base.answers, varied, setting))
            for base in self.answered
            if base.geometry in VARIED_AT and base.ratio == nearest
            for what, which, varied, setting in variations(own)
        ]

    def tasks(self):
        """The longest first."""
        return [*(of[0] for of in self.hertz), *(of[3] for of in self.varied), *self.answered]

    def lines(self, results):
        by_task = dict(zip(map(id, self.tasks()), results))
        answered = [by_task[id(task)] for task in self.answered]
        cases = {task.geometry: task.case for task in self.answered}
        yield from (geometry_line(g, cases[g["name"]]) for g in self.geometries)
        convergence = [
            convergence_line(task, what, which, by_task[id(task)], by_task[id(base)]) for base, what, which, task in self.varied
        ]
        whole = [result for result in answered if "reason" not in result]
        checked = [check for task, *of in self.hertz for check in checks.hertz(task, by_task[id(task)], *of)]
        checked += [*checks.balance(whole), *checks.half_spaces(answered), *checks.variations(convergence)]
        for name, value, limit, unit in checked:
            yield {"kind": "check", "check": name, "value": float(value), "limit": limit, "unit": unit}
        yield from convergence
        yield from (answer_line(task, result) for task, result in zip(self.answered, answered))
        for task, result in zip(self.answered, answered):
            head = {"kind": "half_space", "geometry": task.geometry, "ratio": task.ratio}
            yield from (head | plane for plane in result["planes"])


@dataclasses.dataclass(frozen=True)
class Kind:
    """What a run is of."""

    geometries: str  # the file of its own, beside this one
    ratios: dict  # by mode
    make: type  # of (geometries, ratios, mode): its tasks, of which `varied` are those of other settings, and its lines
    calculate: typing.Callable  # a task
    shown: types.ModuleType  # LIMITS, and of the lines text and findings
    file: str
    draw: typing.Callable | None = None


def run_line(arguments, words, engines, limits, held):
    host = {"commit": os.environ.get("PLUMB_COMMIT", "?"), "cores": str(os.cpu_count()), "numpy": np.__version__, **engines}
    return {
        "kind": "run",
        "command": shlex.join(["reports/fem/run", *words]),
        "host": host,
        "mode": arguments.mode,
        "young": calculix.YOUNG,
        "poisson": calculix.POISSON,
        "held": held,
        "limits": limits,
    }


def show_progress(done, of):
    print(f"\r{done} of {of} calculations", end="\n" if done == of else "", file=sys.stderr, flush=True)


class Parser(argparse.ArgumentParser):
    def error(self, message):
        raise BadInput(f"{self.prog}: {message}")


def parsed(words, kind):
    parser = Parser(prog="reports/fem/run", description=__doc__)
    parser.add_argument("--quick", dest="mode", action="store_const", const="quick", default="full")
    parser.add_argument("--patches", action="store_true", help="faces and edges: where the force acts, against plumb's patches")
    parser.add_argument("--geometries", default=str(pathlib.Path(__file__).parent / kind.geometries), metavar="FILE")
    parser.add_argument("--ratios", type=float, nargs="+", metavar="R")
    parser.add_argument("--no-settings", action="store_true", help="without asking what the result hangs on")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--pictures", action="store_true", help="also DIR/angles.png and DIR/contact.png")
    parser.add_argument("--out", default=str(TOP / "build/fem"), metavar="DIR")
    arguments = parser.parse_args(words)
    arguments.ratios = arguments.ratios or kind.ratios[arguments.mode]
    if not all(0 < ratio <= 0.1 for ratio in arguments.ratios):
        raise BadInput("--ratios: more than 0 and at most 0.1")
    if len(set(arguments.ratios)) < len(arguments.ratios):
        raise BadInput("--ratios: one stands twice")
    if pathlib.Path(arguments.out).exists() and not pathlib.Path(arguments.out).is_dir():
        raise BadInput(f"--out: {arguments.out}: is no folder")
    if arguments.jobs < 1:
        raise BadInput("--jobs: at least 1")
    if arguments.pictures and kind.draw is None:
        raise BadInput("--pictures: there are none of --patches")
    return arguments


def draw(study, lines, out):
    """The angles, and one contact where it is deepest."""
    import figures  # matplotlib is for those who want pictures

    figures.draw_angles(lines, out / "angles.png")
    deepest = max(task.ratio for task in study.answered)
    for task in study.answered:
        if task.geometry == SHOWN_AT and task.ratio == deepest:
            figures.draw_contact(task, out / "contact.png")


OWN = Kind("geometries.jsonl", RATIOS, Study, calculated, tables, "fem.jsonl", draw)


def main(arguments, words, kind):
    out = pathlib.Path(arguments.out)
    study = kind.make(read_geometries(arguments.geometries), arguments.ratios, arguments.mode)
    if arguments.no_settings:
        study.varied = []
    engines = engine_versions()
    results = run_all(study.tasks(), out, engines["ccx"], arguments.jobs, show_progress, kind.calculate)
    lines = [run_line(arguments, words, engines, kind.shown.LIMITS, study.held), *study.lines(results)]
    (out / kind.file).write_text("".join(json.dumps(line) + "\n" for line in lines), encoding="utf-8")
    print(kind.shown.text(lines), flush=True)
    if arguments.pictures:
        kind.draw(study, lines, out)
    return 1 if kind.shown.findings(lines) else 0


def answered(words, kind):
    """The exit code, with one line where there is nothing to show."""
    arguments = None
    try:
        arguments = parsed(words, kind)
        return main(arguments, words, kind)
    except (BadInput, CommandFailure, Busy, checks.NoCheck, calculix.EngineFailure, MeshFailure, BrokenProcessPool) as error:
        print(error, file=sys.stderr)
    except ImportError as error:
        print(f"{error.name}: is not here: reports/fem/run installs it", file=sys.stderr)
    except OSError as error:  # of a full disk without the file's name
        print(f"{error.filename or arguments.out}: {error.strerror}", file=sys.stderr)
    except KeyboardInterrupt:
        print("\ninterrupted: what was calculated is kept, and not made again", file=sys.stderr)
        return 130
    return 2


if __name__ == "__main__":
    sys.exit(answered(sys.argv[1:], OWN))
