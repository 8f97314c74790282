"""A test: a scene, what is measured of its run, and what is exact."""

import dataclasses
import typing

CHUNG = "Chung & Ooi 2011"


@dataclasses.dataclass
class Case:
    name: str                 # also of its folder
    test: str                 # what stands in the table
    source: str
    scene: dict
    exact: dict               # quantity: number
    read: typing.Callable     # run -> {quantity: number}
    scale: dict = dataclasses.field(default_factory=dict)  # what errors are relative to, where not to the exact value
    limit: float = 1e-3       # at the finest accuracy


@dataclasses.dataclass
class Set:
    """Many alike cases in one row: the worst of them is shown."""

    name: str
    test: str
    source: str
    cases: list
    limit: float = 1e-3
