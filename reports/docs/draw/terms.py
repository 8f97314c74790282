"""The pictures of the glossary's terms: each is drawn from the closed forms, none by hand."""
import math

from shapes import Superellipse, direction, dot, least, minus, overlap, plus, times, unit, witness_of
from svg import BODY1, BODY2, INK, RIGHT, SOFT, WRONG, Picture


def exponents():
    picture = Picture(640, 170, 60, (80, 76), "One superellipse with four exponents")
    for column, n in enumerate((1.2, 2, 4, 20)):
        panel = picture.at((80 + 160 * column, 76))
        panel.body(Superellipse(1, 1, n).outline(), BODY1)
        panel.text((0, -1.35), f"exponent {n}", SOFT, 13, "middle")
    return picture


def flat():
    block = Superellipse(1, 1, 8)
    picture = Picture(420, 230, 90, (210, 150), "A flat: the normal hardly turns along it")
    picture.body([point for point in block.outline() if point[1] > -0.62], BODY1)
    ends = []
    for ratio in (-0.6, -0.4, -0.2, 0, 0.2, 0.4, 0.6):
        point = block.quarter(ratio, True)
        normal = unit((math.copysign(abs(ratio) ** 7, ratio), 1))
        ends.append(normal)
        picture.arrow(point, plus(point, times(0.42, normal)), INK, 1.8, 8)
        picture.dot(point, INK, 3)
    turn = math.degrees(2 * math.atan2(*ends[-1]))
    for row, words in enumerate(("over 0.6 of the face", "the normal turns", f"by {turn:.1f} degrees")):
        picture.text((0, 0.42 - 0.24 * row), words, SOFT, 14, "middle")
    return picture


def curvature(n, x):
    """Of |x|^n + |y|^n = 1, near (0, 1)."""
    y = (1 - abs(x) ** n) ** (1 / n)
    return (n - 1) * abs(x * y) ** (n - 2) / (abs(x) ** (2 * n - 2) + y ** (2 * n - 2)) ** 1.5


def axes(panel, right, top, across, up):
    panel.path([(right[0], 0), (right[1], 0)], SOFT, 1)
    panel.path([(right[0], 0), (right[0], top)], SOFT, 1)
    panel.text((right[1], -0.16 * top), across, SOFT, 13, "end")
    panel.text((right[0], top * 1.04), up, SOFT, 13)


def fold():
    picture = Picture(640, 230, 78, (110, 115), "A fold: where the curvature vanishes, or has no bound")
    shape = Superellipse(1, 1, 1.5)
    picture.body(shape.outline(), BODY1)
    for point in ((1, 0), (-1, 0), (0, 1), (0, -1)):
        picture.dot(point, WRONG, 4.5)
    picture.text((0, -0.06), "exponent 1.5", SOFT, 13, "middle")
    panel = picture.at((430, 195), scale=1)
    axes(panel, (-190, 190), 160, "place along the surface, the fold in the middle", "curvature")
    for n, colour, words, at in ((1.5, WRONG, "exponent 1.5: no bound", (14, 148)), (2, SOFT, "exponent 2", (-186, 62)), (3, BODY1, "exponent 3: zero", (80, 84))):
        for side in (-1, 1):
            line = [(side * 330 * x, 50 * curvature(n, x)) for x in (k / 400 for k in range(1, 221))]
            panel.path([point for point in line if point[1] < 155], colour, 2)
        panel.text(at, words, colour, 13)
    return picture


def circle_of_minima():
    lower, upper = Superellipse(0.5, 1, 2), Superellipse(0.5, 1, 2, (0, 0.5))
    picture = Picture(420, 290, 88, (150, 180), "A circle of minima: two needles on one axis")
    picture.body(lower.outline(), BODY1)
    picture.body(upper.outline(), BODY2)
    normal = direction(least(lower, upper, -60, 60))
    radius, height = lower.support_point(normal)
    ring = lambda degrees, reach: (reach * math.cos(math.radians(degrees)), height + 0.3 * reach * math.sin(math.radians(degrees)))
    picture.path([ring(10 * k, radius) for k in range(36)], RIGHT, 1.4, closed=True)
    picture.path([(0, -1.15), (0, 1.7)], SOFT, 1, dashes="4 4")
    for angle in range(15, 375, 30):
        reach = radius + 0.5 * normal[0]
        end = ring(angle, reach)
        picture.arrow(ring(angle, radius), (end[0], end[1] + 0.5 * normal[1]), RIGHT, 1.6, 7)
    picture.text((0.95, 0.2), "all around,", RIGHT, 13)
    picture.text((0.95, 0), "the same overlap", RIGHT, 13)
    return picture


