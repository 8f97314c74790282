"""The program ``plumb``: where it is, and how it is run."""

from __future__ import annotations

import json
import os
import re
import shutil
import signal
import subprocess
from collections.abc import Mapping
from pathlib import Path
from typing import Any

import numpy as np

_PACKAGE = Path(__file__).absolute().parent


def find_program() -> Path:
    """The program that ``campaign``, ``scene``, ``certify`` and their like run.

    Looked for in the package's own folder bin (a wheel), in the bin of the tree that the package was built or installed in, then in
    PATH. FileNotFoundError where there is none.

    >>> plumb.find_program().name
    'plumb'
    """
    parents = _PACKAGE.parents
    near = [_PACKAGE / "bin", *(parents[level] / "bin" for level in (1, 3) if level < len(parents))]
    for folder in near:
        # plumb is nothing without the commands beside it; where it is installed, bin has a link to it
        program = (folder / "plumb").resolve()
        if program.is_file() and (program.parent / "plumb-solve").is_file():
            return program
    if found := shutil.which("plumb"):
        return Path(found)
    looked = ", ".join(map(str, near))
    raise FileNotFoundError(f"no program 'plumb' in {looked} or PATH: install plumb, or its wheel")


def to_json(value: Any, argument: str) -> str:
    """Of dicts, lists, numbers and numpy's arrays. TypeError for anything else and ValueError for NaN, infinities and what holds itself,
    which JSON has not; both name the argument."""

    def plain(other: Any) -> Any:
        if isinstance(other, (np.ndarray, np.generic)):
            return other.tolist()
        raise TypeError(f"{argument}: JSON has no {type(other).__name__}")

    try:
        return json.dumps(value, default=plain, allow_nan=False)
    except (ValueError, RecursionError):
        raise ValueError(f"{argument}: holds NaN, an infinity or itself, which JSON has not") from None


def path_of(value: Any, argument: str) -> str:
    """A file's or a folder's; TypeError names the argument that is neither."""
    if not isinstance(value, (str, os.PathLike)):
        raise TypeError(f"{argument}: must be a path, not {type(value).__name__}")
    return os.fspath(value)


def options(given: Mapping[str, Any]) -> list[str]:
    """{"seed": 1, "shrink": True, "out": None} as --seed 1 --shrink."""
    out: list[str] = []
    for name, value in given.items():
        if value is None or value is False:
            continue
        out.append("--" + name)
        if value is not True:
            out.append(os.fspath(value) if isinstance(value, os.PathLike) else str(value))
    return out


def run(arguments: list[str], argument: str, text: str = "") -> tuple[bool, str]:
    """Whether the program found something (exit code 1), and what it printed; ``text`` is its standard input.

    ValueError with the program's own line for unusable input, which begins with the name of an option, or of ``argument``, of which the
    program's input was made; empty: of the field. RuntimeError where it does not end as it should. Ctrl-C reaches it, once, and
    KeyboardInterrupt is raised when it has kept what was done; a second Ctrl-C ends it at once.
    """
    # A session of its own: a terminal's Ctrl-C would reach it a second time, and end it.
    process = subprocess.Popen(
        [str(find_program()), *arguments],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        encoding="utf-8",
        start_new_session=True,
    )
    try:
        printed, complaint = process.communicate(text)
    except BaseException:
        _stop(process)
        raise
    return _judge(process.returncode, arguments, argument, complaint), printed


def _stop(process: subprocess.Popen[str]) -> None:
    try:
        process.send_signal(signal.SIGINT)
        process.communicate()
    except BaseException:
        process.kill()
        process.wait()
        raise


def _in_pythons_words(line: str, arguments: list[str], argument: str) -> str:
    """ "plumb scene: --threads: REASON (--help tells more)" is about ``threads``, a line about the file of an option about that."""
    line = line.removeprefix(f"plumb {arguments[0]}: ").removesuffix(" (--help tells more)")
    if line.startswith("--"):
        return line.removeprefix("--")
    for option, value in zip(arguments, arguments[1:]):
        if option.startswith("--") and line.startswith((f"{value}:", f"{value}/")):
            return f"{option.removeprefix('--')}: {line}"
    reason = re.sub(r"^standard input(:\d+)?: ", "", line)
    return f"{argument}: {reason}" if argument else reason


def _judge(code: int, arguments: list[str], argument: str, complaint: str) -> bool:
    command = arguments[0]
    last = (complaint.strip().splitlines() or ["it said nothing"])[-1]
    if code == 2:
        raise ValueError(_in_pythons_words(last, arguments, argument))
    if code == 130:
        raise KeyboardInterrupt
    if code not in (0, 1):
        how = f"signal {-code}" if code < 0 else f"exit code {code}"
        raise RuntimeError(f"plumb {command} ended with {how}: {last}")
    return code == 1
