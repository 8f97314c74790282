# How far body 2 must go along n until a plane across n parts the bodies: none of them is less than the depth.
import json, sys
def turned_back(q, v):  # the world to body axes
    w, x, y, z = (k / max(map(abs, q)) for k in q); s = 2 / (w*w + x*x + y*y + z*z); t = (z*v[1] - y*v[2], x*v[2] - z*v[0], y*v[0] - x*v[1])
    return v[0] + s*(w*t[0] - y*t[2] + z*t[1]), v[1] + s*(w*t[1] - z*t[0] + x*t[2]), v[2] + s*(w*t[2] - x*t[1] + y*t[0])
def support(body, n):  # of a superellipsoid, in closed form
    s = body["shape"]["superellipsoid"]; p, q = (m / (m - 1) for m in s.get("exponents", [2, 2]))
    a, b, c = (abs(r * u) for r, u in zip(s["semi_axes"], turned_back(body["orientation"]["quaternion_wxyz"], n)))
    most = max(a, b, c); a, b, c = a / most, b / most, c / most  # powers of 1e100 are none
    return most * ((a**q + b**q)**(p / q) + c**p)**(1 / p)
def o(pair, n):
    n = [u / sum(v*v for v in n)**.5 for u in n]; x, y = (body["position"] for body in pair)
    return support(pair[0], n) + support(pair[1], n) - sum(u * (b - a) for u, a, b in zip(n, x, y))
if __name__ == "__main__":  # by_hand.py CASE.json 'x y z' 'x y z': the overlap in each direction
    for n in sys.argv[2:]: print(n, o(json.load(open(sys.argv[1]))["bodies"], [float(u) for u in n.split()]))