def tie():
    first, second = Superellipse(1, 1, 8), Superellipse(1, 1, 8, (1.4, 1.4))
    picture = Picture(420, 300, 76, (140, 200), "A tie: two normals, one overlap")
    picture.body(first.outline(), BODY1)
    picture.body(second.outline(), BODY2)
    for degrees in (least(first, second, -20, 40), least(first, second, 50, 110)):
        normal = direction(degrees)
        start = first.support_point(normal)
        picture.arrow(start, plus(start, times(0.75, normal)), RIGHT)
        picture.dot(start, RIGHT)
    o = overlap(first, second, normal)
    picture.text((1.15, -0.4), f"both normals: overlap {o:.3f}", RIGHT, 13)
    return picture


def witness():
    first, second = Superellipse(1, 0.4, 2), Superellipse(1, 0.4, 2, (0.4, 0.5), 20)
    lowest = least(first, second, 0, 180)
    level, q = overlap(first, second, direction(lowest)), witness_of(first, second, 20)
    picture = Picture(640, 290, 1, (40, 250), "A witness excludes directions")
    axes(picture, (0, 560), 210, "direction", "overlap")
    drawn = lambda value: [((angle + 60) * 3, 92 * value(direction(angle)) + 6) for angle in range(-60, 127)]
    o, bound = lambda n: overlap(first, second, n), lambda n: dot(n, q)
    inside = [point for point in drawn(bound) if point[1] > 92 * level + 6]
    base = 92 * level + 6
    picture.path([(inside[0][0], base), *inside, (inside[-1][0], base)], RIGHT, 0, fill=RIGHT, opacity=0.12, closed=True)
    picture.path(drawn(o), INK, 2.4)
    picture.path([point for point in drawn(bound) if point[1] > 0], RIGHT, 2)
    picture.path([(0, base), (560, base)], WRONG, 1.4, dashes="6 4")
    picture.text((240, 92 * o(direction(20)) + 30), "o, the overlap over directions", INK, 13, "middle")
    picture.text((0.45 * inside[-1][0], base + 40), "the witness is above the level: excluded", RIGHT, 13, "middle")
    picture.text((8, base - 16), "level: the lowest overlap known", WRONG, 13)
    return picture


def groove():
    first, second = Superellipse(1, 1, 30), Superellipse(1, 1, 30, (1.6, 0))
    one, other = witness_of(first, second, -12), witness_of(first, second, 12)
    mixture = times(0.5, plus(one, other))
    picture = Picture(640, 270, 1, (320, 232), "A groove: one witness does not do, a mixture of two does")
    place = lambda value: [(14 * angle / 2, 200 * value(direction(angle / 2))) for angle in range(-40, 41)]
    within = lambda points: [point for point in points if 0 < point[1] < 205]
    axes(picture, (-280, 280), 200, "direction", "overlap")
    level = 0.3
    picture.path([(-280, 200 * level), (280, 200 * level)], WRONG, 1.4, dashes="6 4")
    picture.path(within(place(lambda n: overlap(first, second, n))), INK, 2.6)
    for q in (one, other):
        picture.path(within(place(lambda n: dot(n, q))), BODY1, 1.6)
    picture.path(place(lambda n: dot(n, mixture)), RIGHT, 2.2)
    picture.text((-276, 200 * level - 16), "level", WRONG, 13)
    picture.text((80, 86), "half of each: above the level", RIGHT, 13)
    picture.text((0, 10), "two witnesses: each falls below it", BODY1, 13, "middle")
    picture.text((206, 130), "o, the overlap", INK, 13)
    return picture


def chart():
    picture = Picture(640, 250, 86, (150, 112), "A chart: equal steps on it, and equal steps of the normal")
    block = Superellipse(1, 1, 8)
    by_normal = [block.support_point(direction(15 * k)) for k in range(24)]
    ratios = [k / 3 for k in range(-3, 3)]
    quarter = [block.quarter(t, False) for t in ratios] + [block.quarter(-t, True) for t in ratios]
    by_chart = quarter + [times(-1, point) for point in quarter]
    for origin, points, words in (((150, 112), by_normal, "equal steps of the normal"), ((470, 112), by_chart, "equal steps of the chart")):
        panel = picture.at(origin)
        panel.body(block.outline(), BODY1)
        for point in points:
            panel.dot(point, WRONG if points is by_normal else RIGHT)
        panel.text((0, -1.4), words, SOFT, 14, "middle")
    return picture


def pictures():
    return {f"{draw.__name__.replace('_', '-')}.svg": draw() for draw in (exponents, flat, fold, circle_of_minima, tie, witness, groove, chart)}
