"""Superellipsoids in a pose, with numpy: what meshes and gaps need of them.

Gauge g(x) = ((|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1)^(1/n1) in body axes: homogeneous of degree 1, 1 on the surface. n1, n2 as in
LIGGGHTS and in plumb/case-1. Points are rows, n x 3.
"""

import dataclasses

import numpy as np


def matrix_of(quaternion):
    """The rotation of a quaternion (w, x, y, z) of any length, body axes to world."""
    w, x, y, z = np.asarray(quaternion, float) / np.linalg.norm(quaternion)
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
        ]
    )


@dataclasses.dataclass(frozen=True)
class Body:
    semi_axes: np.ndarray
    exponents: np.ndarray  # n1, n2
    position: np.ndarray
    rotation: np.ndarray  # 3 x 3, body axes to world

    @staticmethod
    def of(body):
        """From a body of a case file whose position is given and whose orientation is a quaternion."""
        shape = body["shape"]["superellipsoid"]
        return Body(
            np.array(shape["semi_axes"], float),
            np.array(shape.get("exponents", [2, 2]), float),
            np.array(body["position"], float),
            matrix_of(body["orientation"]["quaternion_wxyz"]),
        )

    def to_body(self, points):
        return (points - self.position) @ self.rotation

    def to_world(self, points):
        return points @ self.rotation.T + self.position

    def gauge(self, local):
        """Of points in body axes."""
        return self._parts(local)[0]

    def _parts(self, local):
        n1, n2 = self.exponents
        q = np.abs(local) / self.semi_axes
        ring = (q[:, 0] ** n2 + q[:, 1] ** n2) ** (1 / n2)
        return (ring**n1 + q[:, 2] ** n1) ** (1 / n1), ring, q

    def gradient(self, local):
        """Of the gauge, in body axes; outward, of degree 0."""
        n1, n2 = self.exponents
        value, ring, q = self._parts(local)
        ring_part = (ring / value) ** (n1 - 1)
        safe = np.where(ring > 0, ring, 1)
        parts = np.column_stack(
            [
                ring_part * (q[:, 0] / safe) ** (n2 - 1),
                ring_part * (q[:, 1] / safe) ** (n2 - 1),
                (q[:, 2] / value) ** (n1 - 1),
            ]
        )
        return np.sign(local) * parts / self.semi_axes

    def normals(self, points):
        """Outward unit normals at points of the surface, all in the world."""
        gradient = self.gradient(self.to_body(points))
        return gradient / np.linalg.norm(gradient, axis=1, keepdims=True) @ self.rotation.T

    def of_sphere(self, points):
        """Points of the unit ball onto the body's, in body axes: radially from the ellipsoid's, of which the ball's are the images."""
        scaled = points * self.semi_axes
        radius = np.linalg.norm(points, axis=1)
        gauge = np.where(radius > 0, self.gauge(np.where(radius[:, None] > 0, scaled, 1)), 1)
        return scaled * np.where(radius > 0, radius / gauge, 1)[:, None]

    def to_sphere(self, local):
        """The inverse of of_sphere."""
        unit = local / self.semi_axes
        radius = np.linalg.norm(unit, axis=1)
        return unit * (self.gauge(local) / np.where(radius > 0, radius, 1))[:, None]

    def heights(self, points, direction, side):
        """From each point along a unit direction to the surface's last (side +1) or first (-1) point on that line; nan where the line misses.

        The gauge is convex along a line: its least by golden section, then the level 1 by Newton from outside, which never oversteps.
        """
        start, along = self.to_body(points), direction @ self.rotation
        reach = np.linalg.norm(self.semi_axes) * 1.01
        middle = -(start @ along)
        low, high = middle - reach, middle + reach
        least = self._lowest(start, along, low, high)
        inside = self.gauge(start + least[:, None] * along) < 1
        height = np.where(side > 0, high, low)
        for _ in range(60):
            at = start + height[:, None] * along
            value, slope = self.gauge(at), self.gradient(at) @ along
            step = np.where(inside, (value - 1) / np.where(inside, slope, 1), 0)
            height = height - step
            if np.abs(step).max(initial=0) < 1e-15 * reach:
                break
        return np.where(inside, height, np.nan)

    def _lowest(self, start, along, low, high):
        """Where the gauge is least along the lines; it need not be exact, a point inside is what is looked for."""
        ratio = (np.sqrt(5) - 1) / 2
        for _ in range(60):
            a, b = high - ratio * (high - low), low + ratio * (high - low)
            is_left = self.gauge(start + a[:, None] * along) < self.gauge(start + b[:, None] * along)
            low, high = np.where(is_left, low, a), np.where(is_left, b, high)
        return (low + high) / 2


def pair_of(case):
    return tuple(Body.of(body) for body in case["bodies"])
