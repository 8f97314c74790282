"""The wheel of this build, installed to a folder: the package works from there with its own programs, and pip accepts it."""

import importlib.util
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(os.environ["PLUMB_SOURCE_DIR"])
DESCRIBED = pathlib.Path(os.environ["PLUMB_BINARY_DIR"], "python/wheel.json")

USED = """import plumb
ball = plumb.Body((1, 1, 1), (0, 0, 0))
other = plumb.Body((1, 1, 2), (1.5, 0, 0))
print(plumb.find_program())
print(plumb.solve(ball, other).overlap, plumb.certify(ball, other, digits=2).unique)
print(plumb.campaign("spheroid", 3, method="auto").summary["cases"], plumb.scene(plumb.named_scene("impact"))["complete"])
"""

# In the place of CMake, which takes minutes: what it needs of Python, and the wheel of this build.
CMAKE = """#!/bin/sh -e
/usr/bin/python3 -c "import numpy"
[ "$1" != --build ] || /usr/bin/python3 '{make_wheel}' '{described}' build/release/dist
"""


def run(*command, **named):
    return subprocess.run([sys.executable, "-B", *map(str, command)], capture_output=True, text=True, check=True, **named).stdout


@unittest.skipUnless(importlib.util.find_spec("pip"), "needs python3-pip")
class Wheel(unittest.TestCase):
    def test_works_where_it_is_installed(self):
        with tempfile.TemporaryDirectory() as folder:
            wheel = run(ROOT / "solver/python/make_wheel.py", DESCRIBED, folder).strip()
            target = pathlib.Path(folder, "installed")
            run("-m", "pip", "install", "--quiet", "--no-index", "--no-deps", "--target", target, wheel)
            said = run("-c", USED, cwd=folder, env={"PYTHONPATH": str(target), "PATH": "/usr/bin:/bin"})
            program = target / "plumb/bin/plumb"
            self.assertEqual(said, f"{program}\n0.5 proved\n3 True\n")

    @unittest.skipUnless(sys.executable == "/usr/bin/python3", "is of Debian's Python")
    def test_pip_makes_it(self):
        with tempfile.TemporaryDirectory() as folder:
            tree, out, bin = (pathlib.Path(folder, name) for name in ("tree", "out", "bin"))
            for file in ("make_wheel.py", "pyproject.toml", "wheel_backend.py"):
                (tree / "solver/python").mkdir(parents=True, exist_ok=True)
                shutil.copy(ROOT / "solver/python" / file, tree / "solver/python")
            bin.mkdir()
            (bin / "cmake").write_text(CMAKE.format(make_wheel=tree / "solver/python/make_wheel.py", described=DESCRIBED))
            (bin / "cmake").chmod(0o755)
            pip = ["-m", "pip", "wheel", "--quiet", "--no-deps", "--wheel-dir", out, tree / "solver/python"]
            run(*pip, env={**os.environ, "PATH": f"{bin}:/usr/bin:/bin"})
            self.assertEqual([file.name for file in out.iterdir()], [file.name for file in (tree / "build/release/dist").iterdir()])


if __name__ == "__main__":
    unittest.main()
