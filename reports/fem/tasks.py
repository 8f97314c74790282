"""Calculations that are kept, each by its deck, so that a study goes on where it was stopped and makes none twice."""

import concurrent.futures
import contextlib
import dataclasses
import fcntl
import hashlib
import json
import os
import pathlib
import shutil
import signal
import subprocess

import calculix
import contact
import planes
from mesh import MeshFailure
from superellipsoid import pair_of


class Busy(Exception):
    """One line: another run is at work in the same folder."""


@dataclasses.dataclass(frozen=True)
class Task:
    geometry: str
    ratio: float
    case: dict  # with positions and quaternions
    answers: dict  # method -> answer
    mode: contact.Mode
    setting: calculix.Setting = calculix.Setting()
    has_planes: bool = False  # half-spaces are asked too


def engine_versions():
    """As the engines say themselves; FileNotFoundError where one is not there."""
    ccx = subprocess.run(["ccx", "-v"], capture_output=True, text=True, check=False).stdout.split()
    gmsh = subprocess.run(["gmsh", "-version"], capture_output=True, text=True, check=False)
    return {"ccx": ccx[-1] if ccx else "?", "gmsh": (gmsh.stdout + gmsh.stderr).strip()}


def calculated(task, out, engine):
    """In a process of its own: what contact.judged gives, or why there is nothing; "planes", those of half-spaces."""
    try:
        pair = pair_of(task.case)
        lens = contact.Lens.of(pair, task.answers["auto"])
        result = contact.judged(_result(task, pair, lens, out, engine), task.answers, lens.patch_radius())
    except (MeshFailure, calculix.EngineFailure) as error:
        result = {"reason": str(error)}
    return result | {"planes": planes.settled(task.case, task.answers, result) if task.has_planes else []}


def _result(task, pair, lens, out, engine):
    meshes, deck = contact.meshes_and_deck(pair, task.answers["auto"], lens, task.mode, task.setting)
    return calculation(meshes, deck, task.setting, out, engine)


def calculation(meshes, deck, setting, out, engine):
    """What is kept of this deck, or made now and kept."""
    key = hashlib.sha256((calculix.reading() + engine + deck).encode()).hexdigest()[:24]
    path = out / "kept" / f"{key}.json"
    with contextlib.suppress(OSError, ValueError, TypeError, AttributeError):  # not there, or not whole: calculated again
        return calculix.Result.from_json(json.loads(path.read_text()))
    folder = out / "work" / key
    result = calculix.run(folder, deck, meshes, setting)
    _keep(path, result.to_json())
    shutil.rmtree(folder)  # megabytes a calculation; of a failed one they are what is left to look at
    return result


def _keep(path, result):
    """Whole or not at all."""
    part = path.with_suffix(f".{os.getpid()}")
    part.write_text(json.dumps(result))
    part.replace(path)


def _mortal():
    """Ctrl-C ends this process, and the engine that it waits for, at once: the parent says what there is to say. So does the parent's end."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)
    calculix.die_with_parent()


@contextlib.contextmanager
def alone_in(out):
    """Two runs would write one calculation's files."""
    (out / "kept").mkdir(parents=True, exist_ok=True)
    with (out / "kept" / "lock").open("w") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            raise Busy(f"{out}: another run is writing there") from None
        yield


def run_all(tasks, out, engine, jobs, tell, calculate=calculated):
    """The results in the order of the tasks, through `jobs` processes; tell(done, of) goes along. Busy, or what a task raises."""
    out = pathlib.Path(out)
    with alone_in(out), concurrent.futures.ProcessPoolExecutor(jobs, initializer=_mortal) as pool:
        tell(0, len(tasks))
        waiting = [pool.submit(calculate, task, out, engine) for task in tasks]
        try:
            for number, done in enumerate(concurrent.futures.as_completed(waiting), start=1):
                done.result()
                tell(number, len(tasks))
        except BaseException:
            pool.shutdown(wait=True, cancel_futures=True)
            raise
        return [each.result() for each in waiting]
