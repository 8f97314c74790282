"""Adhesion: what a collision with JKR's force loses, where a ball comes to rest, and that DMT's pull loses nothing."""

import math

import exact
from case import Case
from scenes import ball, floor, position, scene, velocity

YOUNG, POISSON, WORK = 1e6, 0.3, 5.0
JKR = "Johnson, Kendall & Roberts 1971"
DMT = "Derjaguin, Muller & Toporov 1975"


def effects(law, **more):
    return {"hertz": {"youngs_modulus": YOUNG, "poissons_ratio": POISSON}, law: {"work_of_adhesion": WORK}, **more}


def on_plane(name, test, source, law, speed, wanted):
    """The speed at which a ball of radius 1 leaves a plane again."""
    gap = 1e-3
    tree = scene([ball(1, (0, 0, 1 + gap), (0, 0, -speed))], effects(law), 0.02 / speed + 0.2, [floor()])
    return Case(name, test, source, tree, {"speed after": wanted}, lambda ran: {"speed after": velocity(ran.last)[2]})


def at_rest(name, test, source, law, wanted):
    tree = scene([ball(1, (0, 0, 1 - 1e-5))], effects(law, damping={"restitution": 0.05}), 3.0, [floor()])
    return Case(name, test, source, tree, {"overlap": wanted}, lambda ran: {"overlap": 1 - position(ran.last)[2]})


def cases():
    neck = exact.Neck(WORK, exact.modulus(YOUNG, POISSON), 1)
    mass = exact.ball_mass(1, 1)
    sticks_below = float(exact.sqrt(2 * neck.lost / mass))
    for times in (2, 5):
        speed = times * sticks_below
        yield on_plane(f"jkr-{times}", f"JKR, ball on a plane, {times} times the speed that sticks", JKR, "jkr", speed,
                       sticks_below * math.sqrt(times ** 2 - 1))
    yield at_rest("jkr-rest", "JKR, ball at rest on a plane", JKR, "jkr", neck.rest)
    yield on_plane("dmt", "DMT, ball on a plane", DMT, "dmt", 0.5, 0.5)
    yield at_rest("dmt-rest", "DMT, ball at rest on a plane", DMT, "dmt",
                  (2 * exact.pi * WORK / exact.hertz_ball(exact.modulus(YOUNG, POISSON), 1)) ** (exact.mpf(2) / 3))
