"""What pip calls (pyproject.toml): configure, build, and the wheel that CMake's target `wheel` makes."""

import os
import pathlib
import shutil
import subprocess
import sys

import make_wheel

ROOT = pathlib.Path(__file__).absolute().parents[2]


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    # As from a shell, so that build/release is configured as it is there: pip hides numpy from a build by PYTHONPATH.
    environment = {name: value for name, value in os.environ.items() if name not in ("PYTHONPATH", "PYTHONNOUSERSITE")}
    for command in (["--preset", "release"], ["--build", "--preset", "release", "--target", "wheel"]):
        subprocess.run(["cmake", *command], cwd=ROOT, env=environment, check=True)
    made = max((ROOT / "build/release/dist").glob("plumb-*.whl"), key=lambda file: file.stat().st_mtime_ns)
    if not made.name.endswith(f"-{make_wheel.tag()}.whl"):
        raise RuntimeError(f"build/release is of another Python than {sys.executable}: it made {made.name}")
    return shutil.copy(made, wheel_directory) and made.name
