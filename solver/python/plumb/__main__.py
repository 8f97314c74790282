"""python3 -m plumb COMMAND ...: the program plumb that the package runs."""

import os
import sys

from ._program import find_program

if __name__ == "__main__":
    try:
        program = find_program()
    except FileNotFoundError as error:
        print(f"plumb: {error}", file=sys.stderr)
        sys.exit(2)
    os.execv(program, ["plumb", *sys.argv[1:]])
