"""The page of the package's names: each is on it, with the parts that its text must have; and what the page's maker must refuse."""

import importlib.util
import os
import pathlib
import subprocess
import sys
import types
import unittest

import plumb

MAKER = pathlib.Path(os.environ["PLUMB_SOURCE_DIR"], "reports/docs/python_reference.py")
TEXT = """Adds.

    first   (3,) a length
    second  a number

    ValueError names what is not legal.

    >>> 1 + 1
    2
    """


def load():
    spec = importlib.util.spec_from_file_location("python_reference", MAKER)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def complaints(text, gives="float"):
    """What the maker says of a package with one function that has this text."""

    def add(first, second): ...

    add.__doc__, add.__annotations__["return"] = text, gives
    maker = load()
    return list(maker.missing(maker.Package(types.SimpleNamespace(__all__=["add"], add=add), "")))


class Reference(unittest.TestCase):
    def test_every_public_name_is_on_the_page(self):
        ran = subprocess.run([sys.executable, "-B", MAKER], capture_output=True, text=True)
        self.assertEqual((ran.returncode, ran.stderr), (0, ""))
        for name in plumb.__all__:
            if not name.startswith("_"):
                self.assertIn(f"{{#python_{name}}}", ran.stdout)
        self.assertIn("(n, 3) unit, from body 1 to body 2", ran.stdout)
        self.assertNotRegex(ran.stdout, r"\b(_Floats|_Ints|StrPath)\b")

    def test_a_text_lacks_nothing(self):
        self.assertEqual(complaints(TEXT), [])

    def test_a_text_lacks_a_part(self):
        for lacking, told in (
            ("Adds.", "has no text"),
            ("second  a number", "does not say what second is"),
            ("ValueError names what is not legal.", "does not say what it raises"),
            (">>> 1 + 1\n    2", "has no example"),
        ):
            self.assertIn(f"add: {told}", complaints(TEXT.replace(lacking, "")))

    def test_a_dict_is_told(self):
        self.assertEqual(complaints(TEXT, "Json"), ["add: does not say what it gives"])
        self.assertEqual(complaints(TEXT.replace("ValueError names", 'Gives "sum". ValueError names'), "Json"), [])


if __name__ == "__main__":
    unittest.main()
