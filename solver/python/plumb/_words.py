"""The words of an answer, whose numbers are those of the C API, and lists of words as arguments."""

from __future__ import annotations

import enum
from collections.abc import Iterable


class Status(enum.IntEnum):
    """How a solve ended. Only ``converged`` vouches for the residual, and not even that for the answer: see ``certify``."""

    converged = 0  #: the residual is below the tolerance, or below what rounding allows
    iteration_limit = 1  #: the limit was reached first
    stalled = 2  #: no step lowers the residual; or ``auto`` cannot show that its common normal is the lowest
    singular = 3  #: the Jacobian lost rank
    not_finite = 4  #: a NaN or an infinity came up on the way
    invalid_input = 5  #: a body is not legal: an axis of 0, a NaN

    def __str__(self) -> str:
        return self.name


class Verdict(enum.IntEnum):
    """Whether the bodies overlap. ``undecided``: the overlap is 0 to within the rounding floor of the answer, or there is no answer."""

    undecided = 0  #: nobody can say in doubles, or there is no answer
    overlapping = 1  #: the bodies share points
    separated = 2  #: they share none

    def __str__(self) -> str:
        return self.name


def words_of(value: str | Iterable[str], argument: str) -> list[str]:
    """Names as a list, or with commas as on the command line; TypeError names the argument that is neither."""
    if isinstance(value, str):
        return value.split(",") if value else []
    words = list(value) if isinstance(value, Iterable) else None
    if words is None or not all(isinstance(word, str) for word in words):
        raise TypeError(f"{argument}: must be names, as a list or with commas")
    return words
