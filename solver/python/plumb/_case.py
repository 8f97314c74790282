"""Pairs as case files have them, format plumb/case-1."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ._native import Body


def case(body1: Body, body2: Body, *, name: str = "python", motion: ArrayLike | None = None) -> dict[str, Any]:
    """The pair as a case: what ``json.dump`` writes to a file that every command of plumb reads.

    body1, body2  lengths in one unit, world frame
    name          what messages and tables call it
    motion        (3,) velocity of body 2 relative to body 1, any unit; ``first_touch`` goes back along it

    Gives a dict of plain lists and numbers. ValueError and TypeError name an argument that is not legal.

    >>> ball = plumb.Body((1, 1, 1), (0, 0, 0))
    >>> plumb.bodies_of(plumb.case(ball, ball.moved((1.5, 0, 0))))[1].position
    array([1.5, 0. , 0. ])
    """
    if not isinstance(name, str):
        raise TypeError(f"name: must be a text, not {type(name).__name__}")
    out: dict[str, Any] = {"format": "plumb/case-1", "name": name, "bodies": [_body_json(body1, "body1"), _body_json(body2, "body2")]}
    if motion is not None:
        out["motion"] = _motion(motion)
    return out


def bodies_of(case: Mapping[str, Any]) -> tuple[Body, Body]:
    """The pair of a case that stores positions and quaternions, as every kept failure does; ValueError for another.

    case  as a dict, format plumb/case-1; lengths in one unit, world frame

    >>> ball = plumb.Body((1, 1, 1), (0, 0, 0))
    >>> plumb.bodies_of(plumb.case(ball, ball))[0] == ball
    True
    """
    try:
        body1, body2 = (_body_of(body) for body in case["bodies"])
    except KeyError as error:
        raise ValueError(f"case: has no field {error.args[0]}, of two bodies with shape, position and quaternion") from None
    except (TypeError, ValueError) as error:
        raise ValueError(f"case: has not two bodies with shape, position and quaternion: {error}") from None
    return body1, body2


def _motion(motion: ArrayLike) -> list[float]:
    try:
        array = np.asarray(motion, np.float64)
    except (TypeError, ValueError):
        raise TypeError("motion: must be of real numbers that fit in float64") from None
    if array.shape != (3,):
        raise ValueError(f"motion: must have shape (3,), not {array.shape}")
    if not np.all(np.isfinite(array)):
        raise ValueError("motion: must be finite")
    values: list[float] = array.tolist()
    return values


def _body_json(body: Body, argument: str) -> dict[str, Any]:
    if not isinstance(body, Body):
        raise TypeError(f"{argument}: must be a plumb.Body, not {type(body).__name__}")
    shape = {"semi_axes": body.semi_axes.tolist(), "exponents": body.exponents.tolist()}
    return {
        "shape": {"superellipsoid": shape},
        "position": body.position.tolist(),
        "orientation": {"quaternion_wxyz": body.quaternion.tolist()},
    }


def _body_of(body: Mapping[str, Any]) -> Body:
    shape = body["shape"]["superellipsoid"]
    turn = body["orientation"]["quaternion_wxyz"]
    return Body(shape["semi_axes"], body["position"], turn, shape.get("exponents", (2, 2)))
