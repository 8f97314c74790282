"""Scenes as plumb/scene-1, run by `plumb scene`, and what is read of a run: bodies at its ends, lives of contacts."""

import json
import os
import pathlib
import subprocess

import numpy as np


class Failed(Exception):
    """The command did not end well; its words."""


def ball(radius, position, velocity=(0, 0, 0), spin=(0, 0, 0), **more):
    return body((radius,) * 3, (2, 2), position, velocity, spin, **more)


def body(semi_axes, exponents, position, velocity=(0, 0, 0), spin=(0, 0, 0), quaternion=(1, 0, 0, 0), **more):
    shape = {"superellipsoid": {"semi_axes": list(semi_axes), "exponents": list(exponents)}}
    return {"shape": shape, "position": list(position), "orientation": {"quaternion_wxyz": list(quaternion)},
            "velocity": list(velocity), "angular_velocity": list(spin), **more}


def floor(**more):
    """z = 0, bodies above."""
    return {"point": [0, 0, 0], "normal": [0, 0, 1], **more}


def scene(bodies, effects, duration, walls=(), every=0, **more):
    outputs = {"every": every, "write": ["dump", "lives"]}
    return {"format": "plumb/scene-1", "bodies": [plain(b) for b in bodies], "walls": list(walls), "effects": effects,
            "run": {"duration": float(duration), "outputs": outputs}, **more}


def plain(b):
    """numpy's numbers as Python's."""
    return json.loads(json.dumps(b, default=float))


class Ran:
    """A run's folder."""

    def __init__(self, folder):
        self.lives = [json.loads(line) for line in (folder / "lives.jsonl").read_text().splitlines()]
        self.frames = list(frames_in((folder / "dump.lammpstrj").read_text()))
        self.steps = self.frames[-1]["step"]

    @property
    def last(self):
        return self.frames[-1]

    def only_life(self):
        if len(self.lives) != 1 or not self.lives[0]["ended"]:
            raise Failed(f"{len(self.lives)} contacts in the place of one that ends")
        return self.lives[0]


def frames_in(text):
    """Of a LAMMPS dump: {"time", "step", column: one row a body}."""
    lines = iter(text.splitlines())
    frame = {}
    for line in lines:
        if line == "ITEM: TIME":
            frame["time"] = float(next(lines))
        elif line == "ITEM: TIMESTEP":
            frame["step"] = int(next(lines))
        elif line == "ITEM: NUMBER OF ATOMS":
            count = int(next(lines))
        elif line.startswith("ITEM: ATOMS"):
            names = line.split()[2:]
            rows = np.array([next(lines).split() for _ in range(count)], dtype=float)
            frame["columns"] = dict(zip(names, rows.T))
            yield frame
            frame = {}


def vectors(frame, *names):
    return np.stack([frame["columns"][name] for name in names], axis=1)


def velocity(frame, i=0):
    return vectors(frame, "vx", "vy", "vz")[i]


def position(frame, i=0):
    return vectors(frame, "x", "y", "z")[i]


def momentum(frame, i=0):
    """Angular, about the centre, world axes."""
    return vectors(frame, "angmomx", "angmomy", "angmomz")[i]


def rotation(frame, i=0):
    return rotation_of(vectors(frame, "quatw", "quati", "quatj", "quatk")[i])


def rotation_of(quaternion):
    w, x, y, z = np.asarray(quaternion, dtype=float) / np.linalg.norm(quaternion)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


class Runner:
    """Runs each scene once for each accuracy, in a folder of its own."""

    def __init__(self, folder, program=None):
        self.folder = pathlib.Path(folder)
        self.program = program or os.environ["PLUMB_SCENE"]
        self.done = {}

    def place(self, name, accuracy):
        return self.folder / name / f"{accuracy:g}"

    def run(self, name, tree, accuracy):
        folder = self.place(name, accuracy)
        if folder in self.done:
            return self.done[folder]
        if folder.exists():
            subprocess.run(["rm", "-r", str(folder)], check=True)
        folder.mkdir(parents=True)
        file = folder / "scene-in.json"
        file.write_text(json.dumps({**tree, "run": {**tree["run"], "accuracy": accuracy}}))
        command = [self.program, str(file), "--out", str(folder / "run"), "--threads", "1"]
        ended = subprocess.run(command, capture_output=True, text=True, check=False)
        if ended.returncode != 0:
            raise Failed(ended.stderr.strip() or f"exit code {ended.returncode}")
        self.done[folder] = Ran(folder / "run")
        return self.done[folder]
