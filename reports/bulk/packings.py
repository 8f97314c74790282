"""Random packings without friction, by compression of a box that repeats itself up to a small pressure.

Bodies start apart, on a lattice, each turned its own way and with a small velocity of its own. The box shrinks by 1 % of its first sides in a unit of
time until its pressure is 1e-4 of a contact's stiffness by diameter: overlaps are about 1e-4 of a body. By the protocol `damped` dashpots and a fluid take
the motion away as bodies meet. By `cooled` they collide almost without loss, in a fluid forty times as thin: they go on finding places as they are
pressed, as bodies that grow do (Lubachevsky & Stillinger 1990).
The unit of length is the diameter of a ball of the same volume, that of mass its density's."""

import dataclasses
import json
import math
import random
import sys

import runs
from shapes import SHAPES

STIFFNESS, PRESSURE, STRAIN_RATE = 1000, 0.1, 1e-2


@dataclasses.dataclass(frozen=True)
class Protocol:
    duration: float
    viscosity: float  # the motion falls by e in 1/18 of a unit of time over it
    restitution: float


PROTOCOLS = {"damped": Protocol(300, 0.02, 0.5), "cooled": Protocol(600, 5e-4, 0.99)}
AT_REST = 1e-2  # kinetic energy in parts of what contacts store


def scene_of(shape, bodies, seed, protocol):
    draw = random.Random(seed)
    along = math.ceil(bodies ** (1 / 3))
    pitch = 2.02 * shape.radius()
    places = [(x, y, z) for x in range(along) for y in range(along) for z in range(along)]
    draw.shuffle(places)
    sides = [along * pitch] * 3
    def gauss(size, count):
        return [draw.gauss(0, size) for _ in range(count)]
    return {
        "format": "plumb/scene-1",
        "name": f"packing of {shape.name}",
        "bodies": [{"shape": {"superellipsoid": {"semi_axes": shape.semi_axes(), "exponents": [shape.exponent] * 2}},
                    "position": [pitch * (x + 0.5) for x in place], "orientation": {"quaternion_wxyz": gauss(1, 4)},
                    "velocity": gauss(0.3, 3)} for place in places[:bodies]],
        "effects": {"linear": {"stiffness": STIFFNESS}, "damping": {"restitution": protocol.restitution}, "drag": {"viscosity": protocol.viscosity},
                    "periodic_box": {"sides": sides, "rate": [-STRAIN_RATE * side for side in sides], "pressure": PRESSURE}},
        "run": {"duration": protocol.duration, "accuracy": 1e-2, "outputs": {"every": protocol.duration / 20, "write": ["bulk", "energy"]}},
    }


def last_line(path):
    return json.loads(path.read_text().splitlines()[-1])


def packed(shape, bodies, seed, name, out):
    """The last frame's measures, by the protocol of that name."""
    folder = runs.kept(out / f"{shape.name}-{bodies}-{name}-{seed}", scene_of(shape, bodies, seed, PROTOCOLS[name]))
    energy = last_line(folder / "energy.jsonl")["energy"]
    return last_line(folder / "bulk.jsonl") | {"is_at_rest": energy["kinetic"] <= AT_REST * energy["linear"]}


HEAD = f"{'shape':14} {'protocol':8} {'packing fraction':18} {'contacts':14} {'rattlers%':8} {'order':>5} {'at rest':10} published"


def row_of(shape, protocol, ends):
    rattlers = 100 * sum(end["rattlers"] for end in ends) / sum(end["bodies"] for end in ends)
    rest = sum(end["is_at_rest"] for end in ends)
    contacts = [end.get("coordination_without_rattlers", math.nan) for end in ends]
    order = max(max(end.get("order", [0])) for end in ends)
    return (f"{shape.name:14} {protocol:8} {runs.text_of([end['packing_fraction'] for end in ends], 4):18} {runs.text_of(contacts, 2):14} {rattlers:8.1f} "
            f"{order:6.2f} {rest}/{len(ends):<8} {shape.published:26} {shape.source}")


def main(arguments=None):
    parser = runs.options("packings", __doc__.splitlines()[0], 2000, 5)
    names = [shape.name for shape in SHAPES]
    parser.add_argument("--shapes", nargs="+", choices=names, default=names, metavar="NAME", help=", ".join(names))
    parser.add_argument("--protocols", nargs="+", choices=list(PROTOCOLS), default=list(PROTOCOLS), metavar="NAME", help=", ".join(PROTOCOLS))
    asked = parser.parse_args(arguments)
    asked.command = f"reports/bulk/run packings --shapes {' '.join(asked.shapes)} --bodies {asked.bodies} --seeds {asked.seeds}"
    if asked.protocols != list(PROTOCOLS):
        asked.command += f" --protocols {' '.join(asked.protocols)}"
    kinds = [(shape, protocol) for shape in SHAPES if shape.name in asked.shapes for protocol in shape.protocols if protocol in asked.protocols]
    def run(kind, seed):
        return packed(kind[0], asked.bodies, seed, kind[1], asked.out)
    return runs.study(asked, HEAD, kinds, run, lambda kind, ends: row_of(*kind, ends))


if __name__ == "__main__":
    sys.exit(main())
