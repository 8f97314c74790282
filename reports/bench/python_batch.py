#!/usr/bin/python3
"""reports/bench/python_batch.py [PAIRS [PASSES]]: what numpy's arrays cost a batch, one thread.

by columns         input and answers by columns, which are read and written in place
by rows            input by rows, answers by columns (what Contacts.empty makes)
by rows, all ways  input and answers by rows
into new arrays    input by rows, answers into memory that the call asks for, over a C++ that asks for its own as well

The same pairs by plumb::solve_batch in C++ and by plumb.solve_batch in Python, in one process and in turns. Of all passes (default 9)
the least time counts, the processor's, kernel and page faults included: what else the machine does is not the question. Exit 1 where the
answers are not the same bits.
"""

import ctypes
import pathlib
import sys
import time

BUILD = pathlib.Path(__file__).absolute().parents[1] / "build/release"
sys.path.insert(0, str(BUILD / "python"))

try:
    import numpy as np
except ModuleNotFoundError:
    print(f"{sys.executable} has no numpy: install python3-numpy and call Debian's own /usr/bin/python3", file=sys.stderr)
    sys.exit(2)

import plumb

WANT = ("overlap", "normal", "points", "iterations", "evaluations")
FAMILIES = {"spheroid": None, "ellipsoid": None, "exponents 2..8": (2, 8)}
LAYOUTS = ("by columns", "by rows", "by rows, all ways", "into new arrays")


def drawn(family, n):
    """Overlaps of 1e-3 .. 5e-2 of the sum of the shortest semi-axes: the batch finds the distance, step by step."""
    random = np.random.default_rng(1)
    axes = random.uniform(1 / 3, 1, (2, n, 3))
    if family == "spheroid":
        axes[:, :, 1] = axes[:, :, 0]
    turns = random.normal(size=(2, n, 4))
    powers = [(2, 2)] * 2 if FAMILIES[family] is None else random.uniform(*FAMILIES[family], (2, n, 2))
    line = random.normal(size=(n, 3))
    line /= np.linalg.norm(line, axis=1, keepdims=True)
    wanted = 10 ** random.uniform(-3, -1.3, n) * axes.min(2).sum(0)
    distance = axes.max(2).sum(0)
    first = plumb.Bodies(axes[0], np.zeros((n, 3)), turns[0], powers[0])
    for _ in range(8):
        second = plumb.Bodies(axes[1], distance[:, None] * line, turns[1], powers[1])
        distance += plumb.solve_batch(first, second, want="overlap", threads=2).overlap - wanted
    return first, second


def arrays_of(bodies):
    return bodies.semi_axes, bodies.position, bodies.quaternion, bodies.exponents


def by_columns(bodies):
    return plumb.Bodies(*(np.asfortranarray(array) for array in arrays_of(bodies)))


def addresses(arrays):
    """Of each column; the exponents of ellipsoids are none."""
    out = []
    for array in arrays:
        columns = array.reshape(len(array), -1, order="A").T if array.ndim > 1 else [array]
        out += [column.ctypes.data for column in columns]
    return out


def body_addresses(bodies):
    out = addresses(arrays_of(bodies)[:3])
    out += addresses([bodies.exponents]) if bodies.exponents.ndim == 2 else [None, None]
    return (ctypes.c_void_p * 12)(*out)


def contact_addresses(contacts):
    points = [contacts.points[:, k] for k in (0, 1)]
    numbers = addresses([contacts.overlap, contacts.normal, *points, contacts.contact_point])
    words = addresses([contacts.status, contacts.verdict, contacts.iterations, contacts.evaluations])
    return (ctypes.c_void_p * 13)(*numbers), (ctypes.c_void_p * 4)(*words)


def time_of(work):
    start = time.thread_time()
    work()
    return time.thread_time() - start


def same_bits(one, other):
    return all(np.array_equal(value, vars(other)[name], equal_nan=True) for name, value in vars(one).items())


def measure(family, n, passes):
    library = ctypes.CDLL(str(BUILD / "bin/plumb_time_batch.so"))
    library.plumb_time_batch.restype = ctypes.c_double
    rows = drawn(family, n)
    columns = [by_columns(bodies) for bodies in rows]
    cpp, *outs = [plumb.Contacts.empty(n, WANT, order) for order in "FFFC"]
    bodies = [ctypes.c_size_t(n), *map(body_addresses, columns)]
    arguments = contact_addresses(cpp)
    calls = (
        lambda: plumb.solve_batch(*columns, out=outs[0]),
        lambda: plumb.solve_batch(*rows, out=outs[1]),
        lambda: plumb.solve_batch(*rows, out=outs[2]),
        lambda: plumb.solve_batch(*rows, want=WANT),
    )
    least = np.full(2 + len(calls), np.inf)
    for _ in range(passes):
        cpp_times = [library.plumb_time_batch(*bodies, *arguments), library.plumb_time_batch(*bodies, None, None)]
        least = np.minimum(least, [*cpp_times, *map(time_of, calls)])
    if not all(same_bits(cpp, out) for out in outs):
        sys.exit(f"{family}: other bits than C++")
    return least


def main(n=1_000_000, passes=9):
    print(f"{n} pairs, least of {passes} passes; Python's time over that of C++\n")
    print(f"{'pairs':<16}{'C++, ns a pair':>16}" + "".join(f"{layout:>19}" for layout in LAYOUTS))
    for family in FAMILIES:
        cpp, cpp_new, *python = measure(family, n, passes)
        ratios = [seconds / cpp for seconds in python[:-1]] + [python[-1] / cpp_new]
        print(f"{family:<16}{cpp / n * 1e9:>16.1f}" + "".join(f"{ratio:>19.3f}" for ratio in ratios), flush=True)


if __name__ == "__main__":
    main(*map(int, sys.argv[1:]))
