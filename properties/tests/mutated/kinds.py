"""The kinds of files that plumb reads: of each legal samples, where it lies in a folder, and the commands that read it there."""

import dataclasses
import json
import pathlib
import shutil
import struct

SOURCE = pathlib.Path(__file__).resolve().parents[3]
CASES = SOURCE / "corpus" / "cases"
ONE_METHOD = "--family spheroid,hard --cases 4 --seed 5 --method original_cn"
RESUME = "scene scene.json --out run --record --resume"
PARTS = " ".join(f"half/chunks/{n}-of-4.part" for n in range(1, 5))
PART = PARTS.split()[1]

EULER = {
    "format": "plumb/case-1",
    "name": "all fields",
    "bodies": [
        {
            "shape": {"superellipsoid": {"semi_axes": [1, 0.8, 0.6], "exponents": [4, 2.5]}},
            "position": [0, 0, 0],
            "orientation": {"euler_zxz": [0.1, 0.2, 0.3]},
        },
        {"shape": {"superellipsoid": {"semi_axes": [1, 1, 2]}}, "orientation": {"euler_zxz_deg": [10, 20, 30]}},
    ],
    "placement": {"line_deg": [30, 40], "overlap_ratio": 0.01},
    "motion": [0, 0, 1],
    "expect": {"method": "auto", "status": "converged", "verdict": "overlapping", "finding": "none"},
    "provenance": {"a": 1},
    "x_mine": 2,
}
BALL = {"superellipsoid": {"semi_axes": [1, 1, 1]}}
UPRIGHT = {"quaternion_wxyz": [1, 0, 0, 0]}
BALLS = {
    "format": "plumb/case-1",
    "name": "balls",
    "bodies": [
        {"shape": BALL, "position": [0, 0, 0], "orientation": UPRIGHT},
        {"shape": BALL, "position": [1.9, 0, 0], "orientation": UPRIGHT},
    ],
    "expect": {"overlap": [0.0999, 0.1001], "normal": [1, 0, 0], "normal_radius": 1e-6, "points": [[1, 0, 0], [0.9, 0, 0]]},
}
SCENE = {
    "format": "plumb/scene-1",
    "name": "all effects",
    "bodies": [
        {"shape": BALL, "position": [0, 0, 0.95], "orientation": UPRIGHT, "velocity": [1, 0, 0], "temperature": 300},
        {
            "shape": {"superellipsoid": {"semi_axes": [1, 0.7, 0.5]}},
            "position": [1.7, 0, 0.6],
            "orientation": {"euler_zxz_deg": [0, 30, 0]},
            "angular_velocity": [0, 0, 1],
            "temperature": 290,
        },
        {
            "shape": {"superellipsoid": {"semi_axes": [0.8, 0.8, 0.6], "exponents": [4, 4]}},
            "position": [0.3, 0.2, 3.5],
            "orientation": {"euler_zxz": [0.2, 0.4, 0]},
            "density": 2,
            "temperature": 280,
            "fixed": True,
        },
    ],
    "walls": [{"point": [0, 0, 0], "normal": [0, 0, 1], "temperature": 310}],
    "effects": {
        "gravity": {"acceleration": [0, 0, -9.81]},
        "linear": {"stiffness": 1e4},
        "damping": {"restitution": 0.5},
        "friction": {"coefficient": 0.4, "stiffness_ratio": 0.3, "damping": 0.1},
        "rolling": {"coefficient": 0.1, "stiffness_ratio": 0.1, "damping": 0.3},
        "cohesion": {"pull_off": 0.1, "range": 0.01},
        "drag": {"viscosity": 0.1, "fluid_velocity": [0, 0, 1]},
        "conduction": {"conductivity": 0.1, "heat_capacity": 2},
        "moving_walls": {"motions": [{"wall": 0, "velocity": [0.1, 0, 0], "amplitude": [0, 0.1, 0], "frequency": 1}]},
        "periodic_box": {"sides": [30, 40, 0], "rate": [0, 0, 0]},
    },
    "run": {"duration": 0.1, "accuracy": 0.01, "outputs": {"every": 0.05, "write": ["touching", "contacts", "dump", "vtk", "playback"]}},
    "provenance": {"by": "a test"},
}
BOXES = (
    "ITEM: UNITS\nlj\nITEM: TIME\n1.5\nITEM: TIMESTEP\n100\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS xy xz yz pp pp ff\n-10 10 0\n"
    "-10 10 0\n-10 10 0\nITEM: ATOMS id type xs ys zs quatw quati quatj quatk shapex shapey shapez \n1 1 0.5 0.5 0.5 1 0 0 0 2 2 2 \n"
    "2 1 0.59 0.5 0.5 1 0 0 0 2 2 4 \nITEM: TIMESTEP\n200\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS abc origin pp pp pp\n20 0 0 -10\n"
    "0 20 0 -10\n0 0 20 -10\nITEM: ATOMS id x y z radius\n7 0 0 0 1\n"
)


