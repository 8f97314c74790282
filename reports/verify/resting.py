"""A ball on a floor under gravity: sliding, rolling, twisting; heat that leaves it; and what needs no contact: drag, free tumbling."""

import math

import numpy as np

import exact
import rigid
from case import Case
from scenes import ball, body, floor, momentum, position, rotation, scene, velocity

G = 10.0
MASS = float(exact.ball_mass(1, 1))
INERTIA = 0.4 * MASS
STIFFNESS = MASS * G / 1e-5  # pressed in by 1e-5 of the radius
DAMPED = {"damping": 0.5}


def on_floor(effects, duration, velocity_=(0, 0, 0), spin=(0, 0, 0), every=0, **more):
    bodies = [ball(1, (0, 0, 1 - 1e-5), velocity_, spin, **more)]
    all_effects = {"gravity": {"acceleration": [0, 0, -G]}, "linear": {"stiffness": STIFFNESS}, **effects}
    return scene(bodies, all_effects, duration, [floor(**({"temperature": 0} if "temperature" in more else {}))], every)


def rate(ran, value):
    """Of what falls with the time: between a quarter and the end, in frames of a quarter."""
    first, last = ran.frames[1], ran.frames[-1]
    return (value(first) - value(last)) / (last["time"] - first["time"])


def sliding():
    mu = 0.3
    ends = 2 / (7 * mu * G)
    yield Case("slides", "ball slides", "Coulomb", on_floor({"friction": {"coefficient": mu, **DAMPED}}, 0.8 * ends, (1, 0, 0), every=0.2 * ends),
               {"deceleration": mu * G}, lambda ran: {"deceleration": rate(ran, lambda f: velocity(f)[0])})
    yield Case("rolls", "ball slides, then rolls", "angular momentum about the contact",
               on_floor({"friction": {"coefficient": mu, **DAMPED}}, 1.5 * ends, (1, 0, 0)),
               {"velocity": 5 / 7, "spin": 5 / 7},
               lambda ran: {"velocity": velocity(ran.last)[0], "spin": momentum(ran.last)[1] / INERTIA})


def couples():
    mu = 0.01
    rolls = {"friction": {"coefficient": 1, **DAMPED}, "rolling": {"coefficient": mu, **DAMPED}}
    yield Case("rolling", "rolling resistance, ball rolls", "couple mu R N: 5/7 mu g", on_floor(rolls, 0.4, (1, 0, 0), (0, 1, 0), every=0.1),
               {"deceleration": 5 / 7 * mu * G}, lambda ran: {"deceleration": rate(ran, lambda f: velocity(f)[0])})
    yield Case("twisting", "twisting resistance, ball spins", "couple mu R N: 5/2 mu g / R",
               on_floor({"twisting": {"coefficient": mu, **DAMPED}}, 0.4, spin=(0, 0, 1), every=0.1),
               {"deceleration": 2.5 * mu * G}, lambda ran: {"deceleration": rate(ran, lambda f: momentum(f)[2] / INERTIA)})


def heat():
    conductivity = 100.0
    falls = 2 * conductivity * math.sqrt(1e-5) / MASS
    time = 1 / falls
    tree = on_floor({"conduction": {"conductivity": conductivity}}, time, temperature=1.0)
    return Case("cooling", "ball cools on a floor", "exp(-2 k a t / (m c)), a^2 = overlap R", tree, {"temperature": exact.exp(-1)},
                lambda ran: {"temperature": ran.last["columns"]["temperature"][0]})


def drag():
    viscosity = 0.1
    slows = 6 * math.pi * viscosity / MASS
    tree = scene([ball(1, (0, 0, 0), (1, 0, 0))], {"drag": {"viscosity": viscosity}}, 1 / slows)
    return Case("drag", "Stokes drag on a ball", "exp(-6 pi viscosity r t / m)", tree, {"velocity": exact.exp(-1), "way": (1 - exact.exp(-1)) / slows},
                lambda ran: {"velocity": velocity(ran.last)[0], "way": position(ran.last)[0]})


def tumbling(name, axes, exponents):
    """From rest in body axes along the world's, the third axis nearly along the momentum."""
    _, moments = rigid.mass_and_moments(axes, exponents)
    free = exact.Tumbling(moments, 0.6, 1.0)
    time = free.period * exact.mpf("2.3")
    start = np.array([float(free.moments[0]) * 0.6, 0, float(free.moments[2])])
    along = start / np.linalg.norm(start)
    side = np.cross(along, [0, 1, 0])
    tree = scene([body(axes, exponents, (0, 0, 0), spin=(0.6, 0, 1.0))], {}, float(time))

    def read(ran):
        turned = rotation(ran.last)
        own = (turned.T @ momentum(ran.last)) / np.array([float(i) for i in free.moments])
        axis = turned[:, 2]
        angle = math.atan2(axis @ np.cross(along, side), axis @ side)
        return {"spin 1": own[0], "spin 2": own[1], "spin 3": own[2], "precession": angle}

    first = math.atan2(np.array([0, 0, 1]) @ np.cross(along, side), np.array([0, 0, 1]) @ side)
    precession = float(free.precession(time)) + first
    w1, w2, w3 = free.spin(time)
    return Case(name, f"free tumbling, {name}", "Landau & Lifshitz, section 37", tree,
                {"spin 1": w1, "spin 2": w2, "spin 3": w3, "precession": math.remainder(precession, 2 * math.pi)}, read,
                scale={"spin 1": 1, "spin 2": 1, "spin 3": 1, "precession": precession})


def cases():
    yield from sliding()
    yield from couples()
    yield heat()
    yield drag()
    yield tumbling("ellipsoid", (1.2, 1.0, 0.7), (2, 2))
    yield tumbling("superquadric", (1.2, 1.0, 0.7), (4, 3))
