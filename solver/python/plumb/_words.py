"""The words of an answer; the numbers are those of the C API."""

from __future__ import annotations

import enum


class Status(enum.IntEnum):
    """How a solve ended. Only ``converged`` vouches for the residual, and not even that for the answer: see ``certify``."""

    converged = 0
    iteration_limit = 1
    stalled = 2
    singular = 3
    not_finite = 4
    invalid_input = 5

    def __str__(self) -> str:
        return self.name


class Verdict(enum.IntEnum):
    """``undecided``: the overlap is 0 to within the rounding floor of the answer, or there is no answer."""

    undecided = 0
    overlapping = 1
    separated = 2

    def __str__(self) -> str:
        return self.name
