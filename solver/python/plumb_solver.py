"""The process door of plumb for a contact solver in Python: this file alone, Python 3.9 or later, nothing else.

    from plumb_solver import serve

    def solve(pair):                    # called for one pair after the other
        one, two = pair.bodies
        ...
        return pair.answer(overlap, normal, points)     # or None: refused

    serve(solve, {"name": "mine", "shapes": "ellipsoids"})

Then `plumb campaign --family all --cases 1000 --seed 1 --solver-command 'python3 mine.py' --out DIR` judges it. The abilities are the fields
of corpus/solvers/abilities.hpp: what is not claimed is not asked. Standard output is plumb's: print() goes to standard error here.

A pair comes in safe numbers: world axes, origin at body 1, lengths in a power of two that puts the largest semi-axis into [1, 2).
`pair.answer` takes lengths and points in the same and brings them back.
"""

import json
import math
import sys
import time


class Body:
    """(|x/a|^n2 + |y/b|^n2)^(n1/n2) + |z/c|^n1 = 1 in body axes, turned and placed.

    semi_axes: (a, b, c); exponents: (n1, n2); position; rotation: three rows, takes body axes to world axes.
    """

    def __init__(self, semi_axes, exponents, position, rotation):
        self.semi_axes, self.exponents, self.position, self.rotation = semi_axes, exponents, position, rotation

    def to_world(self, vector):
        """A direction of the body's axes in the world's."""
        return tuple(sum(r * v for r, v in zip(row, vector)) for row in self.rotation)

    def to_body(self, vector):
        """A direction of the world's axes in the body's."""
        return tuple(sum(self.rotation[i][j] * vector[i] for i in range(3)) for j in range(3))

    def support_point(self, direction):
        """The point of the body that lies furthest along a direction of any length above 0."""
        n1, n2 = self.exponents
        local = self.to_body(direction)
        q = [a * u for a, u in zip(self.semi_axes, local)]
        largest = max(map(abs, q))
        x, y, z = (v / largest for v in q)
        (s, (x, y)), m1 = _norm_gradient(x, y, n2 / (n2 - 1)), n1 / (n1 - 1)
        _, (ring, z) = _norm_gradient(s, z, m1)
        gradient = (ring * x, ring * y, z)
        at = self.to_world([a * g for a, g in zip(self.semi_axes, gradient)])
        return tuple(p + v for p, v in zip(self.position, at))


def _norm_gradient(x, y, m):
    """(|x|^m + |y|^m)^(1/m) and its gradient; 0 and zeros at the origin."""
    top = max(abs(x), abs(y))
    if top == 0:
        return 0.0, (0.0, 0.0)
    norm = top * (abs(x / top) ** m + abs(y / top) ** m) ** (1 / m)
    return norm, tuple(math.copysign(abs(v / norm) ** (m - 1), v) for v in (x, y))


def _rotation(quaternion):
    largest = max(map(abs, quaternion))
    w, x, y, z = (v / largest for v in quaternion)
    norm = math.sqrt(w * w + x * x + y * y + z * z)
    w, x, y, z = w / norm, x / norm, y / norm, z / norm
    return (
        (1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)),
        (2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)),
        (2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)),
    )


class Pair:
    """bodies: two Body; last: the answer a step before in the same numbers, as a dict, or None; request: what plumb sent."""

    def __init__(self, request):
        self.request = request
        raw = request["bodies"]
        shapes = [body["shape"]["superellipsoid"] for body in raw]
        self._exponent = math.frexp(max(max(shape["semi_axes"]) for shape in shapes))[1] - 1
        self._origin = raw[0]["position"]
        self.bodies = tuple(
            Body(
                self._scaled(shape["semi_axes"]),
                tuple(map(float, shape.get("exponents", (2, 2)))),
                self._inward(body["position"]),
                _rotation(body["orientation"]["quaternion_wxyz"]),
            )
            for shape, body in zip(shapes, raw)
        )
        self.last = self._inward_answer(request["last"]) if "last" in request else None

    def answer(self, overlap=None, normal=None, points=None, contact_point=None, status="converged", verdict=None, **others):
        """The reply in the caller's numbers. verdict: the overlap's unless it says otherwise; contact_point: between the points;
        normal: unit, from body 1 to body 2; others: iterations, evaluations. None, and what is not finite: not known."""
        if contact_point is None and points is not None:
            contact_point = [(p + q) / 2 for p, q in zip(*points)]
        fields = dict(others, status=status, verdict=verdict, overlap=self._outward_length(overlap))
        fields["normal"] = None if normal is None else [float(v) for v in normal]
        fields["points"] = None if points is None else [self._outward(point) for point in points]
        fields["contact_point"] = None if contact_point is None else self._outward(contact_point)
        return {key: value for key, value in fields.items() if _is_finite(value)}

    def _scaled(self, lengths):
        return tuple(math.ldexp(v, -self._exponent) for v in lengths)

    def _inward(self, point):
        return self._scaled([v - o for v, o in zip(point, self._origin)])

    def _inward_answer(self, answer):
        out = dict(answer)
        if "overlap" in out:
            out["overlap"] = self._scaled([out["overlap"]])[0]
        if "points" in out:
            out["points"] = [self._inward(point) for point in out["points"]]
        if "contact_point" in out:
            out["contact_point"] = self._inward(out["contact_point"])
        return out

    def _outward_length(self, length):
        try:
            return None if length is None else math.ldexp(length, self._exponent)
        except OverflowError:
            return None

    def _outward(self, point):
        lengths = [self._outward_length(v) for v in point]
        return None if None in lengths else [o + v for o, v in zip(self._origin, lengths)]


def _is_finite(value):
    if isinstance(value, (list, tuple)):
        return all(map(_is_finite, value))
    return value is not None and (isinstance(value, str) or math.isfinite(value))


def serve(solve, abilities):
    """Answers plumb until plumb ends. `solve` takes a Pair and returns pair.answer(..), or None where it refuses the pair."""
    out, sys.stdout = sys.stdout, sys.stderr

    def say(message):
        out.write(json.dumps(message, allow_nan=False) + "\n")
        out.flush()

    say(abilities)
    for line in sys.stdin:
        request = json.loads(line)
        pair = Pair(request)
        start = time.perf_counter_ns()
        answer = solve(pair)
        took = time.perf_counter_ns() - start
        reply = {"refused": True} if answer is None else answer
        say({"number": request["number"], "ns": took, **reply})