@dataclasses.dataclass(frozen=True)
class Kind:
    """`sealed`: ends with a sum of all before it, which most of the edited files have again. `mended`: damaged it is refused by none, and
    is as it was after each command."""

    name: str
    form: str
    file: str
    samples: tuple  # of paths that hold one
    commands: tuple
    sealed: bool = False
    mended: bool = False


KINDS = (
    Kind(
        "cases",
        "json",
        "f.json",
        ("euler.json", "balls.json", "near.json"),
        (
            "solve f.json --json --method all",
            "certify f.json --effort bounds --json",
            "replay f.json",
            "check f.json --answer answers.jsonl",
            "export f.json",
            "path f.json",
            "report --issue f.json",
            "promote f.json --to open --why x --corpus corpus",
        ),
    ),
    Kind(
        "lines of cases",
        "lines",
        "f.jsonl",
        ("cases.jsonl",),
        ("solve f.jsonl", "export f.jsonl", "path f.jsonl", "replay f.jsonl --quiet"),
    ),
    Kind(
        "scenes",
        "json",
        "f.json",
        ("scene.json", "effects.json", "dice.json"),
        ("scene --plan f.json", "scene --plan --json f.json", "export-lammps f.json -o lammps", "export f.json"),
    ),
    Kind(
        "dumps",
        "words",
        "f.dump",
        ("boxes.dump", "lammps.dump", "liggghts.dump"),
        ("import f.dump", "import f.dump --gap 0.5 --step last", "import f.dump --format lammps --column shapex=shapey"),
    ),
    Kind(
        "proofs",
        "json",
        "f.proof",
        ("balls.proof", "near.proof", "blocks.proof"),
        ("certify near.json --verify f.proof", "certify balls.json --verify f.proof", "certify blocks.json --verify f.proof"),
    ),
    Kind("answers", "lines", "f.jsonl", ("answers.jsonl",), ("check near.json --answer f.jsonl", "check near.json --answer - < f.jsonl")),
    Kind(
        "counts",
        "json",
        "out/campaign.bins",
        ("out/campaign.bins",),
        ("merge out --out all", "report out -o page.html", f"campaign {ONE_METHOD} --out out --resume", f"campaign {ONE_METHOD} --out out"),
    ),
    Kind(
        "chunks",
        "lines",
        PART,
        (PART,),
        (f"merge {PARTS} --out all", f"campaign {ONE_METHOD} --out half --chunks 4 --resume"),
    ),
    Kind(
        "kept failures",
        "json",
        "out/failures/KEPT",
        ("out/failures/KEPT",),
        ("merge out --out all", "report out -o page.html", "replay out --quiet"),
    ),
    Kind(
        "summaries",
        "json",
        "out/summary.json",
        ("out/summary.json",),
        (f"campaign {ONE_METHOD} --out out", f"campaign {ONE_METHOD} --out out --resume", "merge out --out all", "report out -o page.html"),
    ),
    Kind(
        "checkpoints",
        "cells",
        "run/checkpoint.bin",
        ("run/checkpoint.bin",),
        (RESUME, "scene scene.json --out run --resume --json"),
        sealed=True,
    ),
    Kind("runs", "json", "run/run.json", ("run/run.json",), (RESUME, "report run -o page.html")),
    Kind("playbacks", "lines", "run/playback.jsonl", ("run/playback.jsonl",), ("report run -o page.html", RESUME)),
    Kind("dumps of runs", "words", "run/dump.lammpstrj", ("run/dump.lammpstrj",), (RESUME, "import run/dump.lammpstrj")),
    Kind("contacts of runs", "lines", "run/contacts.jsonl", ("run/contacts.jsonl",), (RESUME,)),
    *(
        Kind(f"lines of report --{section}", "lines", "f.jsonl", (f"{section}.jsonl",), (f"report out --{section} f.jsonl -o page.html",))
        for section in ("precision", "stability", "study", "fem")
    ),
    Kind("references", "json", "cache/KEPT", ("cache/KEPT",), ("replay near.json --cache cache",), mended=True),
)


