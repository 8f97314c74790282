"""What a step costs in LAMMPS: read of its logs, and a model of it for more bodies and processes.

A process has n bodies of its own and g ghosts, those of its neighbours within the cutoff of ghosts. A step of it takes own * n + ghost * g seconds: own is
measured on one process, which has no ghosts, ghost on two. Left out are the network's latency and waiting for a process that has more bodies."""

import dataclasses
import itertools
import math
import re

PATTERNS = {
    "seconds": r"Loop time of (\S+) on \d+ procs",
    "ranks": r"Loop time of \S+ on (\d+) procs",
    "steps": r"Loop time of \S+ on \d+ procs for (\d+) steps",
    "bodies": r"Loop time of .* steps with (\d+) atoms",
    "ghosts": r"Nghost:\s+(\S+) ave",
    "cutoff": r"ghost atom cutoff = (\S+)",
    "memory": r"Maximum resident set size: (\S+) Mbyte",
}


@dataclasses.dataclass
class Run:
    """Seconds of a step; ghosts, a process's mean; Mbyte of the first process; the cutoff of ghosts, m."""

    bodies: int
    ranks: int
    step: float
    ghosts: float
    memory: float
    cutoff: float


def read(log):
    """Raises ValueError where the log lacks a number."""
    found = {}
    for name, pattern in PATTERNS.items():
        match = re.findall(pattern, log)
        if not match:
            raise ValueError(f"the log has no {name}: {pattern}")
        found[name] = float(match[-1])
    return Run(int(found["bodies"]), int(found["ranks"]), found["seconds"] / found["steps"], found["ghosts"], found["memory"],
               found["cutoff"])


def cell_inside(places, radius):
    """m^3 of the bed a body: from how many centres lie within a radius of one that is deep inside, as a tenth of all are."""
    cells = {}
    for place in places:
        cells.setdefault(tuple(math.floor(x / radius) for x in place), []).append(place)
    counts = []
    for (i, j, k), own in cells.items():
        near = [p for di, dj, dk in itertools.product((-1, 0, 1), repeat=3) for p in cells.get((i + di, j + dj, k + dk), ())]
        counts += [sum(math.dist(place, other) < radius for other in near) for place in own]
    deep = sorted(counts)[len(counts) * 9 // 10]
    return 4 / 3 * math.pi * radius ** 3 / deep


@dataclasses.dataclass
class Model:
    own: float       # seconds a body and step
    ghost: float     # seconds a ghost and step
    memory: tuple    # Mbyte of a process without bodies, and of a body or ghost
    cell: float      # m^3 of the bed a body
    cutoff: float    # m, of ghosts

    def ghosts(self, bodies, ranks):
        """Of a cube in a bed that goes on at all its sides."""
        edge = (bodies / ranks * self.cell) ** (1 / 3)
        return ((edge + 2 * self.cutoff) ** 3 - edge ** 3) / self.cell if ranks > 1 else 0.0

    def step(self, bodies, ranks, ghosts):
        return self.own * bodies / ranks + self.ghost * ghosts

    def mbyte(self, bodies, ranks, ghosts):
        return self.memory[0] + self.memory[1] * (bodies / ranks + ghosts)


def fitted(one, two, small, cell):
    """From the same scene on one process and on two; memory from a smaller one, too."""
    own = one.step / one.bodies
    ghost = max(0.0, (two.step - own * two.bodies / 2) / two.ghosts)
    a_body = (one.memory - small.memory) / (one.bodies - small.bodies)
    return Model(own, ghost, (one.memory - a_body * one.bodies, a_body), cell, two.cutoff)
