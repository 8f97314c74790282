"""Frictionless impacts of any convex body, on a plane and on another body: the impulse of rigid bodies.

Bodies are placed where they touch along a normal that is drawn first: the point of each is its farthest along it, in closed form. Nothing
of the solver's is asked. The collision is so short that no body turns by more than about 1e-5 in it."""

import math
import random

import numpy as np

from case import Case, Set
from rigid import Rigid, impulse
from scenes import body, floor, rotation_of, momentum, scene, velocity

STIFFNESS = 1e9
SPEED = 1.0
SOURCE = "impulse of rigid bodies"


def unit(draw, size=3):
    v = np.array([draw.gauss(0, 1) for _ in range(size)])
    return v / np.linalg.norm(v)


def drawn(draw, superquadric):
    axes = tuple(draw.uniform(0.5, 1.0) for _ in range(3))
    exponents = tuple(draw.uniform(2.2, 5) for _ in range(2)) if superquadric else (2.0, 2.0)
    return axes, exponents, unit(draw, 4)


def effects_of(restitution):
    linear = {"linear": {"stiffness": STIFFNESS}}
    return linear if restitution == 1 else {**linear, "damping": {"restitution": restitution}}


def lasts(yields):
    """The gap at the start, and the run: one collision."""
    rate = math.sqrt(STIFFNESS * yields)
    gap = SPEED / rate / 3
    return gap, gap / SPEED + 2.2 * math.pi / rate


def on_plane(name, draw, superquadric, restitution):
    axes, exponents, quaternion = drawn(draw, superquadric)
    one = Rigid(axes, exponents, rotation_of(quaternion))
    normal = np.array([0, 0, -1.0])
    arm = one.farthest(normal)
    yields = one.yields(arm, normal)
    gap, duration = lasts(yields)
    place = body(axes, exponents, (0, 0, gap - arm[2]), (0.3, -0.2, -SPEED), quaternion=quaternion)
    exact = impulse(restitution, SPEED, yields)

    def read(ran):
        push = one.mass * (velocity(ran.last)[2] + SPEED)
        spun = np.linalg.norm(momentum(ran.last) + push * np.cross(arm, normal))
        return {"impulse": push, "couple of it": spun}

    return Case(name, "", SOURCE, scene([place], effects_of(restitution), duration, [floor()]), {"impulse": exact, "couple of it": 0.0}, read,
                scale={"couple of it": exact})


def on_another(name, draw, superquadric, restitution):
    shapes = [drawn(draw, superquadric) for _ in range(2)]
    one, two = (Rigid(axes, exponents, rotation_of(quaternion)) for axes, exponents, quaternion in shapes)
    normal = unit(draw)
    arm1, arm2 = one.farthest(normal), two.farthest(-normal)
    yields = one.yields(arm1, normal), two.yields(arm2, normal)
    gap, duration = lasts(sum(yields))
    across = np.cross(normal, unit(draw)) / 3
    places = [body(*shapes[0][:2], (0, 0, 0), SPEED / 2 * normal, quaternion=shapes[0][2]),
              body(*shapes[1][:2], arm1 - arm2 + gap * normal - across * gap / SPEED, across - SPEED / 2 * normal, quaternion=shapes[1][2])]
    exact = impulse(restitution, SPEED, *yields)

    def read(ran):
        push = one.mass * (SPEED / 2 - velocity(ran.last, 0) @ normal)
        spun = np.linalg.norm(momentum(ran.last, 0) + push * np.cross(arm1, normal))
        return {"impulse": push, "couple of it": spun}

    return Case(name, "", SOURCE, scene(places, effects_of(restitution), duration), {"impulse": exact, "couple of it": 0.0}, read,
                scale={"couple of it": exact})


def a_set(what, make, superquadric, restitution, count):
    kind = "superquadrics" if superquadric else "ellipsoids"
    draw = random.Random(f"{what} {kind} {restitution}")
    name = f"{kind}-{what}-{restitution}".replace(" ", "-")
    cases = [make(f"{name}/{k}", draw, superquadric, restitution) for k in range(count)]
    return Set(name, f"{count} {kind} on {what}, e = {restitution}, worst", SOURCE, cases)


def sets(count):
    for superquadric in (False, True):
        for what, make in (("a plane", on_plane), ("another", on_another)):
            for restitution in (1.0, 0.6):
                yield a_set(what, make, superquadric, restitution, count)
