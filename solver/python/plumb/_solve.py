"""One pair at a time."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._native import Body, Contact, ConvexBody
from ._words import words_of


class Method(NamedTuple):
    """A row of the list of methods."""

    name: str  #: what ``solve`` takes
    problem: str  #: the question it answers: common_normal, deepest_points, midway or first_touch
    summary: str  #: how it goes about it, in a few words


class Diagnosis(NamedTuple):
    """What a pair of points says about itself; NaN where they coincide to rounding."""

    d_n1: float  #: angle between the line through the points and body 1's normal, degrees; 0 for a true common normal
    d_n2: float  #: the same for body 2
    n1_n2: float  #: angle between body 1's normal and the opposite of body 2's, degrees
    residues: NDArray[np.float64]  #: (5,) R1 .. R5 of the source, overlapping sense


def methods() -> list[Method]:
    """All methods; ``auto`` is the one to use, the others are there to be compared.

    >>> [m.problem for m in plumb.methods() if m.name == "auto"]
    ['common_normal']
    """
    return [Method(*row) for row in _native.methods()]


def solve(
    body1: Body | ConvexBody,
    body2: Body | ConvexBody,
    method: str = "auto",
    *,
    want: str | Iterable[str] = ("overlap", "normal", "points"),
    motion: ArrayLike | None = None,
    last: Contact | None = None,
    iteration_limit: int = 100,
    tolerance: float = 0.0,
    patch_tolerance: float = 1e-3,
) -> Contact:
    """Solves the contact of a pair.

    body1, body2     lengths in one unit, world frame; a Body, or a ConvexBody of any shape
    method           a name of ``methods()``; ``auto`` alone where a ConvexBody is one of the pair
    want             of overlap, normal, points, curvature, derivatives, patch, or all of them as "overlap,normal"; none: the
                     verdict alone. Curvature and derivatives are of ``auto`` only, the patch of ``auto`` and two Body.
    motion           (3,) velocity of body 2 relative to body 1, any unit; ``first_touch`` goes back along it
    last             an earlier answer for bodies of these shapes nearby: where the search starts (a warm start)
    iteration_limit  of each local solve
    tolerance        residual relative to the size at which a method may stop; 0: all that rounding allows
    patch_tolerance  relative error at which a patch may stop

    The answer's ``status`` says how the solve ended: no method raises because it found nothing. ValueError and TypeError
    name an argument that is not legal.

    >>> ball = plumb.Body((1, 1, 1), (0, 0, 0))
    >>> contact = plumb.solve(ball, plumb.Body((1, 1, 2), (1.5, 0, 0)))
    >>> print(contact.status, contact.verdict, contact.overlap)
    converged overlapping 0.5
    >>> contact.normal
    array([1., 0., 0.])
    """
    return _native.solve(
        body1, body2, method, words_of(want, "want"), motion, last, iteration_limit, (tolerance, patch_tolerance)
    )


def diagnose(body1: Body, body2: Body, contact: Contact) -> Diagnosis:
    """How true an answer's pair of points stands: three angles in degrees, and the residues R1 .. R5 of the source.

    body1, body2  those of the answer
    contact       an answer with points, of ``solve``

    TypeError names an argument of another type.

    >>> ball = plumb.Body((1, 1, 1), (0, 0, 0))
    >>> other = plumb.Body((1, 2, 3), (1.5, 0, 0))
    >>> plumb.diagnose(ball, other, plumb.solve(ball, other)).n1_n2
    0.0
    """
    return Diagnosis(*_native.diagnose(body1, body2, contact))
