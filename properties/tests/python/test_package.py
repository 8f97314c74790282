"""The package as others see it: the examples in its texts, its types, its public names."""

import doctest
import importlib
import inspect
import os
import pathlib
import pkgutil
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import plumb

FOLDER = pathlib.Path(plumb.__file__).absolute().parent

# pybind11 gives its classes a metaclass of its own, and those that only the module makes an __init__ that refuses.
ALLOWED = rf"""plumb._native.(Body|Contact|ConvexBody|Patch|PoseDerivative)
plumb._native.({"|".join(plumb._native.shapes)})
plumb._native.(Contact|Patch|PoseDerivative).__init__
"""


def modules():
    names = [name for _, name, _ in pkgutil.iter_modules([str(FOLDER)])]
    return [plumb, *(importlib.import_module(f"plumb.{name}") for name in names)]


class Package(unittest.TestCase):
    def test_examples_in_the_texts(self):
        tried = 0
        finder = doctest.DocTestFinder()
        texts = [text for module in modules() for text in finder.find(module)]
        natives = [name for name in plumb.__all__ if inspect.isclass(getattr(plumb._native, name, None))]
        texts += [text for name in natives for text in finder.find(getattr(plumb, name), name)]
        for text in texts:
            text.globs.update(plumb=plumb, np=np)
            result = doctest.DocTestRunner().run(text)
            self.assertEqual(result.failed, 0, text.name)
            tried += result.attempted
        self.assertGreater(tried, 40)

    def test_every_public_name_has_a_text(self):
        for name in plumb.__all__:
            thing = getattr(plumb, name)
            self.assertTrue(isinstance(thing, str) or inspect.getdoc(thing), name)
            if inspect.isclass(thing) and thing.__module__ == "plumb":
                for member, value in vars(thing).items():
                    self.assertTrue(member.startswith("_") or value.__doc__, f"{name}.{member}")

    def test_every_argument_stands_in_the_text(self):
        for name in plumb.__all__:
            thing = getattr(plumb, name)
            if not inspect.isfunction(thing):
                continue
            words = set(re.findall(r"\w+", inspect.getdoc(thing)))
            self.assertLessEqual(set(inspect.signature(thing).parameters), words, name)

    def run_python(self, *arguments, path=FOLDER.parent):
        environment = {**os.environ, "PYTHONPATH": str(path)}
        return subprocess.run([sys.executable, *arguments], env=environment, capture_output=True, text=True)

    def test_as_a_program(self):
        ran = self.run_python("-m", "plumb", "methods")
        self.assertEqual((ran.returncode, ran.stderr), (0, ""))
        self.assertIn("auto", ran.stdout)
        ran = self.run_python("-m", "plumb", "solve", "nowhere.json")
        self.assertEqual((ran.returncode, ran.stderr), (2, "nowhere.json: No such file or directory\n"))

    def test_without_numpy(self):
        """Isolated from the site's packages: as where numpy is not installed."""
        told = f"{sys.executable} has no numpy: pip install numpy, or install python3-numpy and call Debian's own /usr/bin/python3\n"
        ran = self.run_python("-S", "-c", "import plumb")
        self.assertEqual(ran.returncode, 1)
        self.assertTrue(ran.stderr.endswith(f"\nImportError: {told}"), ran.stderr)
        ran = self.run_python("-S", "-m", "plumb", "methods")
        self.assertEqual((ran.returncode, ran.stdout, ran.stderr), (2, "", told))

    @unittest.skipUnless(shutil.which("stubtest"), "needs mypy")
    def test_types(self):
        environment = {**os.environ, "MYPYPATH": str(FOLDER.parent), "PYTHONPATH": str(FOLDER.parent)}
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "allowed").write_text(ALLOWED)
            pathlib.Path(folder, "mypy.ini").write_text(f"[mypy]\nstrict = True\ncache_dir = {folder}/cache\n")
            for command in (
                ["mypy", "--config-file", "mypy.ini", "--python-executable", sys.executable, "-p", "plumb"],
                ["stubtest", "plumb._native", "--mypy-config-file", "mypy.ini", "--allowlist", "allowed"],
            ):
                ran = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)
                self.assertEqual(ran.returncode, 0, ran.stdout + ran.stderr)


if __name__ == "__main__":
    unittest.main()
