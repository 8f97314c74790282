"""Pictures of the patch: what two bodies have in common, and what its outline is like where an overlap is small."""
import math

from shapes import Superellipse, direction, dot, gauge, least, minus, plus, times, turned, unit
from svg import BODY1, BODY2, INK, RIGHT, SOFT, Picture

STEPS = 30  # of a bisection: a picture needs no more


def crossing(inside, outside, is_inside, steps=STEPS):
    """Between two numbers, where `is_inside` ends."""
    for _ in range(steps):
        middle = (inside + outside) / 2
        inside, outside = (middle, outside) if is_inside(middle) else (inside, middle)
    return inside


def upright(body1, body2):
    """The same pair, turned so that its normal points up, and moved so that the middle of its points is the origin."""
    degrees = least(body1, body2, -90, 90)
    normal = direction(degrees)
    middle = times(0.5, plus(body1.support_point(normal), body2.support_point(times(-1, normal))))
    place = lambda body: turned(minus(body.centre, middle), 90 - degrees)
    return [Superellipse(*body.axes, body.n, place(body), body.degrees + 90 - degrees) for body in (body1, body2)]


def height(body, x, towards):
    """Of the surface over x: the one above the body's inside, or with `towards` -1 the one below it."""
    low, high = body.centre[1] - 2, body.centre[1] + 2
    for _ in range(60):
        third = (high - low) / 3
        low, high = (low, high - third) if gauge(body, (x, low + third)) < gauge(body, (x, high - third)) else (low + third, high)
    return crossing(low, low + 2 * towards, lambda z: gauge(body, (x, z)) < 1)


def centre_of(columns):
    """Of the area between two curves: (x, low, high), evenly spaced."""
    whole = sum(high - low for _, low, high in columns)
    return (sum(x * (high - low) for x, low, high in columns) / whole, sum((high**2 - low**2) / 2 for _, low, high in columns) / whole)


def cut(outline, far=0.8):
    """What is near the contact, closed along the cut."""
    return [(x, z) for x, z in outline if abs(z) < far]


def draw_gap(panel, gap, rim, centre):
    """The graph of the gap over the tangent plane, a little beyond the patch."""
    ends = [crossing(x, 1.25 * x, lambda x: gap(x) < 0.25) for x in rim]
    graph = lambda a, b: [(x, 1.4 * gap(x)) for x in (a + (b - a) * k / 80 for k in range(81))]
    panel.path(graph(*rim), RIGHT, 1, fill=RIGHT, closed=True)
    panel.path(graph(*ends), INK, 2.2)
    panel.path([(-1.5, 0), (1.5, 0)], SOFT, 1, dashes="4 4")
    panel.path([(rim[0], 0), (rim[1], 0)], RIGHT, 4)
    bottom = 1.4 * gap(centre[0])
    panel.path([(centre[0], 0), (centre[0], bottom)], RIGHT, 1.4)
    panel.text((1.54, -0.04), "g = 0", SOFT, 13)
    panel.text((ends[1] + 0.08, 1.4 * gap(ends[1]) - 0.04), "gap g", INK, 13)
    panel.text((centre[0], 0.09), "patch: g < 0", RIGHT, 14, "middle", "600")
    panel.text((centre[0] + 0.06, bottom / 2 - 0.04), "depth -g", RIGHT, 13)


def patch():
    """A pair with its normal up, and below it the gap between both surfaces."""
    body1, body2 = upright(Superellipse(1.7, 0.9, 2, (0, 0), 8), Superellipse(1.25, 0.8, 3, (0.2, 1.44), -12))
    gap = lambda x: height(body2, x, -1) - height(body1, x, 1)
    rim = [crossing(0, end, lambda x: gap(x) < 0) for end in (-1.2, 1.2)]
    columns = [(x, height(body2, x, -1), height(body1, x, 1)) for x in (rim[0] + (rim[1] - rim[0]) * (k + 0.5) / 80 for k in range(80))]
    centre = centre_of(columns)
    left, right = ((x, height(body1, x, 1)) for x in rim)
    area = times(0.36, turned(minus(right, left), 90))

    picture = Picture(640, 340, 120, (280, 125), "The patch of a contact: the lens of two bodies, and the gap between their surfaces")
    for body, colour in ((body1, BODY1), (body2, BODY2)):
        picture.body(cut(body.outline()), colour)
    lens = [left, *((x, high) for x, _, high in columns), right, *((x, low) for x, low, _ in reversed(columns))]
    picture.path(lens, RIGHT, 1.6, fill=RIGHT, opacity=0.45, closed=True)
    picture.path([(-1.5, 0), (1.5, 0)], SOFT, 1, dashes="4 4")
    picture.text((1.54, -0.04), "tangent plane", SOFT, 13)
    for x, z in (left, right):
        picture.path([(x, z), (x, -1.25)], SOFT, 1, dashes="2 3")
        picture.dot((x, z), INK, 4)
    picture.arrow(centre, plus(centre, area), RIGHT, 2.6)
    picture.dot(centre, RIGHT, 4.5)
    picture.text(plus(centre, plus(area, (0.08, -0.08))), "area vector a", RIGHT, 14)
    for point, end, words in ((centre, (1.25, 0.66), "centre of depth c"), ((0.5, 0), (1.25, 0.36), "lens")):
        picture.path([point, end], SOFT, 1)
        picture.text(plus(end, (0.04, -0.03)), words, INK, 13)
    picture.text(plus(left, (-0.32, -0.12)), "rim", INK, 13, "end")
    picture.text((-1.0, -0.5), "body 1", BODY1, 14, "middle", "600")
    picture.text((-1.0, 0.5), "body 2", BODY2, 14, "middle", "600")
    draw_gap(picture.at((280, 275)), gap, rim, centre)
    return picture


