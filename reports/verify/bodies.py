"""Impacts of any convex body, on a plane and on another body: the impulse of rigid bodies, with friction that of an ODE.

Bodies are placed where they touch along a normal that is drawn first: the point of each is its farthest along it, in closed form. Nothing
of the solver's is asked. The collision is so short that no body turns by more than about 1e-5 in it."""

import math
import random

import numpy as np

import ode
from case import Case, Set
from rigid import Rigid, impulse
from scenes import body, floor, rotation_of, momentum, scene, velocity

STIFFNESS = 1e9
SPEED = 1.0
FRICTION = 0.3
SOURCE = {0: "impulse of rigid bodies", FRICTION: "the law's ODE"}


def unit(draw, size=3):
    v = np.array([draw.gauss(0, 1) for _ in range(size)])
    return v / np.linalg.norm(v)


def drawn(draw, superquadric):
    axes = tuple(draw.uniform(0.5, 1.0) for _ in range(3))
    exponents = tuple(draw.uniform(2.2, 5) for _ in range(2)) if superquadric else (2.0, 2.0)
    return axes, exponents, unit(draw, 4)


def effects_of(restitution, friction):
    out = {"linear": {"stiffness": STIFFNESS}}
    if restitution < 1:
        out["damping"] = {"restitution": restitution}
    if friction:
        out["friction"] = {"coefficient": friction}
    return out


def lasts(yields):
    """The gap at the start, and the run: one collision."""
    rate = math.sqrt(STIFFNESS * yields)
    gap = SPEED / rate / 3
    return gap, gap / SPEED + 2.2 * math.pi / rate


def a_case(name, places, first, arm, normal, approach, others, restitution, friction, walls=()):
    """The first body goes at `approach` past what it meets at `arm`, whose normal leads out of it; others: (body, arm)."""
    yields = [first.yields(arm, normal)] + [other.yields(its, normal) for other, its in others]
    if friction:
        mobility = first.mobility(arm) + sum(other.mobility(its) for other, its in others)
        exact = ode.frictional(mobility, approach, normal, restitution, friction)
    else:
        exact = -impulse(restitution, SPEED, *yields) * normal
    before = np.array(places[0]["velocity"])

    def read(ran):
        push = first.mass * (velocity(ran.last) - before)
        along = push @ normal
        return {"impulse": -along, "impulse across": np.linalg.norm(push - along * normal - (exact - (exact @ normal) * normal)),
                "couple of it": np.linalg.norm(momentum(ran.last) - np.cross(arm, push))}

    size = np.linalg.norm(exact)
    effects = effects_of(restitution, friction)
    return Case(name, "", SOURCE[friction], scene(places, effects, lasts(sum(yields))[1], walls),
                {"impulse": -exact @ normal, "impulse across": 0.0, "couple of it": 0.0}, read, scale={"impulse across": size, "couple of it": size})


def on_plane(name, draw, superquadric, restitution, friction):
    axes, exponents, quaternion = drawn(draw, superquadric)
    one = Rigid(axes, exponents, rotation_of(quaternion))
    normal = np.array([0, 0, -1.0])
    arm = one.farthest(normal)
    gap, _ = lasts(one.yields(arm, normal))
    approach = np.array([0.3, -0.2, -SPEED])
    place = body(axes, exponents, (0, 0, gap - arm[2]), approach, quaternion=quaternion)
    return a_case(name, [place], one, arm, normal, approach, [], restitution, friction, [floor()])


def on_another(name, draw, superquadric, restitution, friction):
    shapes = [drawn(draw, superquadric) for _ in range(2)]
    one, two = (Rigid(axes, exponents, rotation_of(quaternion)) for axes, exponents, quaternion in shapes)
    normal = unit(draw)
    arm1, arm2 = one.farthest(normal), two.farthest(-normal)
    gap, _ = lasts(one.yields(arm1, normal) + two.yields(arm2, normal))
    across = np.cross(normal, unit(draw)) / 3
    places = [body(*shapes[0][:2], (0, 0, 0), SPEED / 2 * normal, quaternion=shapes[0][2]),
              body(*shapes[1][:2], arm1 - arm2 + gap * normal - across * gap / SPEED, across - SPEED / 2 * normal, quaternion=shapes[1][2])]
    return a_case(name, places, one, arm1, normal, SPEED * normal - across, [(two, arm2)], restitution, friction)


def a_set(what, make, superquadric, restitution, friction, count):
    kind = "superquadrics" if superquadric else "ellipsoids"
    draw = random.Random(f"{what} {kind} {restitution}")
    rubs = f", mu {friction}" if friction else ""
    name = f"{kind}-{what}-{restitution}{rubs}".replace(" ", "-").replace(",", "")
    cases = [make(f"{name}/{k}", draw, superquadric, restitution, friction) for k in range(count)]
    return Set(name, f"{count} {kind} on {what}, e = {restitution}{rubs}, worst", SOURCE[friction], cases)


def sets(count):
    for superquadric in (False, True):
        for what, make in (("a plane", on_plane), ("another", on_another)):
            for restitution, friction in ((1.0, 0), (0.6, 0), (0.6, FRICTION)):
                yield a_set(what, make, superquadric, restitution, friction, count)
