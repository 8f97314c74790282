"""Pairs as case files have them, format plumb/case-1."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from ._native import Body


def case(body1: Body, body2: Body, *, name: str = "python", motion: ArrayLike | None = None) -> dict[str, Any]:
    """The pair as a case: what ``json.dump`` writes to a file that every command of plumb reads.

    >>> ball = plumb.Body((1, 1, 1), (0, 0, 0))
    >>> plumb.bodies_of(plumb.case(ball, ball.moved((1.5, 0, 0))))[1].position
    array([1.5, 0. , 0. ])
    """
    out = {"format": "plumb/case-1", "name": name, "bodies": [_body_json(body1), _body_json(body2)]}
    if motion is not None:
        out["motion"] = np.asarray(motion, np.float64).tolist()
    return out


def bodies_of(case: Mapping[str, Any]) -> tuple[Body, Body]:
    """The pair of a case that stores positions and quaternions, as every kept failure does; ValueError for another."""
    try:
        body1, body2 = (_body_of(body) for body in case["bodies"])
    except (KeyError, TypeError) as error:
        raise ValueError(f"case: has not two bodies with shape, position and quaternion ({error})") from None
    return body1, body2


def _body_json(body: Body) -> dict[str, Any]:
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
