"""Random packings without friction, by compression of a box that repeats itself up to a small pressure.

Bodies start apart, on a lattice, each turned its own way and with a small velocity of its own. The box shrinks by 1 % of its first sides in a unit of
time until its pressure is 1e-4 of a contact's stiffness by diameter: overlaps are about 1e-4 of a body. By the protocol `damped` dashpots and a fluid take
the motion away as bodies meet. By `cooled` they collide almost without loss, in a fluid forty times as thin: they go on finding places as they are
pressed, as bodies that grow do (Lubachevsky & Stillinger 1990).
The unit of length is the diameter of a ball of the same volume, that of mass its density's."""

import argparse
import concurrent.futures
import dataclasses
import json
import math
import os
import pathlib
import random
import shutil
import subprocess
import sys

from shapes import SHAPES

STIFFNESS, PRESSURE, STRAIN_RATE = 1000, 0.1, 1e-2


@dataclasses.dataclass(frozen=True)
class Protocol:
    duration: float
    viscosity: float  # the motion falls by e in 1/18 of a unit of time over it
    restitution: float


PROTOCOLS = {"damped": Protocol(300, 0.02, 0.5), "cooled": Protocol(600, 5e-4, 0.99)}
STUDENT = {2: 12.706, 3: 4.303, 4: 3.182, 5: 2.776, 6: 2.571, 7: 2.447, 8: 2.365, 9: 2.306, 10: 2.262}  # 95 %, both sides
AT_REST = 1e-2  # kinetic energy in parts of what contacts store


class Failed(Exception):
    """A run did not end well; its words."""


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
    """The last frame's measures, by the protocol of that name. A run that is there is read again."""
    protocol, folder = PROTOCOLS[name], out / f"{shape.name}-{bodies}-{name}-{seed}"
    file = folder.with_name(folder.name + ".json")
    text = json.dumps(scene_of(shape, bodies, seed, protocol))
    ended = folder / "bulk.jsonl"
    if not (file.exists() and file.read_text() == text and ended.exists() and last_line(ended)["time"] >= protocol.duration * (1 - 1e-9)):
        shutil.rmtree(folder, ignore_errors=True)
        file.write_text(text)
        done = subprocess.run([os.environ["PLUMB_SCENE"], file, "--out", folder, "--threads", "1"], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise Failed(f"{file.name}: {done.stderr.strip()}")
    energy = last_line(folder / "energy.jsonl")["energy"]
    return last_line(ended) | {"is_at_rest": energy["kinetic"] <= AT_REST * energy["linear"]}


def interval(numbers):
    """Mean, and half of the 95 % interval of it; none of one number."""
    mean = sum(numbers) / len(numbers)
    if len(numbers) < 2:
        return mean, None
    spread = math.sqrt(sum((x - mean) ** 2 for x in numbers) / (len(numbers) - 1))
    return mean, STUDENT.get(len(numbers), 1.96) * spread / math.sqrt(len(numbers))


def text_of(numbers, digits):
    mean, half = interval(numbers)
    return f"{mean:.{digits}f}" + ("" if half is None else f" +- {half:.{digits}f}")


def row_of(shape, protocol, runs):
    rattlers = 100 * sum(run["rattlers"] for run in runs) / sum(run["bodies"] for run in runs)
    rest = sum(run["is_at_rest"] for run in runs)
    contacts = [run.get("coordination_without_rattlers", math.nan) for run in runs]
    order = max(max(run.get("order", [0])) for run in runs)
    return (f"{shape.name:14} {protocol:8} {text_of([run['packing_fraction'] for run in runs], 4):18} {text_of(contacts, 2):14} {rattlers:8.1f} {order:6.2f} "
            f"{rest}/{len(runs):<8} {shape.published:26} {shape.source}").rstrip()


def parsed(arguments):
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    names = [shape.name for shape in SHAPES]
    parser.add_argument("--shapes", nargs="+", choices=names, default=names, metavar="NAME", help=", ".join(names))
    parser.add_argument("--bodies", type=int, default=2000)
    parser.add_argument("--seeds", type=int, default=5)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("build/packings"))
    parser.add_argument("--record", action="store_true")
    return parser.parse_args(arguments)


def table_of(asked):
    shapes = [shape for shape in SHAPES if shape.name in asked.shapes]
    asked.out.mkdir(parents=True, exist_ok=True)
    kinds = [(shape, name) for shape in shapes for name in shape.protocols]
    lines = [f"{'shape':14} {'protocol':8} {'packing fraction':18} {'contacts':14} {'rattlers%':8} {'order':>5} {'at rest':10} published"]
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        runs = {kind: [pool.submit(packed, kind[0], asked.bodies, seed, kind[1], asked.out) for seed in range(1, asked.seeds + 1)] for kind in kinds}
        for kind in kinds:
            lines.append(row_of(*kind, [run.result() for run in runs[kind]]))
            print(lines[-1], file=sys.stderr, flush=True)
    return "\n".join(lines) + "\n"


def main():
    asked = parsed(sys.argv[1:])
    if asked.bodies < 30 or asked.seeds < 1 or asked.jobs < 1:
        print("--bodies: at least 30; --seeds and --jobs: at least 1", file=sys.stderr)
        return 2
    try:
        table = table_of(asked)
    except Failed as failed:
        print(failed, file=sys.stderr)
        return 1
    print(table, end="")
    if asked.record:
        command = f"reports/packings/run --shapes {' '.join(asked.shapes)} --bodies {asked.bodies} --seeds {asked.seeds}"
        target = pathlib.Path(__file__).resolve().parents[1] / "results" / "packings.txt"
        target.write_text(f"commit {os.environ['PLUMB_COMMIT']}\ncommand {command}\n{table}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
