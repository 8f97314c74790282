"""Many pairs at once, as arrays."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, fields
from typing import Any, Literal

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _native
from ._native import Body
from ._words import words_of

_Floats = NDArray[np.float64]
_Ints = NDArray[np.int32]


def _shape_text(shape: tuple[int, ...]) -> str:
    return "(" + ", ".join(map(str, shape)) + ("," if len(shape) == 1 else "") + ")"


def _float_array(value: ArrayLike, name: str, columns: int) -> _Floats:
    """float64, aligned, of shape (n, columns) or (columns,); a view of what was given wherever that is one."""
    try:
        array = np.asarray(value)
    except ValueError:
        raise ValueError(f"{name}: must be an array of shape (n, {columns})") from None
    if array.dtype.kind not in "fiu" or array.dtype.itemsize > 8:
        raise TypeError(f"{name}: must be of real numbers that fit in float64, not of {array.dtype}")
    if array.ndim not in (1, 2) or array.shape[-1] != columns:
        raise ValueError(f"{name}: must have shape (n, {columns}) or ({columns},), not {_shape_text(array.shape)}")
    return np.require(array, np.float64, "A")


def _row_of(body: Body, index: int) -> tuple[_Floats, ...]:
    if not isinstance(body, Body):
        raise TypeError(f"bodies[{index}]: must be a plumb.Body, not {type(body).__name__}")
    return body.semi_axes, body.position, body.quaternion, body.exponents


def _by_whole_numbers(array: NDArray[Any]) -> bool:
    return all(stride % array.itemsize == 0 for stride in array.strides)


@dataclass(frozen=True, eq=False)
class Bodies:
    """One body of each pair, as arrays; an array of one dimension holds for all.

    semi_axes   (n, 3) or (3,) a, b, c > 0; a length
    position    (n, 3) or (3,) of the centres, world frame; a length
    quaternion  (n, 4) or (4,) w, x, y, z of any non-zero length; takes body axes to the world's
    exponents   (n, 2) or (2,) n1, n2 > 1

    Any layout will do, and no copy is made of float64: not of (n, 3) by rows, nor of columns, nor of a slice. By columns, as
    ``np.empty((3, n)).T``, is what the solver reads in place. A body that is not legal (a NaN, an axis of 0) is no error here: its
    answer has the status ``invalid_input``. ValueError and TypeError name the argument whose shape or type is not legal.

    >>> bodies = plumb.Bodies((1, 1, 2), np.zeros((5, 3)))
    >>> len(bodies)
    5
    """

    semi_axes: _Floats
    position: _Floats
    quaternion: _Floats
    exponents: _Floats

    def __init__(
        self,
        semi_axes: ArrayLike,
        position: ArrayLike,
        quaternion: ArrayLike = (1.0, 0.0, 0.0, 0.0),
        exponents: ArrayLike = (2.0, 2.0),
    ) -> None:
        given = {
            "semi_axes": _float_array(semi_axes, "semi_axes", 3),
            "position": _float_array(position, "position", 3),
            "quaternion": _float_array(quaternion, "quaternion", 4),
            "exponents": _float_array(exponents, "exponents", 2),
        }
        first = next(((name, array) for name, array in given.items() if array.ndim == 2), None)
        for name, array in given.items():
            if first and array.ndim == 2 and len(array) != len(first[1]):
                raise ValueError(f"{name}: must have {len(first[1])} rows as {first[0]} has, not {len(array)}")
            object.__setattr__(self, name, array)

    def __len__(self) -> int:
        """How many; 1 where every array has one dimension."""
        return next((len(array) for array in self._arrays() if array.ndim == 2), 1)

    def __getitem__(self, index: int) -> Body:
        """One of them, by ``index`` as in a list; ValueError if the body is not legal."""
        if not isinstance(index, (int, np.integer)):
            raise TypeError(f"index: must be a whole number, not {type(index).__name__}")
        if not -len(self) <= index < len(self):
            raise IndexError(f"index: {index} of {len(self)} bodies")
        return Body(*(array[index] if array.ndim == 2 else array for array in self._arrays()))

    @classmethod
    def of(cls, bodies: Iterable[Body]) -> Bodies:
        """Of single ones; TypeError for another thing among ``bodies``.

        >>> len(plumb.Bodies.of([plumb.Body((1, 1, 1), (0, 0, 0))] * 3))
        3
        """
        if not isinstance(bodies, Iterable):
            raise TypeError(f"bodies: must be several plumb.Body, not {type(bodies).__name__}")
        rows = [_row_of(body, index) for index, body in enumerate(bodies)]
        widths = (3, 3, 4, 2)
        return cls(*(np.reshape([row[k] for row in rows], (len(rows), width)) for k, width in enumerate(widths)))

    def _arrays(self) -> tuple[_Floats, ...]:
        return (self.semi_axes, self.position, self.quaternion, self.exponents)

    def _is_one(self) -> bool:
        return all(array.ndim == 1 for array in self._arrays())

    def _columns(self, size: int) -> tuple[_Floats | None, ...]:
        """What the module takes: (n, k) all of them, no exponents for ellipsoids."""
        ellipsoids = self.exponents.ndim == 1 and bool(np.all(self.exponents == 2))
        arrays = self._arrays()[:3] if ellipsoids else self._arrays()
        columns = tuple(np.broadcast_to(array, (size, array.shape[-1])) for array in arrays)
        whole = tuple(array if _by_whole_numbers(array) else array.copy() for array in columns)
        return (*whole, None) if ellipsoids else whole


@dataclass(frozen=True, eq=False)
class Contacts:
    """The answers of a batch, as arrays; None where not asked for. NaN where the status is not ``converged``."""

    status: _Ints  #: (n,) plumb.Status
    verdict: _Ints  #: (n,) plumb.Verdict
    overlap: _Floats | None = None  #: (n,) a length; > 0: penetration, < 0: minus the distance
    normal: _Floats | None = None  #: (n, 3) unit, from body 1 to body 2
    points: _Floats | None = None  #: (n, 2, 3) on body 1 and on body 2, world frame
    contact_point: _Floats | None = None  #: (n, 3) where a force would act; goes with points
    iterations: _Ints | None = None  #: (n,) steps of the solve that answered
    evaluations: _Ints | None = None  #: (n,) of the residual, over all there was
    charts: _Floats | None = None  #: (n, 2, 2, 3) where this solve and the one before ended, on both bodies

    def __len__(self) -> int:
        return len(self.status)

    @classmethod
    def empty(
        cls, size: int, want: str | Iterable[str] = ("overlap", "normal", "points"), order: Literal["C", "F"] = "F"
    ) -> Contacts:
        """Arrays for ``solve_batch(..., out=)``, not filled in.

        size   how many; each array has so many rows
        want   of overlap, normal, points (with contact_point), iterations, evaluations, charts
        order  "F" by columns, which the solver writes in place, or "C" by rows

        ValueError names what is not among these.
        """
        names = _array_names(want)
        if not isinstance(size, (int, np.integer)):
            raise TypeError(f"size: must be a whole number, not {type(size).__name__}")
        if size < 0:
            raise ValueError("size: must be 0 or more")
        if order not in ("C", "F"):
            raise ValueError(f"order: must be 'C' or 'F', not {order!r}")
        arrays: dict[str, Any] = {name: np.empty((size, *_TAILS[name]), _TYPES[name], order) for name in names}
        return cls(**arrays)


_TAILS: dict[str, tuple[int, ...]] = {"normal": (3,), "points": (2, 3), "contact_point": (3,), "charts": (2, 2, 3)}
_TYPES: dict[str, type] = {}
for _field in fields(Contacts):
    _TAILS.setdefault(_field.name, ())
    _TYPES[_field.name] = np.int32 if "_Ints" in str(_field.type) else np.float64


def _array_names(want: str | Iterable[str]) -> list[str]:
    words = words_of(want, "want")
    known = ("overlap", "normal", "points", "iterations", "evaluations", "charts")
    for word in words:
        if word not in known:
            raise ValueError(f"want: no {word!r} among {', '.join(known)}")
    return ["status", "verdict", *words, *(["contact_point"] if "points" in words else [])]


def _share_memory(one: NDArray[Any], other: NDArray[Any]) -> bool:
    """True as well where numpy finds the question too hard, as it may be for layouts that nobody has."""
    try:
        return np.shares_memory(one, other, max_work=10**5)
    except Exception:  # np.TooHardError, which numpy 2 keeps elsewhere
        return True


def _check_out(out: Contacts, size: int, inputs: tuple[_Floats | None, ...]) -> None:
    """ValueError, TypeError: not the shape, the type or the memory to write answers to."""
    arrays = {field.name: getattr(out, field.name) for field in fields(out)}
    seen: list[_Floats] = [array for array in inputs if array is not None]
    for name, array in arrays.items():
        if array is None and name not in ("status", "verdict"):
            continue
        shape = (size, *_TAILS[name])
        if not isinstance(array, np.ndarray) or array.dtype != _TYPES[name]:
            raise TypeError(f"out.{name}: must be an array of {_TYPES[name].__name__}")
        if array.shape != shape:
            raise ValueError(f"out.{name}: must have shape {_shape_text(shape)}, not {_shape_text(array.shape)}")
        if not (array.flags.writeable and array.flags.aligned and _by_whole_numbers(array)):
            raise ValueError(f"out.{name}: must be writeable and aligned")
        if any(_share_memory(array, other) for other in seen):
            raise ValueError(f"out.{name}: shares memory with another array of the call")
        seen.append(array)


def _charts_of(last: Contacts | None, size: int) -> _Floats | None:
    """What a warm batch starts from; None: cold."""
    if last is None:
        return None
    if not isinstance(last, Contacts):
        raise TypeError(f"last: must be plumb.Contacts, not {type(last).__name__}")
    if last.charts is None:
        raise ValueError("last: has no charts; want them of the batch before")
    charts = np.asarray(last.charts)
    shape = (size, *_TAILS["charts"])
    if charts.dtype != np.float64:
        raise TypeError(f"last.charts: must be of float64, not of {charts.dtype}")
    if charts.shape != shape:
        raise ValueError(f"last.charts: must have shape {_shape_text(shape)}, not {_shape_text(charts.shape)}")
    return charts if charts.flags.aligned and _by_whole_numbers(charts) else charts.copy()


def _size_of(bodies1: Bodies, bodies2: Bodies) -> int:
    for bodies, name in ((bodies1, "bodies1"), (bodies2, "bodies2")):
        if not isinstance(bodies, Bodies):
            raise TypeError(f"{name}: must be plumb.Bodies, not {type(bodies).__name__}")
    size = len(bodies2) if bodies1._is_one() else len(bodies1)
    for bodies, name in ((bodies1, "bodies1"), (bodies2, "bodies2")):
        if not bodies._is_one() and len(bodies) != size:
            raise ValueError(f"{name}: must be {size} as bodies1 are, not {len(bodies)}")
    return size


def solve_batch(
    bodies1: Bodies,
    bodies2: Bodies,
    *,
    want: str | Iterable[str] | None = None,
    out: Contacts | None = None,
    last: Contacts | None = None,
    threads: int = 1,
    iteration_limit: int = 100,
    tolerance: float = 0.0,
) -> Contacts:
    """Solves the contacts of all pairs by ``auto``, several side by side in the processor's registers.

    bodies1, bodies2  as many of each; one with arrays of one dimension only is paired with every other
    want              of overlap, normal, points (with contact_point), iterations, evaluations, charts, or "overlap,normal";
                      without it overlap, normal and points
    out               where the answers go, ``Contacts.empty`` or an earlier answer; it takes the place of ``want``
    last              the answers of the step before, with charts, from which to start: the same to rounding; may be ``out``
    threads           1 or more, at most 1024 are used; the answers are the same bits whatever the number
    iteration_limit   of each local solve
    tolerance         residual relative to the size at which a solve may stop; 0: all that rounding allows

    Gives ``out``, or new arrays by columns. Ellipsoids get the bits that ``solve`` gives, other exponents the same to rounding.
    Other Python threads run meanwhile, and Ctrl-C ends it. ValueError and TypeError name an argument that is not legal.

    >>> line = np.linspace(1.5, 2.5, 5)
    >>> others = plumb.Bodies((1, 1, 1), np.stack([line, 0 * line, 0 * line], axis=1))
    >>> plumb.solve_batch(plumb.Bodies((1, 1, 1), (0, 0, 0)), others).overlap
    array([ 0.5 ,  0.25,  0.  , -0.25, -0.5 ])
    """
    size = _size_of(bodies1, bodies2)
    inputs = bodies1._columns(size), bodies2._columns(size)
    charts = _charts_of(last, size)
    if out is None:
        out = Contacts.empty(size, ("overlap", "normal", "points") if want is None else want)
    elif not isinstance(out, Contacts):
        raise TypeError(f"out: must be plumb.Contacts, not {type(out).__name__}")
    elif want is not None:
        raise ValueError("want: must not be given with out, whose arrays say it")
    else:
        _check_out(out, size, (*inputs[0], *inputs[1], None if last is out else charts))
    arrays = tuple(getattr(out, field.name) for field in fields(out))
    _native.solve_batch(*inputs, arrays, charts, size, iteration_limit, tolerance, threads)
    return out
