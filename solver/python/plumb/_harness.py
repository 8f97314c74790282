"""The harness from Python: each call runs the program ``plumb`` in a process of its own and gives what it wrote."""

from __future__ import annotations

import json
import math
import os
import tempfile
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, cast

from ._case import case as case_of
from ._native import Body, Contact
from ._program import options, path_of, run, to_json
from ._words import words_of

StrPath = str | os.PathLike[str]
Json = dict[str, Any]


@dataclass(frozen=True)
class Campaign:
    """What a campaign found."""

    summary: Json  #: summary.json: by method the findings, angles, overlap errors and iterations
    failures: list[Json]  #: the simplest and the worst case of each kind of failure; ``bodies_of`` has their bodies
    found: bool  #: a finding of ``auto``, of the reference or of ``solver``; the other methods' are its result
    table: str  #: for people


@dataclass(frozen=True)
class Replay:
    """Whether kept cases still give what they expect."""

    differs: bool  #: some case does not give what it expects
    table: str  #: for people, a line a case


def campaign(
    family: str | Iterable[str],
    cases: int,
    *,
    seed: int = 1,
    method: str | Iterable[str] | None = None,
    solver: StrPath | None = None,
    threads: int | None = None,
    shard: str | None = None,
    shrink: bool = False,
    cache: StrPath | None = None,
    out: StrPath | None = None,
) -> Campaign:
    """Random pairs by the thousand, every method's answer judged by every law.

    family   a name of `plumb families`, several of them, or "all"
    cases    of each family
    seed     same seed, same cases and results, whatever the number of threads
    method   names, or "all", which is the default without ``solver``
    solver   a shared library behind plumb_solver.h, in processes of its own
    threads  default: one for each processor
    shard    "i/n": the i-th of n parts; `plumb merge` puts their folders together
    shrink   then shrink each failure to a simpler one
    cache    folder that keeps the references for the next campaign
    out      folder that keeps summary.json, campaign.bins and failures/

    ValueError for what is not legal. Ctrl-C: ``out`` has what was done, marked incomplete.

    >>> result = plumb.campaign("spheroid", 10, method=["auto", "original_cn"])
    >>> result.summary["methods"]["auto"]["findings"]
    {'none': 10}
    """
    given = {
        "family": ",".join(words_of(family, "family")),
        "cases": cases,
        "seed": seed,
        "method": None if method is None else ",".join(words_of(method, "method")),
        "solver": solver,
        "threads": threads,
        "shard": shard,
        "shrink": shrink,
        "cache": cache,
    }
    if out is not None:
        return _run_campaign(given, Path(out))
    with tempfile.TemporaryDirectory() as folder:
        result = _run_campaign(given, Path(folder))
    return result


def scene(
    scene: Mapping[str, Any] | StrPath,
    *,
    out: StrPath | None = None,
    resume: bool = False,
    record: bool = False,
    threads: int | None = None,
    accuracy: float | None = None,
) -> Json:
    """Simulates a scene of bodies: the effects that it calls for, and nothing else.

    scene     a scene as a dict (format plumb/scene-1), or its file
    out       folder for what the scene writes, its checkpoints and run.json
    resume    go on with the run in ``out``
    record    keep hard contacts as cases in ``out``
    threads   for the solver; as many as the scene can use
    accuracy  relative, between 0 and 1; instead of the scene's own

    Gives run.json: the plan, what each part cost, and the measures. ValueError for what is not legal. Ctrl-C: ``out`` has what was
    done, and ``resume`` goes on.

    >>> run = plumb.scene(plumb.named_scene("impact"))
    >>> run["complete"]
    True
    """
    given = {"out": out, "resume": resume, "record": record, "threads": threads, "accuracy": accuracy}
    return _run_scene(scene, given)


def scene_plan(scene: Mapping[str, Any] | StrPath) -> Json:
    """Which effects of a scene run, why, and what each costs; nothing is simulated.

    scene  a scene as a dict (format plumb/scene-1), or its file

    Gives the plan: "effects" has "name", "on" and the reason of each. ValueError and TypeError begin with the name of what is not legal.

    >>> plan = plumb.scene_plan(plumb.named_scene("impact"))
    >>> [effect["name"] for effect in plan["effects"] if effect["on"]]
    ['linear']
    """
    return _run_scene(scene, {"plan": True})


def named_scene(name: str, bodies: int | None = None) -> Json:
    """One of the scenes that come with plumb.

    name    `plumb scenes` lists them
    bodies  how many, where that may be chosen

    Gives the scene, format plumb/scene-1. ValueError and TypeError name an argument that is not legal.

    >>> plumb.named_scene("impact")["format"]
    'plumb/scene-1'
    """
    if not isinstance(name, str):
        raise TypeError(f"name: must be a text, not {type(name).__name__}")
    return _loads(run(["scenes", name, *options({"bodies": bodies})], "name")[1])


