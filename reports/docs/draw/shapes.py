"""Superellipses, ellipsoids' silhouettes, and the overlap over directions: closed forms, in plain floats (reports/docs/pages/theory.md)."""
import math


def power(base, exponent):
    """With the base's sign."""
    return math.copysign(abs(base) ** exponent, base)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def times(factor, a):
    return tuple(factor * x for x in a)


def plus(a, b):
    return tuple(x + y for x, y in zip(a, b))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def length(a):
    return math.sqrt(dot(a, a))


def unit(a):
    return times(1 / length(a), a)


def degrees_between(a, b):
    """Of unit vectors, exact where they nearly agree."""
    return math.degrees(math.atan2(length(minus(a, times(dot(a, b), b))), dot(a, b)))


def turned(vector, degrees):
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return c * vector[0] - s * vector[1], s * vector[0] + c * vector[1]


class Superellipse:
    """|x/a|^n + |y/b|^n = 1, turned by so many degrees about its centre."""

    def __init__(self, a, b, n, centre=(0, 0), degrees=0):
        self.axes, self.n, self.centre, self.degrees = (a, b), n, centre, degrees

    def support_point(self, normal):
        """The surface point whose outward normal it is."""
        m = self.n / (self.n - 1)
        q = [axis * u for axis, u in zip(self.axes, turned(normal, -self.degrees))]
        h = sum(abs(x) ** m for x in q) ** (1 / m)
        return plus(self.centre, turned([axis * power(x / h, m - 1) for axis, x in zip(self.axes, q)], self.degrees))

    def at(self, ratio):
        """The point and the normal where y/b is `ratio` times x/a, x > 0."""
        x = (1 + abs(ratio) ** self.n) ** (-1 / self.n)
        point = (self.axes[0] * x, self.axes[1] * ratio * x)
        normal = unit((1 / self.axes[0], power(ratio, self.n - 1) / self.axes[1]))
        return plus(self.centre, turned(point, self.degrees)), turned(normal, self.degrees)

    def outline(self, steps=60):
        """Both charts of each quarter, so that faces and corners are equally fine."""
        ratios = [k / steps for k in range(-steps, steps)]
        right = [self.quarter(ratio, False) for ratio in ratios]
        top = [self.quarter(-ratio, True) for ratio in ratios]
        half = right + top
        return [plus(self.centre, turned(point, self.degrees)) for point in half + [times(-1, point) for point in half]]

    def quarter(self, ratio, is_top):
        x = (1 + abs(ratio) ** self.n) ** (-1 / self.n)
        return (self.axes[0] * ratio * x, self.axes[1] * x) if is_top else (self.axes[0] * x, self.axes[1] * ratio * x)


def overlap(body1, body2, normal):
    """o(n) = h1(n) + h2(-n) - n.(c2 - c1)."""
    return dot(normal, minus(body1.support_point(normal), body2.support_point(times(-1, normal))))


def direction(degrees):
    return turned((1, 0), degrees)


def least(body1, body2, low, high, steps=4000):
    """The direction of lowest overlap, in degrees."""
    return min((low + (high - low) * k / steps for k in range(steps + 1)), key=lambda angle: overlap(body1, body2, direction(angle)))


def witness_of(body1, body2, degrees):
    """The two support points of one direction, as one vector q1 - q2."""
    n = direction(degrees)
    return minus(body1.support_point(n), body2.support_point(times(-1, n)))


def minima(body1, body2, steps=3600):
    """The directions of all minima of the overlap, in degrees."""
    values = [overlap(body1, body2, direction(360 * k / steps)) for k in range(steps)]
    return [360 * k / steps for k in range(steps) if values[k] < values[k - 1] and values[k] <= values[(k + 1) % steps]]


def gauge(body, point):
    """1 on the surface, less inside; of degree 1."""
    inside = turned(minus(point, body.centre), -body.degrees)
    return sum(abs(x / axis) ** body.n for x, axis in zip(inside, body.axes)) ** (1 / body.n)


def silhouette(semi_axes, centre, e1, e2, steps=180):
    """Of an ellipsoid that is not turned, seen along e1 x e2: its support points in the plane's directions, in the plane's axes."""
    points = []
    for k in range(steps):
        c, s = direction(360 * k / steps)
        n = plus(times(c, e1), times(s, e2))
        weighted = [a * a * u for a, u in zip(semi_axes, n)]
        point = plus(centre, times(1 / math.sqrt(dot(weighted, n)), weighted))
        points.append((dot(point, e1), dot(point, e2)))
    return points
