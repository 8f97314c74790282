"""What is proved of a pair."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from decimal import Decimal
from typing import Any, NamedTuple

from numpy.typing import ArrayLike

from ._case import case
from ._native import Body
from ._program import options, run, to_json
from ._words import Verdict

Decimals = tuple[Decimal, Decimal, Decimal]


class Bounds(NamedTuple):
    """The true value lies between the two; rounded outwards."""

    lower: Decimal  #: not above the true value
    upper: Decimal  #: not below it


@dataclass(frozen=True)
class Certificate:
    """What is proved, for these very doubles; None where it is not. ``numpy.array(c.normal, float)`` has the digits of a float."""

    verdict: Verdict | None  #: None where the problem has no proved answer
    overlap: Bounds  #: a length, signed as Contact.overlap; infinite where there is no bound
    normal: Decimals | None  #: unit, from body 1 to body 2
    normal_radius: Decimal | None  #: the true normal lies within this angle of ``normal``; rad
    points: tuple[Decimals, Decimals] | None  #: on body 1 and on body 2, world frame
    points_radius: Decimal | None  #: each true point lies within this of its own; a length
    unique: str  #: proved, disproved or open: no other common normal has as low an overlap
    global_: str | None  #: proved or open: no direction has a lower overlap; None for other problems
    tied: list[dict[str, Any]]  #: other common normals of the same overlap, as ``json`` has them
    reason: str | None  #: what is not proved, and why
    digits: int  #: significant digits of the decimals
    condition: dict[str, Any] | None  #: by which factor a change of the input grows in overlap, normal and points
    json: dict[str, Any]  #: all that `plumb certify --json` said


def certify(
    body1: Body,
    body2: Body,
    *,
    digits: int = 50,
    problem: str = "common_normal",
    motion: ArrayLike | None = None,
    effort: str | None = None,
    all: bool = False,
) -> Certificate:
    """Proves overlap, verdict, common normal and points of a pair; a hundredth of a second for most.

    body1, body2  lengths in one unit, world frame
    digits   1 to 50, of the decimals
    problem  common_normal, or another that a method answers: deepest_points, midway, first_touch
    motion   (3,) velocity of body 2 relative to body 1, any unit, for first_touch
    effort   bounds (trusts the machine's pow), proof (19 digits), digits (50); without it as the digits need
    all      also every other common normal: in ``json``, "stationary" and "complete"

    Runs the program plumb (``find_program``). ValueError for an argument that is not legal.

    >>> ball = plumb.Body((1, 1, 1), (0, 0, 0))
    >>> certificate = plumb.certify(ball, plumb.Body((1, 1, 2), (1.5, 0, 0)), digits=10)
    >>> print(certificate.unique, certificate.overlap.lower, certificate.overlap.upper)
    proved 0.5000000000 0.5000000000
    """
    pair = case(body1, body2, motion=motion)
    return _certify([pair], "", digits=digits, problem=problem, effort=effort, all=all)[0]


def certify_all(
    pairs: Iterable[tuple[Body, Body]], *, digits: int = 50, problem: str = "common_normal", effort: str | None = None
) -> list[Certificate]:
    """Certificates of many pairs, in their order, by one run of the program.

    pairs                    (body1, body2) of each
    digits, problem, effort  as ``certify`` has them

    ValueError and TypeError name an argument that is not legal.

    >>> ball = plumb.Body((1, 1, 1), (0, 0, 0))
    >>> [proved.verdict.name for proved in plumb.certify_all([(ball, ball.moved((x, 0, 0))) for x in (1.5, 2.5)])]
    ['overlapping', 'separated']
    """
    cases = [_case_of(pair, f"pairs[{index}]") for index, pair in enumerate(_listed(pairs))]
    return _certify(cases, "pairs", digits=digits, problem=problem, effort=effort, all=False) if cases else []


def _listed(pairs: Any) -> list[Any]:
    if not isinstance(pairs, Iterable):
        raise TypeError(f"pairs: must be (body1, body2) of each, not {type(pairs).__name__}")
    return list(pairs)


def _case_of(pair: Any, name: str) -> dict[str, Any]:
    try:
        body1, body2 = pair
    except (TypeError, ValueError):
        raise TypeError(f"{name}: must be (body1, body2)") from None
    for body in (body1, body2):
        if not isinstance(body, Body):
            raise TypeError(f"{name}: must be two plumb.Body, not {type(body).__name__}")
    return case(body1, body2)


def _certify(cases: list[dict[str, Any]], argument: str, *, problem: str, **given: Any) -> list[Certificate]:
    if problem != "common_normal":
        given["problem"] = problem
    lines = "".join(to_json(one, argument) + "\n" for one in cases)
    _, printed = run(["certify", "-", "--json", *options(given)], argument, lines)
    return [_certificate(json.loads(line)) for line in printed.splitlines()]


def _certificate(said: dict[str, Any]) -> Certificate:
    overlap = said.get("overlap", {})
    points = said.get("points")
    return Certificate(
        verdict=Verdict[said["verdict"]] if "verdict" in said else None,
        overlap=Bounds(Decimal(overlap.get("lower", "-Infinity")), Decimal(overlap.get("upper", "Infinity"))),
        normal=_decimals(said["normal"]) if "normal" in said else None,
        normal_radius=_decimal(said, "normal_radius"),
        points=(_decimals(points[0]), _decimals(points[1])) if points else None,
        points_radius=_decimal(said, "points_radius"),
        unique=said["unique"],
        global_=said.get("global"),
        tied=said.get("tied", []),
        reason=said.get("reason"),
        digits=said["digits"],
        condition=said.get("condition"),
        json=said,
    )


def _decimal(said: Mapping[str, Any], field: str) -> Decimal | None:
    return Decimal(said[field]) if field in said else None


def _decimals(texts: list[str]) -> Decimals:
    x, y, z = map(Decimal, texts)
    return x, y, z
