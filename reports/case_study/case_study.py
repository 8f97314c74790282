"""The drum in LAMMPS: runs it, measures steps of what it has become, and predicts those of a million bodies."""

import argparse
import json
import os
import pathlib
import shutil
import sys

import cost
import drum
from lammps import Lammps, Refused
from scenes import Failed, frames_in

SIZES = (20000, 2500)   # the case itself, and one for the model to predict
DURATION = 0.5          # s: the bed has turned by a quarter and begins to slide
MEASURED = 200          # steps
ROUNDS = 3              # of each measurement, the least counts
PREDICTED = 1_000_000
RANKS = (1, 2, 8, 32, 128, 512)
# The bed is as deep on both sides of a cut across the drum's axis, however it leans.
CUT = "processors 1 * 1"
RESTART = "drum.restart"


def exported(lammps, folder, scene):
    """in.lammps of the drum, and what it reads, in a new folder."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    (folder / "scene.json").write_text(scene)
    lammps.exported(folder / "scene.json", folder / "files")
    script = (folder / "files/in.lammps").read_text()
    return script.replace("\nread_data ", f"\n{CUT}\nread_data ")


def ran(lammps, folder, ranks, script, name):
    """Its log, which stays in the folder."""
    (folder / "files" / f"in.{name}").write_text(script)
    log = lammps.run(folder / "files", ranks, f"in.{name}")
    (folder / f"log.{name}").write_text(log)
    return log


def measuring(script):
    """Goes on from the restart file for a few steps, and writes nothing."""
    kept = [line for line in script.splitlines() if not line.startswith(("compute body", "dump", "  d_n1", "thermo", "run ", "write_restart"))]
    at = next(k for k, line in enumerate(kept) if line.startswith("read_data"))
    shapes = [line for line in kept if line.startswith("fix shapes")]
    head = [line for line in kept[:at] if line not in shapes]
    return "\n".join([*head, f"read_restart {RESTART}", *shapes, *kept[at + 1:], f"run {MEASURED}", "info memory", ""])


def measured(lammps, folder, bodies, duration):
    """The drum once, where that is not done, and then steps of it on one process and on two: the least of a few rounds."""
    scene, kept = json.dumps(drum.scene(bodies, duration)), folder / "scene.json"
    if not ((folder / "log.run").exists() and kept.read_text() == scene):
        ran(lammps, folder, 2, exported(lammps, folder, scene) + f"write_restart {RESTART}\n", "run")
    script = measuring((folder / "files/in.run").read_text())
    rounds = [[cost.read(ran(lammps, folder, ranks, script, f"ranks-{ranks}")) for ranks in (1, 2)] for _ in range(ROUNDS)]
    return [min(runs, key=lambda run: run.step) for runs in zip(*rounds)]


def last_frame(folder):
    """Of the run's dump: {column: its numbers}."""
    text = (folder / "files/dump.lammpstrj").read_text()
    return next(frames_in(text[text.rindex("ITEM: TIMESTEP"):]))["columns"]


def write_last(folder, frame):
    """last.json: a scene of one step that begins where the run ended, for `plumb scene` and the page."""
    def rows(*names):
        return zip(*(frame[name].tolist() for name in names))
    axes = ([diameter / 2 for diameter in row] for row in rows(*(f"c_body[{k}]" for k in (5, 6, 7))))
    turns = rows(*(f"c_body[{k}]" for k in (1, 2, 3, 4)))
    parts = zip(axes, rows("d_n1", "d_n2"), rows("x", "y", "z"), turns, rows("vx", "vy", "vz"))
    bodies = [drum.body(*of_one, (0, 0, 0)) for of_one in parts]
    (folder / "last.json").write_text(json.dumps(drum.of_bodies(bodies, 1e-4, {"every": 0, "write": ["playback"]})))


HEAD = f"{'':<8} {'bodies':>8} {'ranks':>6} {'ms a step':>12} {'predicted':>12} {'us a body':>12} {'ghosts':>9} {'Mbyte':>9}"


