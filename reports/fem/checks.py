"""What must hold before the study says anything: (name, value, limit, unit), of which the value is at most the limit."""

import numpy as np

import calculix
from contact import degrees_between
from tables import SETTINGS_DEG


class NoCheck(Exception):
    """Hertz's balls have no answer: without it nothing else is to be believed."""


def hertz(task, result, of, limits):
    """Two balls of radius 1. limits: of the force, relative, of the direction, in degrees, and of the patch's radius, relative."""
    if "reason" in result:
        raise NoCheck(f"{of}: {result['reason']}")
    overlap = task.answers["auto"]["overlap"]
    force = 4 / 3 * calculix.MODULUS * np.sqrt(0.5) * overlap**1.5
    yield f"{of}: force", abs(result["force"] / force - 1), limits[0], "relative"
    yield f"{of}: direction", result["angles_deg"]["auto"], limits[1], "degrees"
    yield f"{of}: patch", abs(result["fem_patch_radius"] / np.sqrt(0.5 * overlap) - 1), limits[2], "relative, its radius"


def balance(results):
    yield from worst("action = reaction", [r["balance"] for r in results], 1e-5, "of the force")
    yield from worst("action and reaction on one line", [r["lines_apart"] for r in results], 0.1, "radii of the patch")
    yield from worst("contact elements = reactions", [r["elements_agree"] for r in results], 1e-5, "of the force")


def half_spaces(results):
    """Each contact's planes, from all starts, are one, and it is the finite elements'."""
    planes = [[p for p in r["planes"] if "reason" not in p] for r in results]
    spread = [degrees_between(a["direction"], b["direction"]) for of in planes for a in of for b in of]
    yield from worst("half-spaces: all starts end in one plane", spread, 1e-4, "degrees")
    to_fem = [p["fem_deg"] for of in planes for p in of if "fem_deg" in p]
    yield from worst("half-spaces: to the finite elements' force", to_fem, 0.2, "degrees")


def variations(lines):
    """Of convergence lines."""
    yield from worst("no setting turns the force", [x["turned_deg"] for x in lines if "turned_deg" in x], SETTINGS_DEG, "degrees")


def worst(name, values, limit, unit):
    """nan where one is; nothing of none."""
    if values:
        yield name, float(np.max(values)), limit, unit + ", worst of all"
