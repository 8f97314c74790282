"""Pictures of contacts: what an answer holds, which normals there are, and what can be wrong with one."""
import math

from shapes import Superellipse, degrees_between, direction, dot, gauge, least, length, minima, minus, overlap, plus, times, turned, unit
from svg import BODY1, BODY2, INK, RIGHT, SOFT, WRONG, Picture


def both(picture, body1, body2):
    picture.body(body1.outline(), BODY1)
    picture.body(body2.outline(), BODY2)


def support_points(body1, body2, normal):
    return body1.support_point(normal), body2.support_point(times(-1, normal))


def plane(picture, point, normal, reach=0.62):
    along = turned(normal, 90)
    picture.path([plus(point, times(-reach, along)), plus(point, times(reach, along))], SOFT, 1, dashes="4 4")


def label_contact(panel, body1, body2, words):
    both(panel, body1, body2)
    normal = direction(least(body1, body2, -90, 90))
    p1, p2 = support_points(body1, body2, normal)
    side = turned(normal, -90)
    for point in (p1, p2):
        plane(panel, point, normal)
        panel.dot(point, INK, 4)
    middle = times(0.5, plus(p1, p2))
    panel.arrow(middle, plus(middle, times(0.62, normal)), RIGHT, 2.6)
    panel.text(plus(middle, times(0.7, normal)), "normal", RIGHT, 14)
    panel.dot(middle, RIGHT, 4)
    at1, at2 = plus(p1, times(0.62, side)), plus(p2, times(0.62, side))
    panel.path([at1, at2], INK, 2.2)
    panel.text(plus(times(0.5, plus(at1, at2)), (0.04, -0.2)), words.format(overlap(body1, body2, normal)), INK, 14)
    return p1, p2


def contact():
    """What an answer holds, of bodies in each other and of bodies apart."""
    picture = Picture(640, 310, 96, (120, 185), "A contact of overlapping bodies, and one of bodies apart")
    body1 = Superellipse(1, 0.62, 2, (0, 0), 15)
    p1, p2 = label_contact(picture, body1, Superellipse(0.75, 0.6, 6, (1.3, 0.42), 25), "overlap {:.2f}")
    for point, end, words in ((p1, (1.0, 1.28), "point on body 1"), (p2, (0.2, 1.02), "point on body 2")):
        picture.path([point, end], SOFT, 1)
        picture.text(plus(end, (0.02, 0.05)), words, INK, 13, "end")
    picture.text((-0.35, -0.15), "body 1", BODY1, 14, "middle", "600")
    picture.text((1.62, 0.1), "body 2", BODY2, 14, "middle", "600")
    panel = picture.at((430, 190), scale=70)
    label_contact(panel, body1, Superellipse(0.75, 0.6, 6, (1.75, 0.75), 25), "overlap {:.2f}")
    panel.text((0.5, -1.45), "apart: minus the distance", SOFT, 13, "middle")
    picture.text((0.55, -1.1), "in each other: the depth", SOFT, 13, "middle")
    return picture


DEEP = Superellipse(1, 0.4, 2), Superellipse(1, 0.4, 2, (0.25, 0.42), 30)


def several_minima():
    """The overlap over all directions, and the common normals at its minima."""
    picture = Picture(640, 280, 90, (120, 160), "Two deep bodies and the overlap over all directions: several minima")
    both(picture, *DEEP)
    panel = picture.at((290, 240), scale=1)
    panel.path([(0, 0), (330, 0)], SOFT, 1)
    panel.path([(0, 0), (0, 200)], SOFT, 1)
    panel.text((330, -20), "direction, 0 to 360 degrees", SOFT, 13, "end")
    panel.text((0, 206), "overlap", SOFT, 13)
    place = lambda degrees: (330 * degrees / 360, 95 * overlap(*DEEP, direction(degrees)))
    panel.path([place(k) for k in range(361)], INK, 2.2)
    found = minima(*DEEP)
    for degrees in found:
        is_lowest = degrees == min(found, key=lambda angle: place(angle)[1])
        colour, p1 = RIGHT if is_lowest else WRONG, DEEP[0].support_point(direction(degrees))
        picture.arrow(p1, plus(p1, times(0.5, direction(degrees))), colour)
        panel.dot(place(degrees), colour, 5)
        words = "the contact" if is_lowest else "not the lowest"
        panel.text(plus(place(degrees), (0, -20)), words, colour, 13, "middle")
    return picture