def check(body1: Body, body2: Body, answer: Contact | Mapping[str, Any], *, motion: Any = None) -> Json:
    """Judges anybody's answer by the certified reference.

    body1, body2  lengths in one unit, world frame
    motion  (3,) velocity of body 2 relative to body 1, any unit, for first_touch
    answer  a Contact, or the fields of `plumb solve --json`: "overlap", "normal", "points", ...; "method" says which problem
            it answers, by the problem's name ("deepest_points") or by that of a method which solves it; without it the
            common normal

    Gives "finding" ("none" where nothing is wrong), "severity" (error over what the condition number allows), "angle_error_deg" and
    more. ValueError for a field of another name (but "x_..."), and for a "method" of none of these names.

    >>> ball = plumb.Body((1, 1, 1), (0, 0, 0))
    >>> other = plumb.Body((1, 1, 2), (1.5, 0, 0))
    >>> plumb.check(ball, other, {"status": "converged", "overlap": 0.4, "normal": [1, 0, 0],
    ...                           "points": [[1, 0, 0], [0.6, 0, 0]]})["finding"]
    'off_surface'
    """
    said = _answer(answer) if isinstance(answer, Contact) else {"name": "python", **_mapping(answer, "answer")}
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "case.json")
        file.write_text(to_json(case_of(body1, body2, motion=motion), "body1"), encoding="utf-8")
        return _loads(run(["check", str(file), "--answer", "-"], "answer", to_json(said, "answer"))[1])


def shrink(case: Mapping[str, Any], *, method: str | None = None, solver: StrPath | None = None) -> Json:
    """The simplest case with the same finding and at least half its severity.

    case    one of ``Campaign.failures``, or ``plumb.case`` of a pair
    method  instead of the one that the case names
    solver  a shared library behind plumb_solver.h, instead of a method

    Gives "finding", "severity" and "case", and in "explanation" which numbers matter. ValueError and TypeError begin with the
    name of what is not legal.

    >>> disc = plumb.Body((1, 1, 0.4), (0, 0, 0))
    >>> plumb.shrink(plumb.case(disc, disc.moved((1.5, 0, -0.4))), method="original_cn")["finding"]
    'misaligned'
    """
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "case.json")
        file.write_text(to_json(_mapping(case, "case"), "case"), encoding="utf-8")
        return _loads(_run_on(file, "shrink", "case", ["--json", *options({"method": method, "solver": solver})]))


def replay(
    paths: StrPath | Iterable[StrPath],
    *,
    method: str | None = None,
    solver: StrPath | None = None,
    threads: int | None = None,
) -> Replay:
    """Runs case files, and folders of them, against what they expect.

    paths    one or several
    method   instead of the one that each case names
    solver   the same, a shared library behind plumb_solver.h
    threads  default: one for each processor; changes nothing but the time

    ValueError and TypeError begin with the name of what is not legal.

    >>> import json, pathlib, tempfile
    >>> ball = plumb.Body((1, 1, 1), (0, 0, 0))
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     file = pathlib.Path(folder, "pair.json")
    ...     written = file.write_text(json.dumps(plumb.case(ball, ball.moved((1.5, 0, 0)))))
    ...     plumb.replay(file).differs
    False
    """
    one = isinstance(paths, (str, os.PathLike)) or not isinstance(paths, Iterable)
    files = [path_of(path, "paths") for path in ([paths] if one else cast("Iterable[StrPath]", paths))]
    if not files:
        raise ValueError("paths: must be one at least")
    given = {"method": method, "solver": solver, "threads": threads}
    return Replay(*run(["replay", *files, *options(given)], "paths"))


def _mapping(value: Any, argument: str) -> Mapping[str, Any]:
    if not isinstance(value, Mapping):
        raise TypeError(f"{argument}: must be a dict, not {type(value).__name__}")
    return value


def _run_on(file: Path, command: str, argument: str, options: list[str]) -> str:
    """What the command prints of a file that only the call knows, whose name is no news to the caller."""
    try:
        return run([command, str(file), *options], argument)[1]
    except ValueError as error:
        raise ValueError(str(error).replace(f"{file}: ", "")) from None


def _run_campaign(given: Mapping[str, Any], out: Path) -> Campaign:
    found, table = run(["campaign", *options({**given, "out": out})], "out")
    failures = [_read(path) for path in sorted((out / "failures").glob("*.json"))]
    return Campaign(_read(out / "summary.json"), failures, found, table)


def _run_scene(scene: Mapping[str, Any] | StrPath, given: Mapping[str, Any]) -> Json:
    if isinstance(scene, Mapping):
        return _loads(run(["scene", "-", "--json", *options(given)], "scene", to_json(scene, "scene"))[1])
    return _loads(run(["scene", path_of(scene, "scene"), "--json", *options(given)], "scene")[1])


def _answer(contact: Contact) -> Json:
    """As `plumb solve` writes it: what is not valid is absent."""
    out: Json = {
        "name": "python",
        "status": contact.status.name,
        "verdict": contact.verdict.name,
        "iterations": contact.iterations,
        "evaluations": contact.evaluations,
    }
    if contact.method:
        out["method"] = contact.method
    if math.isfinite(contact.overlap):
        out["overlap"] = contact.overlap
    for field in ("normal", "points", "contact_point"):
        values = getattr(contact, field).tolist()
        if math.isfinite(math.fsum(map(math.fsum, values) if field == "points" else values)):
            out[field] = values
    return out


def _loads(text: str) -> Json:
    loaded: Json = json.loads(text)
    return loaded


def _read(path: Path) -> Json:
    return _loads(path.read_text(encoding="utf-8"))
