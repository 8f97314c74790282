"""Files edited badly, of every kind that plumb reads, each handed to the commands that read it: no signal, no words of a library's,
each refusal (exit code 2) one line that names the file, and the field where the file is JSON.

A day's run edits a thousand files, a night's (PLUMB_NIGHTLY=1) five thousand: the same for the same samples, of which those that hold
times are not. The files of findings stay in build/PRESET/tests/mutated.
"""

import collections
import concurrent.futures
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import tempfile
import unittest

from kinds import KINDS, make_samples, with_seal
from mutations import mutated

KEPT = pathlib.Path(os.environ["PLUMB_BINARY_DIR"]) / "tests" / "mutated"
PROGRAM = pathlib.Path(os.environ["PLUMB_BINARY_DIR"]) / "bin" / "plumb"
FILES = 5000 if os.environ.get("PLUMB_NIGHTLY") == "1" else 1000
SECONDS = 120  # of a command; most take a hundredth of one
FOREIGN = re.compile(
    r"exception|std::|what\(\)|terminate|Assertion|basic_|vector::|stoi|stod|bad_alloc|nlohmann|boost|CLI::|fmt::|filesystem error|"
    r"runtime error|Sanitizer|regex|number overflow|syntax error|unexpected|last read",
    re.I,
)


class Finding(Exception):
    pass


def plumb_in(folder, arguments, stdin=subprocess.DEVNULL):
    return subprocess.run([PROGRAM, *arguments.split()], cwd=folder, stdin=stdin, capture_output=True, timeout=SECONDS, check=False)


def sample_maker(folder):
    def plumb(arguments):
        ran = plumb_in(folder, arguments)
        if ran.returncode not in (0, 1):
            raise RuntimeError(f"plumb {arguments}: {ran.returncode}: {ran.stderr.decode()}")
        return ran.stdout.decode()

    return plumb


def kept_in(folder, file):
    """KEPT stands for the one file there whose name is not known before."""
    if not file.endswith("KEPT"):
        return file
    found = sorted(path for path in (folder / file).parent.rglob("*") if path.is_file())
    return str(found[0].relative_to(folder))


def link_or_copy(source, target):
    """Runs append to their files, and locks are held by file; all else is replaced as a whole."""
    if "/run/" in source or "/." in source:
        shutil.copy(source, target)
    else:
        os.link(source, target)


def is_json(data):
    """An object, each name once: what a reader can name a field of."""

    def once(pairs):
        if len({key for key, _ in pairs}) < len(pairs):
            raise ValueError
        return dict(pairs)

    def refuse(_):
        raise ValueError

    try:
        return isinstance(json.loads(data.decode("utf-8-sig"), object_pairs_hook=once, parse_constant=refuse), dict)
    except (ValueError, RecursionError):
        return False


def sample_data(samples, name):
    return (samples / kept_in(samples, name)).read_bytes()


def edited_data(samples, kind, number):
    """Of the edited file number `number` of a kind."""
    draw = random.Random(f"{kind.name}:{number}")
    data = mutated(draw, sample_data(samples, draw.choice(kind.samples)), kind.form)
    return with_seal(data) if kind.sealed and draw.random() < 0.7 else data


class File:
    """A file of a kind, in a folder of its own."""

    def __init__(self, samples, kind, data):
        self.kind, self.samples, self.data = kind, samples, data
        self.name = kept_in(samples, kind.file)

    def codes(self):
        """Every command's exit code; raises Finding."""
        return [self.code_of(command) for command in self.kind.commands]

    def code_of(self, command):
        with tempfile.TemporaryDirectory() as top:
            folder = pathlib.Path(top, "f")
            shutil.copytree(self.samples, folder, copy_function=link_or_copy)
            (folder / self.name).unlink(missing_ok=True)
            (folder / self.name).write_bytes(self.data)
            code = self.run(folder, command)
            if self.kind.mended and (folder / self.name).read_bytes() != sample_data(self.samples, self.kind.file):
                raise Finding(f"plumb {command}: {code}: the file is not as it was")
            return code

    def run(self, folder, command):
        arguments, _, source = command.partition(" < ")
        name = "standard input" if source else self.name
        try:
            with open(folder / (source or "balls.json"), "rb") as stdin:
                ran = plumb_in(folder, arguments, stdin)
        except subprocess.TimeoutExpired:
            raise Finding(f"plumb {command}: more than {SECONDS} s") from None
        try:
            self.check(ran.returncode, ran.stderr.decode(), name)
        except (Finding, UnicodeDecodeError) as error:
            raise Finding(f"plumb {command}: {ran.returncode}: {error}: {ran.stderr[:600]!r}") from None
        return ran.returncode

    def check(self, code, said, name):
        if code not in (0, 1, 2):
            raise Finding("no exit code of plumb's")
        if FOREIGN.search(said.replace(name, "")):
            raise Finding("a library's words")
        if code != 2:
            return
        if said.count("\n") != 1 or not said.endswith("\n") or not said[:-1].isprintable():
            raise Finding("not one line")
        place = re.match(r"([^:]+)(:\d+)?: (.*)", said)
        if not place or pathlib.PurePath(name).name not in said:
            raise Finding("does not name the file")
        # A line's own number is asked for where there are several.
        lines = self.data.split(b"\n")
        text = lines[int(place[2][1:]) - 1] if place[2] and self.kind.form == "lines" else self.data
        if self.kind.form in ("json", "lines") and is_json(text) and not re.match(r".+: .", place[3]):
            raise Finding("names no field")


class Mutated(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = pathlib.Path(folder.name)
        make_samples(cls.folder, sample_maker(cls.folder))
        shutil.rmtree(KEPT, ignore_errors=True)

    def test_each_sample_is_read_as_it_is(self):
        for kind in KINDS:
            for sample in kind.samples:
                with self.subTest(kind=kind.name, sample=sample):
                    codes = File(self.folder, kind, sample_data(self.folder, sample)).codes()
                    self.assertTrue({0, 1}.intersection(codes), codes)

    def test_files(self):
        numbers = [(kind, number) for number in range(FILES // len(KINDS) + 1) for kind in KINDS][:FILES]
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            outcomes = list(pool.map(self.outcome_of, *zip(*numbers)))
        findings = [outcome for outcome in outcomes if isinstance(outcome, str)]
        self.assertEqual(findings, [], "\n".join(["", *findings]))
        refused = collections.Counter(kind.name for (kind, _), codes in zip(numbers, outcomes) if 2 in codes)
        print(f"{FILES} files, of which refused: {dict(refused)}")
        self.assertEqual([kind.name for kind in KINDS if bool(refused[kind.name]) == kind.mended], [])

    def outcome_of(self, kind, number):
        """The commands' exit codes, or what was found."""
        file = File(self.folder, kind, edited_data(self.folder, kind, number))
        try:
            return file.codes()
        except Finding as finding:
            kept = KEPT / f"{number}-{file.name.replace('/', '-')}"
            KEPT.mkdir(parents=True, exist_ok=True)
            kept.write_bytes(file.data)
            return f"{kind.name} {number}, {kept}: {finding}"


if __name__ == "__main__":
    unittest.main()