def fan(picture, block, angles):
    ends = [block.support_point(direction(angle)) for angle in angles]
    for angle, point in zip(angles, ends):
        picture.arrow(point, plus(point, times(0.4, direction(angle))), INK, 1.6, 7)
        picture.dot(point, INK, 2.6)
    return length(minus(ends[-1], ends[0]))


def edge():
    block = Superellipse(1, 1, 8)
    picture = Picture(420, 240, 90, (170, 190), "An edge: the normal turns, the point hardly moves")
    picture.body([point for point in block.outline() if point[1] > -0.35], BODY1)
    moved = fan(picture, block, range(10, 81, 10))
    for row, words in enumerate(("the normal turns", "by 70 degrees, the", f"point moves by {moved:.2f}", "of the semi-axis")):
        picture.text((-0.05, 0.5 - 0.22 * row), words, SOFT, 14, "middle")
    return picture


def rolling_ball():
    body = Superellipse(1, 0.55, 2)
    radius = 0.55**2
    picture = Picture(420, 220, 140, (210, 110), "The largest ball that rolls along the inside and touches every point")
    picture.body(body.outline(), BODY1)
    for angle in (0, 55, 125, 180):
        normal = direction(angle)
        centre = minus(body.support_point(normal), times(radius, normal))
        picture.path([plus(centre, times(radius, direction(6 * k))) for k in range(60)], RIGHT, 1.6, closed=True)
        picture.dot(body.support_point(normal), RIGHT)
    picture.text((0, -0.06), f"inner rolling radius {radius:.2f}", RIGHT, 13, "middle")
    return picture


def deepest(body, other):
    """The point of the one body that is deepest in the other."""
    return min((body.support_point(direction(k / 40)) for k in range(14400)), key=lambda point: gauge(other, point))


def midway(body1, body2):
    """The point where the larger of both potentials is least: there they are equal, and their gradients opposite."""
    best, step = times(0.5, plus(body1.centre, body2.centre)), 0.5
    worst = lambda point: max(gauge(body1, point), gauge(body2, point))
    while step > 1e-9:
        tried = min((plus(best, times(step, direction(5 * k))) for k in range(72)), key=worst)
        best, step = (tried, step) if worst(tried) < worst(best) else (best, step / 2)
    return best


def gradient(body, point, h=1e-6):
    slope = [(gauge(body, plus(point, e)) - gauge(body, minus(point, e))) / (2 * h) for e in ((h, 0), (0, h))]
    return unit(slope)


def first_touch(body1, body2):
    """The normal when body 2 has gone back along the line of centres until it touches body 1."""
    line, low, high = unit(minus(body2.centre, body1.centre)), 0, 2
    for _ in range(50):
        middle = (low + high) / 2
        moved = Superellipse(*body2.axes, body2.n, plus(body2.centre, times(middle, line)), body2.degrees)
        degrees = least(body1, moved, -60, 120, 1800)
        low, high = (middle, high) if overlap(body1, moved, direction(degrees)) > 0 else (low, middle)
    return direction(degrees)


def four_problems():
    body1, body2 = Superellipse(1, 0.5, 2, (0, 0), 10), Superellipse(1, 0.5, 2, (1.05, 0.55), 80)
    picture = Picture(640, 300, 96, (130, 190), "One pair, four questions, four normals")
    both(picture, body1, body2)
    common = direction(least(body1, body2, -60, 120))
    p1, p2 = deepest(body1, body2), deepest(body2, body1)
    shared = midway(body1, body2)
    answers = [
        ("common normal", RIGHT, common, support_points(body1, body2, common)),
        ("deepest points", WRONG, unit(minus(p1, p2)), (p1, p2)),
        ("midway", INK, gradient(body1, shared), (shared,)),
        ("first touch", SOFT, first_touch(body1, body2), ()),
    ]
    panel = picture.at((285, 215), scale=110)
    for row, (name, colour, normal, points) in enumerate(answers):
        for point in points:
            picture.dot(point, colour, 4)
        if len(points) == 2:
            picture.path(points, colour, 1.8, dashes="5 3")
        panel.arrow((0, 0), times(0.9, normal), colour)
        off = degrees_between(normal, common)
        panel.label((410, 120 + 26 * row), name, colour, 14, "start", "600")
        panel.label((540, 120 + 26 * row), f"{off:.1f} degrees" if off > 1e-3 else "0", colour, 14)
    panel.label((410, 94), "turned from the common normal", SOFT, 12.5)
    panel.label((345, 250), "the normals, from one point", SOFT, 13, "middle")
    return picture


