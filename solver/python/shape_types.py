#!/usr/bin/env python3
"""shape_types.py FOLDER: writes FOLDER/_shapes.pyi, the types of the classes that the package FOLDER has for shapes."""

import re
import sys
from pathlib import Path

HEAD = "import numpy as np\nfrom numpy.typing import ArrayLike, NDArray\n"
VALUE = "    def __eq__(self, other: object) -> bool: ...\n    def __hash__(self) -> int: ...\n"


def class_lines(name, kind):
    """Its arguments, with their defaults, stand in the first line of its text; of a list its text begins with what it is shaped like."""
    call = re.match(r"\w+\((.*)\)\n", kind.__doc__)[1]
    is_list = {key: getattr(kind, key).__doc__.startswith("(") for key in re.findall(r"(\w+)(?:=\(.*?\))?(?:, |$)", call)}
    typed = re.sub(r"(\w+)(=\(.*?\))?(?=, |$)", lambda found: f"{found[1]}: {'ArrayLike' if is_list[found[1]] else 'float'}{(found[2] or '').replace('=', ' = ')}", call)
    yield f"\nclass {name}:\n    def __init__(self{', ' if typed else ''}{typed}) -> None: ...\n"
    for key, has_many in is_list.items():
        yield f"    @property\n    def {key}(self) -> {'NDArray[np.float64]' if has_many else 'float'}: ...\n"
    yield VALUE


def main():
    folder = Path(sys.argv[1])
    sys.path.insert(0, str(folder.parent))
    from plumb import _native

    lines = [HEAD]
    for name in _native.shapes:
        lines += class_lines(name, getattr(_native, name))
    lines.append(f"\nShape = {' | '.join(_native.shapes)}\n__all__ = {list(_native.shapes)}\n")
    (folder / "_shapes.pyi").write_text("".join(lines))


main()