def one_of_each(file):
    """Of the lines with a kind the first two of each."""
    taken, seen = [], {}
    for line in file.read_text().splitlines():
        fields = json.loads(line)
        kind = fields.get("kind", "")
        seen[kind] = seen.get(kind, 0) + 1
        if seen[kind] <= 2:
            taken.append(line)
    return "".join(line + "\n" for line in taken)


def with_seal(data):
    """FNV-1a of what stands before the last eight bytes."""
    total = 0xCBF29CE484222325
    for byte in data[:-8]:
        total = (total ^ byte) * 0x100000001B3 % 2**64
    return data[:-8] + struct.pack("<Q", total)


def part_of(folder):
    lines = [(folder / "campaign.bins").read_text()]
    for file in sorted((folder / "failures").glob("*.json")):
        lines.append(json.dumps({"file": file.name, "case": json.loads(file.read_text())}) + "\n")
    return "".join(lines)


def make_samples(folder, plumb):
    """All that the kinds name; `plumb(arguments)` runs the program in the folder."""
    texts = {"euler.json": EULER, "balls.json": BALLS, "scene.json": SCENE}
    for name, tree in texts.items():
        (folder / name).write_text(json.dumps(tree))
    (folder / "boxes.dump").write_text(BOXES)
    (folder / "near.json").write_text((CASES / "hard" / "needle.jsonl").read_text().splitlines()[0])
    (folder / "blocks.json").write_text((CASES / "hard" / "needle.jsonl").read_text().splitlines()[1])
    (folder / "cases.jsonl").write_text("".join((folder / name).read_text() + "\n" for name in ("balls.json", "euler.json", "near.json")))
    for name in ("effects.json", "dice.json"):
        (folder / name).write_text((SOURCE / "corpus" / "scenes" / name).read_text())
    for life in ("open", "incubating", "regressions"):
        (folder / "corpus" / life).mkdir(parents=True)
    for section in ("precision", "stability", "study"):
        (folder / f"{section}.jsonl").write_text(one_of_each(SOURCE / "reports" / "results" / f"{section}.jsonl"))
    (folder / "fem.jsonl").write_text((SOURCE / "properties" / "tests" / "reports" / "made_up_fem.jsonl").read_text())
    (folder / "answers.jsonl").write_text(plumb("solve near.json --json --method all"))
    for case in ("balls", "near", "blocks"):
        plumb(f"certify {case}.json --proof {case}.proof")
    plumb("export cases.jsonl -o lammps.dump")
    plumb("export scene.json --format liggghts -o liggghts.dump")
    plumb(f"campaign {ONE_METHOD} --out out")
    (folder / "half" / "chunks").mkdir(parents=True)
    for shard in range(1, 5):
        plumb(f"campaign {ONE_METHOD} --shard {shard}/4 --out part")
        (folder / "half" / "chunks" / f"{shard}-of-4.part").write_text(part_of(folder / "part"))
        shutil.rmtree(folder / "part")
    plumb("scene scene.json --out run --record --checkpoint 20")
    plumb("replay near.json --cache cache")
