"""Superellipsoids as rigid bodies: mass, moments, the point farthest along a direction, and the impulse of a frictionless impact."""

import numpy as np
from mpmath import beta, mpf


def quarter(i, p):
    """int x^i over |x|^p + |y|^p <= 1, x, y > 0 (Dirichlet)."""
    return beta((i + 1) / p, 1 / p + 1) / p


def slices(i, j, p):
    """int t^i (1 - t^p)^(j/p) over 0..1"""
    return beta((i + 1) / p, j / p + 1) / p


def mass_and_moments(semi_axes, exponents, density=1.0):
    a, b, c = (mpf(x) for x in semi_axes)
    n1, n2 = (mpf(n) for n in exponents)
    box = 8 * a * b * c * mpf(density)
    mass = box * quarter(0, n2) * slices(0, 2, n1)
    across = box * quarter(2, n2) * slices(0, 4, n1)
    along = box * quarter(0, n2) * slices(2, 2, n1)
    xx, yy, zz = a * a * across, b * b * across, c * c * along
    return mass, (yy + zz, zz + xx, xx + yy)


def support(semi_axes, exponents, direction):
    """The point of the surface farthest along a direction, body axes: the gradient of the dual norm."""
    n1, n2 = exponents
    q1, q2 = n1 / (n1 - 1), n2 / (n2 - 1)
    u = np.asarray(semi_axes) * np.asarray(direction)
    flat = (abs(u[0]) ** q2 + abs(u[1]) ** q2) ** (1 / q2)
    height = (flat ** q1 + abs(u[2]) ** q1) ** (1 / q1)
    out = np.empty(3)
    for k in (0, 1):
        out[k] = (flat / height) ** (q1 - 1) * (abs(u[k]) / flat) ** (q2 - 1)
    out[2] = (abs(u[2]) / height) ** (q1 - 1)
    return np.asarray(semi_axes) * np.sign(u) * out


class Rigid:
    """A body in its place: mass, inverse moments in world axes."""

    def __init__(self, semi_axes, exponents, turned):
        self.semi_axes, self.exponents, self.turned = semi_axes, exponents, turned
        mass, moments = mass_and_moments(semi_axes, exponents)
        self.mass = float(mass)
        self.inverse = turned @ np.diag([1 / float(i) for i in moments]) @ turned.T

    def farthest(self, direction):
        return self.turned @ support(self.semi_axes, self.exponents, self.turned.T @ direction)

    def yields(self, arm, normal):
        """1 / the mass that an impulse along the normal feels at an arm."""
        turned = np.cross(arm, normal)
        return 1 / self.mass + turned @ self.inverse @ turned

    def mobility(self, arm):
        """3 x 3: what an impulse at an arm changes the velocity there by."""
        lever = np.array([[0, -arm[2], arm[1]], [arm[2], 0, -arm[0]], [-arm[1], arm[0], 0]])
        return np.eye(3) / self.mass - lever @ self.inverse @ lever


def impulse(restitution, approach, *yields):
    """J = (1 + e) v_n / (1/m1 + 1/m2 + (r1 x n).I1^-1 (r1 x n) + (r2 x n).I2^-1 (r2 x n))"""
    return (1 + restitution) * approach / sum(yields)
