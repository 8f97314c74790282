"""A body that rocks on a floor about its second axis, from rest: on ice, and without slipping.

Its centre is as high as its surface is far along the vertical, h(angle); the point of contact is h' aside of it. Of a rigid body
    (I + m h'^2) rate^2 / 2 + m g h = m g h(first)              on ice: the centre goes up and down
    (I + m (h^2 + h'^2)) rate^2 / 2 + m g h = m g h(first)      without slipping: it turns about the point of contact
The flat of a superquadric passes the point of contact from side to side at once, and no contact is stiff enough for that to be smooth: there the
law's own equations are integrated, m z'' = N - m g and I angle'' = -N h', N = stiffness (h - z).
"""

import math

from mpmath import cos, mp, mpf, quad, sin, sqrt

import ode
import rigid
from case import Case
from scenes import body, floor, momentum, position, rotation, scene

G = 10.0
PRESSED = 1e-6  # by its weight, in third semi-axes; where the law is integrated SOFT
SOFT = 1e-4
FIRST = 0.5     # angle


class Rocking:
    def __init__(self, semi_axes, exponents, slips):
        self.first, _, self.third = (mpf(a) for a in semi_axes)
        self.power = mpf(exponents[0]) / (exponents[0] - 1)
        mass, moments = rigid.mass_and_moments(semi_axes, exponents)
        self.mass, self.moment, self.slips = mass, moments[1], slips

    def quarter(self):
        """Of a swing's time."""
        return quad(lambda a: 1 / self.rate(a), [0, mpf(FIRST)])

    def height(self, angle):
        return ((self.first * sin(angle)) ** self.power + (self.third * cos(angle)) ** self.power) ** (1 / self.power)

    def aside(self, angle):
        """h'."""
        p, along, up = self.power, self.first * sin(angle), self.third * cos(angle)
        return (along ** (p - 1) * self.first * cos(angle) - up ** (p - 1) * self.third * sin(angle)) * self.height(angle) ** (1 - p)

    def rate(self, angle):
        arm = self.aside(angle) ** 2 + (0 if self.slips else self.height(angle) ** 2)
        return sqrt(2 * self.mass * G * (self.height(mpf(FIRST)) - self.height(angle)) / (self.moment + self.mass * arm))


def rocks(name, semi_axes, exponents, slips):
    """After two and a quarter swings it lies flat and turns the fastest, backwards."""
    with mp.workdps(30):
        exact = Rocking(semi_axes, exponents, slips)
        duration, fastest = 9 * exact.quarter(), exact.rate(mpf(0))
    tree = scene_of(semi_axes, exponents, *pressed_in(exact, PRESSED), duration, {} if slips else {"friction": {"coefficient": 2, "damping": 0.5}})
    return Case(name, name.replace("-", " "), "rigid bodies, a quadrature", tree, {"angle": 0.0, "spin": -fastest},
                lambda ran: state_of(ran, exact), scale={"angle": FIRST})


def rocks_softly(name, semi_axes, exponents, duration=1.5):
    exact = Rocking(semi_axes, exponents, True)
    height, stiffness = pressed_in(exact, SOFT)
    tree = scene_of(semi_axes, exponents, height, stiffness, duration)
    last = ode.rocking(semi_axes, float(exact.power), float(exact.mass), float(exact.moment), stiffness, G, (height, FIRST), duration)
    return Case(name, name.replace("-", " "), "the law's ODE", tree, dict(zip(("height", "angle", "spin"), last)),
                lambda ran: state_of(ran, exact), scale={"angle": FIRST})


def pressed_in(exact, share):
    """Height and stiffness of what its weight presses in by a share of its third semi-axis."""
    by = share * exact.third
    return float(exact.height(mpf(FIRST)) - by), float(exact.mass * G / by)


def scene_of(semi_axes, exponents, height, stiffness, duration, more=None):
    at_first = body(semi_axes, exponents, (0, 0, height), quaternion=(math.cos(FIRST / 2), 0, math.sin(FIRST / 2), 0))
    effects = {"gravity": {"acceleration": [0, 0, -G]}, "linear": {"stiffness": stiffness}, **(more or {})}
    return scene([at_first], effects, duration, [floor()])


def state_of(ran, exact):
    axis = rotation(ran.last)[:, 0]
    return {"height": position(ran.last)[2], "angle": math.atan2(-axis[2], axis[0]), "spin": momentum(ran.last)[1] / float(exact.moment)}


def cases():
    yield rocks("ellipsoid-rocks-on-ice", (1.2, 1.0, 0.7), (2, 2), slips=True)
    yield rocks("ellipsoid-rocks-without-slip", (1.2, 1.0, 0.7), (2, 2), slips=False)
    yield rocks_softly("superquadric-rocks-on-ice", (1.2, 1.0, 0.7), (4, 3))