class Superellipsoid:
    """|x/a|^n + |y/b|^n + |z/c|^n = 1, its axes along `axes_along`, and its centre on the z axis."""

    def __init__(self, axes, n, axes_along, height=0):
        self.axes, self.n, self.along, self.height = axes, n, axes_along, height

    def gauge(self, x, y, z):
        return sum(abs(dot(along, (x, y, z - self.height)) / axis) ** self.n for along, axis in zip(self.along, self.axes)) ** (1 / self.n)

    def half_height(self):
        """The support along z."""
        m = self.n / (self.n - 1)
        return sum(abs(axis * along[2]) ** m for along, axis in zip(self.along, self.axes)) ** (1 / m)

    def section(self, steps=360):
        """In the plane of x and z: rays from the centre."""
        rays = [direction(360 * k / steps) for k in range(steps)]
        return [plus((0, self.height), times(1 / self.gauge(x, 0, z + self.height), (x, z))) for x, z in rays]


def reach(body1, body2, x, y):
    """How far the patch goes along (x, y): to where both surfaces cross. Body 2 is above body 1."""
    def is_inside(far):
        gauges = lambda z: (body1.gauge(far * x, far * y, z), body2.gauge(far * x, far * y, z))
        z = crossing(-0.5, 0.5, lambda z: gauges(z)[0] < gauges(z)[1], 24)
        return max(gauges(z)) < 1
    return crossing(0, 1.6, is_inside, 18)


def rim_of(body1, body2, steps=96):
    """As many directions to the ends of a long patch as across it."""
    wide, high = reach(body1, body2, 1, 0), reach(body1, body2, 0, 1)
    rays = [(wide * x, high * y) for x, y in (direction(360 * k / steps) for k in range(steps))]
    return [times(reach(body1, body2, *unit(ray)), unit(ray)) for ray in rays]


ALONG = ((1, 0, 0), (0, 1, 0), (0, 0, 1))
H, T, S = math.sqrt(1 / 2), math.sqrt(1 / 3), math.sqrt(1 / 6)
TURNED = ((*direction(20), 0), (*direction(110), 0), (0, 0, 1))
ON_EDGE = ((H, 0, H), (0, 1, 0), (-H, 0, H))
ON_CORNER = ((2 * S, 0, T), (-S, H, T), (-S, -H, T))


def patch_limits(overlap=0.04, n=12):
    """Four contacts of the same overlap, from the side and along the normal, at one scale."""
    picture = Picture(640, 310, 44, (0, 0), "Four patches of the same overlap: an ellipse, a polygon, a strip and nearly a point")
    ground = ((1.25, 1.25, 0.6), n, ALONG)
    shown = [
        ("two smooth bodies", "an ellipse", ((1.25, 0.7, 0.5), 2, ALONG), ((1.1, 0.7, 0.6), 2, ALONG)),
        ("face on face", "a polygon", ((1, 1, 0.6), n, ALONG), ((1, 1, 1), n, TURNED)),
        ("edge on face", "a strip", ground, ((1, 1, 1), n, ON_EDGE)),
        ("corner on face", "nearly a point", ground, ((1, 1, 1), n, ON_CORNER)),
    ]
    for column, (name, words, lower, upper) in enumerate(shown):
        body1, body2 = Superellipsoid(*lower), Superellipsoid(*upper)
        body1.height, body2.height = overlap / 2 - body1.half_height(), body2.half_height() - overlap / 2
        side, above = picture.at((85 + 157 * column, 88)), picture.at((85 + 157 * column, 213))
        for body, colour in ((body1, BODY1), (body2, BODY2)):
            side.body([point for point in body.section() if abs(point[1]) < 1.6], colour)
        rim = rim_of(body1, body2)
        side.path([(min(rim)[0], 0), (max(rim)[0], 0)], RIGHT, 4)
        above.path(rim, RIGHT, 2, fill=RIGHT, closed=True)
        above.text((0, -1.55), name, INK, 14, "middle", "600")
        above.text((0, -1.95), words, RIGHT, 13, "middle")
    return picture


def pictures():
    return {"patch.svg": patch(), "patch-limits.svg": patch_limits()}
