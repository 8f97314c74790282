"""make_wheel.py WHEEL.json FOLDER: a wheel of the package as it was built, with the programs that it runs.

WHEEL.json is written by CMake (CMakeLists.txt): the version, the package's folder, and the programs that go into its bin. Needs nothing but
Python. The name of the wheel is the last line printed.
"""

import base64
import hashlib
import json
import pathlib
import sys
import sysconfig
import zipfile

METADATA = """Metadata-Version: 2.1
Name: plumb
Version: {version}
Summary: Contact normals of ellipsoids and superquadrics, and the harness that proves them right
License: BSD-3-Clause
Requires-Python: >=3.10
Requires-Dist: numpy
"""
WHEEL = """Wheel-Version: 1.0
Generator: plumb
Root-Is-Purelib: false
Tag: {tag}
"""


def tag():
    """Of this Python, this machine and its libraries: the programs are linked to Debian's."""
    python = "cp{0.major}{0.minor}".format(sys.version_info)
    platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    return f"{python}-{python}-{platform}"


def package_files(package):
    return [path for path in sorted(package.iterdir()) if path.is_file()]


class Wheel:
    """A zip file that keeps the record of what it holds; the times in it are fixed, so that the same files make the same wheel."""

    def __init__(self, file):
        self.zip = zipfile.ZipFile(file, "w", zipfile.ZIP_DEFLATED, compresslevel=6)
        self.record = []

    def add(self, name, data, mode=0o644):
        digest = base64.urlsafe_b64encode(hashlib.sha256(data).digest()).rstrip(b"=").decode()
        self.record.append(f"{name},sha256={digest},{len(data)}")
        self._write(name, data, mode)

    def close(self, record_name):
        self._write(record_name, "\n".join([*self.record, f"{record_name},,", ""]).encode(), 0o644)
        self.zip.close()

    def _write(self, name, data, mode):
        entry = zipfile.ZipInfo(name)
        entry.external_attr = (0o100000 | mode) << 16
        entry.compress_type = zipfile.ZIP_DEFLATED
        self.zip.writestr(entry, data)


def make(described, folder):
    folder.mkdir(parents=True, exist_ok=True)
    version = described["version"]
    file = folder / f"plumb-{version}-{tag()}.whl"
    wheel = Wheel(file)
    for path in package_files(pathlib.Path(described["package"])):
        wheel.add(f"plumb/{path.name}", path.read_bytes())
    for path in map(pathlib.Path, described["programs"]):
        wheel.add(f"plumb/bin/{path.name}", path.read_bytes(), 0o755)
    info = f"plumb-{version}.dist-info"
    wheel.add(f"{info}/METADATA", METADATA.format(version=version).encode())
    wheel.add(f"{info}/WHEEL", WHEEL.format(tag=tag()).encode())
    wheel.add(f"{info}/LICENSE", pathlib.Path(described["license"]).read_bytes())
    wheel.close(f"{info}/RECORD")
    return file


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    print(make(json.loads(pathlib.Path(sys.argv[1]).read_text()), pathlib.Path(sys.argv[2])))
