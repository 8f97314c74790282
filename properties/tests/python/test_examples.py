"""The examples of the documentation, run as they stand."""

import importlib.util
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

EXAMPLES = pathlib.Path(os.environ["PLUMB_SOURCE_DIR"], "properties/tests/examples/python")


class Examples(unittest.TestCase):
    def run_example(self, name, folder):
        command = [sys.executable, "-B", str(EXAMPLES / name)]
        ran = subprocess.run(command, cwd=folder, capture_output=True, text=True)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        return ran.stdout

    def test_all_are_run(self):
        self.assertEqual(
            {path.name for path in EXAMPLES.glob("*.py")}, {"first_contact.py", "batch.py", "plot_misalignment.py"}
        )

    def test_first_contact(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertIn("converged overlapping", self.run_example("first_contact.py", folder))

    def test_batch(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertIn("of 100000 pairs overlap", self.run_example("batch.py", folder))

    @unittest.skipUnless(importlib.util.find_spec("matplotlib"), "needs python3-matplotlib")
    def test_plot(self):
        with tempfile.TemporaryDirectory() as folder:
            self.run_example("plot_misalignment.py", folder)
            self.assertEqual(pathlib.Path(folder, "misalignment.png").read_bytes()[:4], b"\x89PNG")


if __name__ == "__main__":
    unittest.main()
