#!/usr/bin/python3
"""The study of patches: where the force of a face on a face, or of an edge on a face, acts, against what plumb puts on the patch.

reports/fem/run --patches calls it. Prints the tables and writes DIR/patches.jsonl, lines as README.md says.
"""

import dataclasses
import sys

import calculix
import checks
import methods
import patch_contact
import patch_tables
import study
from contact import Mode
from patch_contact import PatchTask

MODES = {"quick": Mode(order=1, division=5), "full": Mode(order=2, division=5)}
EDGE_DIVISION = 2.5  # of a strip's half width, as in study.py: twice as fine takes ten times as long
SETTING = calculix.Setting(increments=1)  # four take three times as long; the check of settings says what they move
RATIOS = {"quick": (0.005, 0.02), "full": (0.005, 0.02)}
VARIED_AT = ("face8", "edge8")
COLUMNS = {"area": (0.01, "relative"), "volume": (0.01, "relative"), "centres": (0.01, "radii of the patch")}
# Of the control a fifth of what is asked of laws, and of CN at small overlaps.
CONTROL = {"direction": (0.04, "degrees"), "centre": (0.01, "radii of the patch")}


def asked(geometries, ratios):
    """As study.asked, with the patch; nothing is certified."""
    pairs = [(g["name"], ratio) for g in geometries for ratio in ratios]
    cases = methods.placed([study.at_ratio(g, ratio) for g in geometries for ratio in ratios])
    out = [(*pair, case, of) for pair, case, of in zip(pairs, cases, methods.patches(cases))]
    for name, ratio, _, of in out:
        if not of:
            raise study.BadInput(f"{name} at {ratio:g}: auto: no common normal to mesh by")
    return out


def variations(mode):
    """(what, which, mode, setting) beside the study's own."""

    def changed(**fields):
        return mode, dataclasses.replace(SETTING, **fields)

    yield "swap", "body 1 is the slave", *changed(is_swapped=True)
    yield "held", "up to 0.4 of the way to the contact", *changed(held=0.4)
    if mode.order == 1:
        return
    yield "held", "what is 0.5 of that way and more behind the centre", *changed(held=-0.5)
    for part in (0.7, 1.4):
        finer = dataclasses.replace(mode, division=part * mode.division)
        yield "mesh", f"{finer.division:g} elements from the lens's middle to its rim, not {mode.division:g}", finer, SETTING
    yield "order", "linear tetrahedra, as in quick mode", dataclasses.replace(mode, order=1), SETTING
    yield "penalty", f"1000 E / patch radius, not {SETTING.penalty}", *changed(penalty=1000)
    yield "increments", f"4, not {SETTING.increments}", *changed(increments=4)


def mode_of(name, mode):
    return dataclasses.replace(mode, division=EDGE_DIVISION) if patch_tables.is_edge(name) else mode


def grids_of(name):
    finer = (patch_contact.FINER,) if name in VARIED_AT else ()
    return (patch_contact.CELLS, *finer)


class PatchStudy:
    held = "all nodes of each body's far half: beyond the plane through its centre across the common normal"

    def __init__(self, geometries, ratios, mode):
        self.geometries, own = geometries, MODES[mode]
        self.answered = [PatchTask(*of, mode_of(of[0], own), SETTING, True, grids_of(of[0])) for of in asked(geometries, ratios)]
        self.varied = [
            (base, what, which, PatchTask(base.geometry, base.ratio, base.case, base.answers, varied, setting))
            for base in self.answered
            if base.geometry in VARIED_AT and base.ratio == max(ratios)
            for what, which, varied, setting in variations(base.mode)
        ]

    def tasks(self):
        return [*self.answered, *(of[3] for of in self.varied)]

    def lines(self, results):
        by_task = dict(zip(map(id, self.tasks()), results))
        cases = {task.geometry: task.case for task in self.answered}
        yield from (study.geometry_line(g, cases[g["name"]]) for g in self.geometries)
        convergence = [
            study.convergence_line(task, what, which, by_task[id(task)], by_task[id(base)]) for base, what, which, task in self.varied
        ]
        answered = [(task, by_task[id(task)]) for task in self.answered]
        for name, value, limit, unit in checked(answered, convergence):
            yield {"kind": "check", "check": name, "value": float(value), "limit": limit, "unit": unit}
        yield from convergence
        yield from ({"kind": "patch", "geometry": task.geometry, "ratio": task.ratio} | result for task, result in answered)


def checked(answered, convergence):
    """(name, value, limit, unit) of the calculation itself."""
    whole = [(task, result) for task, result in answered if "reason" not in result]
    results = [result for _, result in whole]
    yield from checks.balance(results)
    yield from control([result for task, result in whole if patch_tables.is_control(task.geometry)])
    for name, (limit, unit) in COLUMNS.items():
        yield from checks.worst(f"plumb's patch and columns of the gap: {name}", [r["columns"][name] for r in results], limit, unit)
    shifts = [r["grid_shift"] for r in results if "grid_shift" in r]
    yield from checks.worst("half-spaces: a finer grid moves the centre", shifts, patch_tables.SETTINGS, "radii of the patch")
    yield from settings([line for line in convergence if "reason" not in line])


def control(results):
    """By symmetry its force is along the axis."""
    for name, field in (("direction", "angles_deg"), ("centre", "centre_off")):
        yield from checks.worst(f"control: {name}", [r[field]["auto"] for r in results], *CONTROL[name])


def settings(lines):
    yield from checks.variations(lines)
    held = [x["centre_shift"] for x in lines if x["varied"] == "held"]
    others = [x["centre_shift"] for x in lines if x["varied"] != "held"]
    yield from checks.worst("no setting moves the centre", others, patch_tables.SETTINGS, "radii of the patch")
    yield from checks.worst("what is held moves it", held, patch_tables.HELD, "radii of the patch")


PATCHES = study.Kind("patches.jsonl", RATIOS, PatchStudy, patch_contact.calculated, patch_tables, "patches.jsonl")

if __name__ == "__main__":
    sys.exit(study.answered(sys.argv[1:], PATCHES))
