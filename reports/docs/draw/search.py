"""Pictures of the search for the lowest overlap, in the plane: directions are angles, and cells are intervals of them."""
import math

from contacts import DEEP
from shapes import Superellipse, direction, dot, least, overlap, plus, witness_of
from svg import BODY1, INK, RIGHT, SOFT, WRONG, Picture


def is_convex(cell, level, steps=40):
    """Whether the overlap less the level, times |v|, is convex over the cell: o + o'' is above the level."""
    low, high = cell
    h = (high - low) / steps
    o = [overlap(*DEEP, direction(low + k * h)) for k in range(-1, steps + 2)]
    bend = lambda k: (o[k - 1] - 2 * o[k] + o[k + 1]) / math.radians(h) ** 2
    return all(o[k] + bend(k) > level for k in range(1, steps + 2))


def reason(cell, level, lowest):
    """Why nothing lower is in the cell; "" where that is not known yet."""
    low, high = cell
    q = witness_of(*DEEP, (low + high) / 2)
    if all(dot(direction(end), q) > level for end in cell):
        return "witness"
    return "convex" if low < lowest < high and is_convex(cell, level) else ""


def cut(cell, depth, level, lowest):
    """The cells with their depth and reason, those that had to be cut among them."""
    why = reason(cell, level, lowest)
    if why or depth == 8:
        return [(cell, depth, why)]
    middle = sum(cell) / 2
    return [(cell, depth, ""), *cut((cell[0], middle), depth + 1, level, lowest), *cut((middle, cell[1]), depth + 1, level, lowest)]


def cover():
    lowest = least(*DEEP, 0, 360)
    level = overlap(*DEEP, direction(lowest))
    cells = [cell for side in range(4) for cell in cut((90 * side, 90 * side + 90), 0, level, lowest)]
    deepest = max(depth for _, depth, _ in cells)
    picture = Picture(640, 260 + 24 * (deepest + 1), 1, (30, 190), "All directions cut into cells, each with the reason why nothing lower is in it")
    place = lambda angle, height: (580 * angle / 360, height)
    picture.path([place(k, 75 * overlap(*DEEP, direction(k)) + 5) for k in range(361)], INK, 2.2)
    picture.path([place(0, 75 * level + 5), place(360, 75 * level + 5)], WRONG, 1.4, dashes="6 4")
    picture.text(place(0, 75 * level - 12), "incumbent: the lowest overlap known", WRONG, 13)
    picture.text(place(0, 172), "overlap over all directions", SOFT, 13)
    for (low, high), depth, why in cells:
        top, bottom = -14 - 24 * depth, -34 - 24 * depth
        corners = [place(low, top), place(high, top), place(high, bottom), place(low, bottom)]
        colour = {"witness": BODY1, "convex": RIGHT, "": SOFT}[why]
        picture.path(corners, colour, 1, fill=colour if why else "none", opacity=0.45, closed=True)
    foot = -14 - 24 * (deepest + 1) - 22
    for x, colour, words in ((0, BODY1, "excluded by a witness"), (205, RIGHT, "convex: one minimum"), (400, SOFT, "cut in two, a row below")):
        picture.path([(x, foot), (x + 14, foot), (x + 14, foot + 12), (x, foot + 12)], colour, 1, fill=colour if colour != SOFT else "none", opacity=0.45, closed=True)
        picture.text((x + 20, foot + 1), words, SOFT, 13)
    return picture


def newton(body1, body2, degrees, h=1e-3):
    """The directions of Newton's method on the slope of the overlap, from this one to where the slope is 0."""
    o = lambda angle: overlap(body1, body2, direction(angle))
    taken = [degrees]
    while len(taken) < 30:
        slope = (o(degrees + h) - o(degrees - h)) / (2 * h)
        bend = (o(degrees + h) - 2 * o(degrees) + o(degrees - h)) / h**2
        step = max(-25, min(25, -slope / abs(bend)))
        degrees += step
        if abs(step) < 1e-2:
            return taken
        taken.append(degrees)
    return taken


def warm_start():
    body1, before, now = Superellipse(1, 0.4, 2), Superellipse(1, 0.4, 2, (0.75, 0.75), 20), Superellipse(1, 0.4, 2, (0.7, 0.73), 22)
    last = least(body1, before, 0, 180)
    cold = math.degrees(math.atan2(now.centre[1], now.centre[0]))
    picture = Picture(640, 270, 1, (50, 215), "A cold start and a warm start")
    place = lambda angle, value: (5 * (angle - 30), 190 * value + 60)
    for body2, colour, words, down in ((before, SOFT, "a step earlier", 30), (now, INK, "now", 4)):
        curve = [place(k, overlap(body1, body2, direction(k))) for k in range(32, 141)]
        curve = [point for point in curve if point[1] < 190]
        picture.path(curve, colour, 2.2 if body2 is now else 1.4, dashes="" if body2 is now else "5 4")
        picture.text(plus(curve[-1], (6, -down)), words, colour, 13)
    for start, colour, words, row in ((cold, WRONG, "cold, from the line of centres", 0), (last, RIGHT, "warm, from the last normal", 1)):
        taken = newton(body1, now, start)
        for k, angle in enumerate(taken):
            picture.dot(place(angle, overlap(body1, now, direction(angle))), colour, 5.5 if k == 0 else 3.4)
        picture.text((120, 20 - 22 * row), f"{words}: {len(taken)} steps", colour, 14)
    picture.path([(0, -22), (540, -22)], SOFT, 1)
    picture.text((540, -42), "direction", SOFT, 13, "end")
    return picture


def pictures():
    return {"cover.svg": cover(), "warm-start.svg": warm_start()}