def tilted_faces():
    picture = Picture(640, 220, 64, (110, 130), "Two faces tilted by less and less: the points still move, the normal does not")
    for column, tilt in enumerate((3, 0.03, 0.0003)):
        panel = picture.at((110 + 210 * column, 140))
        body1, body2 = Superellipse(1, 0.6, 8), Superellipse(1, 0.6, 8, (0, 1.15), tilt)
        both(panel, body1, body2)
        normal = direction(least(body1, body2, 90 - tilt, 90 + tilt))
        p1 = body1.support_point(normal)
        panel.arrow(p1, plus(p1, times(0.9, normal)), RIGHT)
        panel.dot(p1, RIGHT, 4)
        panel.text((0, -0.85), f"tilt {tilt:g} degrees", INK, 13, "middle", "600")
        panel.text((0, -1.12), f"point {abs(p1[0]):.2f} from the middle", SOFT, 13, "middle")
    return picture


def naive_normal():
    picture = Picture(560, 270, 80, (130, 150), "A normal along the line of centres: right for spheres alone")
    for origin, body2 in (((110, 160), Superellipse(0.8, 0.8, 2, (1.15, 0.85))), ((370, 160), Superellipse(1.15, 0.55, 2, (1.0, 0.95), -25))):
        panel, body1 = picture.at(origin), Superellipse(0.8, 0.8, 2)
        both(panel, body1, body2)
        line, common = unit(body2.centre), direction(least(body1, body2, -60, 160))
        panel.path([(0, 0), body2.centre], SOFT, 1, dashes="4 4")
        start = body1.support_point(common)
        panel.arrow(start, plus(start, times(0.9, common)), RIGHT)
        off = degrees_between(line, common)
        if off > 0.1:
            panel.arrow(body1.support_point(line), plus(body1.support_point(line), times(0.9, line)), WRONG)
        panel.text((0.4, -1.2), f"line of centres: {off:.0f} degrees off", WRONG if off > 0.1 else RIGHT, 13, "middle")
    return picture


def draw_answer(panel, p1, p2, normal, colour):
    panel.path([p1, p2], colour, 1.8, dashes="4 3")
    panel.arrow(p1, plus(p1, times(0.6, normal)), colour, 2, 8)
    panel.dot(p1, colour)
    panel.dot(p2, colour)


def cell(picture, place, name, words):
    panel = picture.at((80 + 210 * (place % 3), 92 + 190 * (place // 3)), scale=52)
    panel.text((0.65, -1.22), name, RIGHT if name == "none" else WRONG, 14, "middle", "600")
    panel.text((0.65, -1.57), words, SOFT, 12.5, "middle")
    return panel


def findings():
    """Six answers to a pair, by the judge's word on each."""
    picture = Picture(640, 390, 52, (0, 0), "A right answer and five wrong ones")
    pair = Superellipse(1, 0.6, 2, (0, 0), 20), Superellipse(0.8, 0.6, 2, (1.3, 0.5), -30)
    apart = pair[0], Superellipse(0.8, 0.6, 2, (1.55, 0.95), -30)
    right = direction(least(*pair, -60, 90))
    p1, p2 = support_points(*pair, right)
    other = direction(62)
    shown = [  # name, words, bodies, what is drawn of the answer
        ("none", "a common normal, the lowest", pair, (p1, p2, right)),
        ("misaligned", "line not along the normals", pair, (pair[0].support_point(other), pair[1].support_point(direction(200)), other)),
        ("off_surface", "a point is on no surface", pair, (plus(p1, times(-0.9, right)), p2, right)),
        ("wrong_branch", "a common normal, not the lowest", DEEP, None),
        ("missed_contact", "says separated", pair, None),
        ("false_contact", "says overlapping", apart, None),
    ]
    for place, (name, words, bodies, answer) in enumerate(shown):
        panel = cell(picture, place, name, words)
        both(panel, *bodies)
        if name == "wrong_branch":
            highest = direction(max(minima(*DEEP), key=lambda angle: overlap(*DEEP, direction(angle))))
            answer = (*support_points(*DEEP, highest), highest)
        if name not in ("missed_contact", "false_contact"):
            draw_answer(panel, *answer, RIGHT if name == "none" else WRONG)
    return picture


def pictures():
    drawn = (contact, several_minima, edge, rolling_ball, four_problems, tilted_faces, naive_normal, findings)
    return {f"{draw.__name__.replace('_', '-')}.svg": draw() for draw in drawn}
