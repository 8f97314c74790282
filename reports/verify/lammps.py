"""The same scenes through LAMMPS: how far the last state of each is from that of `plumb scene`."""

import dataclasses
import json
import math
import os
import pathlib
import subprocess

import numpy as np

from case import Set
from scenes import Failed, frames_in

SAME = 1e-9  # a deviation that is none
ELASTIC = {"linear", "hertz", "volume", "foundation"}
# `pair_style plumb/cn` has an elastic law: where a scene has none, as nothing touches in it, this one; so soft that it sets no time step.
UNFELT = {"linear": {"stiffness": 1e-9}}
# What a dump of each calls the same, in groups that have one scale.
TURNS = ("quatw", "quati", "quatj", "quatk"), ("c_body[1]", "c_body[2]", "c_body[3]", "c_body[4]")
PLACES = (("x", "y", "z"),) * 2
VELOCITIES = (("vx", "vy", "vz"),) * 2
MOMENTA = ("angmomx", "angmomy", "angmomz"), ("c_body[8]", "c_body[9]", "c_body[10]")
DIAMETERS = ("shapex", "shapey", "shapez")
# As root, and with more processes than processors.
ENVIRONMENT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMPI_MCA_rmaps_base_oversubscribe": "1",
               "OMPI_MCA_mpi_yield_when_idle": "1", "OMP_NUM_THREADS": "1"}


class Refused(Exception):
    """What `plumb export-lammps` says that LAMMPS cannot run."""


@dataclasses.dataclass
class Row:
    """One test: the worst of its scenes, for each number of processes."""

    test: str
    largest: dict       # ranks: deviation; NaN where a run failed
    scenes: int = 0
    refused: str = ""   # why LAMMPS does not run it
    failed: str = ""    # the words of a run that failed

    @property
    def holds(self):
        return bool(self.refused) or all(found <= SAME for found in self.largest.values())  # not of NaN


def together(frame, names):
    return np.concatenate([frame["columns"][name] for name in names])


def apart(frame, other, names, scale):
    """Over that scale; over nothing where it is 0."""
    greatest = np.max(np.abs(together(frame, names[0]) - together(other, names[1])))
    return float(greatest / scale if scale > 0 else greatest)


def deviation(frame, other):
    """Greatest of places over the longest diameter, of turns, and of velocities and momenta each over their greatest in `frame`; where nothing
    can turn, that has no momenta."""
    kept = [names for names in (VELOCITIES, MOMENTA) if names[0][0] in frame["columns"]]
    greatest = {names: float(np.max(np.abs(together(frame, names[0])))) for names in kept}
    scales = {PLACES: float(np.max(together(frame, DIAMETERS))), TURNS: 1.0, **greatest}
    return max(apart(frame, other, names, scale) for names, scale in scales.items())


def last_words(text):
    return text.strip().splitlines()[-1] if text.strip() else "said nothing"


def with_a_law(scene):
    laws = [scene["effects"], *scene.get("materials", {}).values()]
    return scene if any(ELASTIC & set(law) for law in laws) else {**scene, "effects": {**scene["effects"], **UNFELT}}


class Lammps:
    """`plumb export-lammps` and `plumb lammps`, which lie beside `plumb scene`."""

    def __init__(self, scene_program=None):
        beside = pathlib.Path(scene_program or os.environ["PLUMB_SCENE"])
        self.export, self.program = beside.with_name("plumb-export-lammps"), beside.with_name("plumb-lammps")

    def exported(self, scene, files):
        """The scene file as in.lammps in a new folder."""
        ended = subprocess.run([self.export, scene, "-o", files], capture_output=True, text=True, check=False)
        if ended.returncode != 0:
            raise Refused(last_words(ended.stderr).removeprefix(f"{scene}: "))

    def run(self, files, ranks, script="in.lammps"):
        """What it says of itself."""
        command = ["mpirun", "-n", str(ranks)] if ranks > 1 else []
        ended = subprocess.run([*command, self.program, "-in", script, "-log", "none"], cwd=files, env={**os.environ, **ENVIRONMENT},
                               stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False)
        if ended.returncode != 0:
            raise Failed(last_words(ended.stderr or ended.stdout))
        return ended.stdout

    def last(self, files, ranks):
        """The last frame of a run's dump, which stays as dump.RANKS."""
        self.run(files, ranks)
        dump = (files / "dump.lammpstrj").rename(files / f"dump.{ranks}")
        return list(frames_in(dump.read_text()))[-1]


def add(row, runner, lammps, case, accuracy):
    row.scenes += 1
    folder = runner.place(case.name, accuracy)
    scene, files = folder / "scene-lammps.json", folder / "lammps"
    try:
        frame = runner.run(case.name, case.scene, accuracy).last
        scene.write_text(json.dumps(with_a_law(json.loads((folder / "scene-in.json").read_text()))))
        lammps.exported(scene, files)
    except Refused as refused:
        row.refused = str(refused)
        return
    except Failed as failed:
        row.failed, row.largest = str(failed), dict.fromkeys(row.largest, math.nan)
        return
    for ranks, largest in row.largest.items():
        try:
            row.largest[ranks] = max(largest, deviation(frame, lammps.last(files, ranks)))
        except Failed as failed:
            row.failed, row.largest[ranks] = str(failed), math.nan


def rows(runner, groups, accuracy, ranks, lammps=None):
    """One a test; tests of one name are one row."""
    lammps, found = lammps or Lammps(), {}
    for group in groups:
        row = found.setdefault(group.test, Row(group.test, dict.fromkeys(ranks, 0.0)))
        for case in group.cases if isinstance(group, Set) else [group]:
            add(row, runner, lammps, case, accuracy)
    return list(found.values())


def line(row):
    if row.refused:
        return f"{row.test:<52} {row.scenes:>6}  refused: {row.refused}"
    numbers = "  ".join(f"{found:9.1e}" for found in row.largest.values())
    return f"{row.test:<52} {row.scenes:>6}  {numbers}  {'same' if row.holds else 'off':<4}  {row.failed}".rstrip()


def text(found, accuracy):
    ranks = "  ".join(f"{f'{count} rank' + ('s' if count > 1 else ''):>9}" for count in found[0].largest)
    head = ["", "command reports/verify/run --ranks " + " ".join(map(str, found[0].largest)),
            f"The same scenes through LAMMPS, at accuracy {accuracy:g}: the largest deviation of a scene's last state from that of plumb scene.",
            f"same: at most {SAME:g}; of a set the worst.", "", f"{'test':<52} {'scenes':>6}  {ranks}", ""]
    return "\n".join([*head, *map(line, found), "", summary(found)]) + "\n"


def summary(found):
    refused = sum(bool(row.refused) for row in found)
    off = sum(not row.holds for row in found)
    return f"through LAMMPS: {len(found)} tests, {len(found) - refused - off} the same, {refused} refused, {off} off"
