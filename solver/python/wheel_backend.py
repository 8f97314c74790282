"""What pip calls (pyproject.toml): configure, build, and the wheel that CMake's target `wheel` makes."""

import pathlib
import shutil
import subprocess

ROOT = pathlib.Path(__file__).absolute().parents[2]


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    for command in (["--preset", "release"], ["--build", "--preset", "release", "--target", "wheel"]):
        subprocess.run(["cmake", *command], cwd=ROOT, check=True)
    made = max((ROOT / "build/release/dist").glob("plumb-*.whl"), key=lambda file: file.stat().st_mtime_ns)
    return shutil.copy(made, wheel_directory) and made.name