def line(kind, run, predicted=None):
    said = "-" if predicted is None else f"{1e3 * predicted:.2f}"
    return (f"{kind:<8} {run.bodies:>8} {run.ranks:>6} {1e3 * run.step:12.2f} {said:>12} {1e6 * run.step * run.ranks / run.bodies:12.2f} "
            f"{run.ghosts:9.0f} {run.memory:9.0f}")


def prediction(model, bodies, ranks):
    ghosts = model.ghosts(bodies, ranks)
    step = model.step(bodies, ranks, ghosts)
    return (f"{bodies:>8} {ranks:>6} {bodies / ranks:9.0f} {ghosts:9.0f} {1e3 * step:12.2f} {model.own * bodies / ranks / step:12.2f} "
            f"{model.mbyte(bodies, ranks, ghosts):9.0f}")


def text(runs, model, duration, commit):
    (one, two), small = runs
    out = [f"commit {commit}", "command reports/case_study/run",
           f"Superquadrics in a drum that turns, after {duration:g} s, in LAMMPS: {MEASURED} steps, the least of {ROUNDS} rounds.",
           "us a body: times the ranks. ghosts, Mbyte: of a rank. predicted: by the model that the first two rows make.", "", HEAD, "",
           line("fitted", one), line("fitted", two), *(line("held", run, model.step(run.bodies, run.ranks, run.ghosts)) for run in small), "",
           f"model: a step takes {1e6 * model.own:.2f} us a body and {1e6 * model.ghost:.2f} us a ghost; a body has {1e9 * model.cell:.0f} mm^3 of the bed; "
           f"ghosts are {1e3 * model.cutoff:.1f} mm away", "",
           "Predicted by the model; nothing of it was run. Bodies of a rank fill a cube. efficiency: of one rank without ghosts.", "",
           f"{'bodies':>8} {'ranks':>6} {'own':>9} {'ghosts':>9} {'ms a step':>12} {'efficiency':>12} {'Mbyte':>9}", ""]
    out += [prediction(model, PREDICTED, ranks) for ranks in RANKS]
    out += ["", *(prediction(model, one.bodies * ranks, ranks) for ranks in RANKS)]
    return "\n".join(out) + "\n"


def main(arguments=None):
    top = pathlib.Path(__file__).resolve().parents[2]
    parser = argparse.ArgumentParser(prog="reports/case_study/run", description=__doc__)
    parser.add_argument("--bodies", type=int, nargs=2, default=SIZES, metavar="N", help="of the case, and of the smaller one")
    parser.add_argument("--duration", type=float, default=DURATION)
    parser.add_argument("--out", type=pathlib.Path, default=top / "build/case_study")
    parser.add_argument("--record", action="store_true", help="and reports/results/case_study.txt")
    asked = parser.parse_args(arguments)
    if asked.record and (tuple(asked.bodies), asked.duration) != (SIZES, DURATION):
        print("--record: takes the case as it is: leave --bodies and --duration out", file=sys.stderr)
        return 2
    if min(*asked.bodies, asked.duration) <= 0:
        print("--bodies and --duration: above 0", file=sys.stderr)
        return 2
    lammps = Lammps(pathlib.Path(os.environ["PLUMB_PROGRAMS"]) / "plumb-scene")
    for program in (lammps.export, lammps.program):
        if not program.exists():
            print(f"{program}: is not there", file=sys.stderr)
            return 1
    folders = [(asked.out / str(bodies)).resolve() for bodies in asked.bodies]
    try:
        runs = [measured(lammps, folder, bodies, asked.duration) for folder, bodies in zip(folders, asked.bodies)]
    except (Failed, Refused, ValueError) as failed:
        print(failed, file=sys.stderr)
        return 1
    frame, (one, two) = last_frame(folders[0]), runs[0]
    write_last(asked.out, frame)
    places = list(zip(*(frame[name].tolist() for name in "xyz")))
    model = cost.fitted(one, two, runs[1][0], cost.cell_inside(places, 2 * two.cutoff))
    table = text(runs, model, asked.duration, os.environ.get("PLUMB_COMMIT", "unknown"))
    (asked.out / "case_study.txt").write_text(table)
    if asked.record:
        (top / "reports/results/case_study.txt").write_text(table)
    print(table)
    return 0


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
