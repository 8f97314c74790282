"""CI's scripts, each in a tree of its own: which units a change touches, which seconds are too many, which pages are too long, what a
moved checkout is told."""

import json
import os
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

SCRIPTS = pathlib.Path(__file__).resolve().parents[3] / ".ci"


class InAFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.top = pathlib.Path(folder.name).resolve()
        (self.top / ".ci").mkdir()
        # Stand-ins for programs come first; nothing of the run that this is a part of.
        outer = {name: value for name, value in os.environ.items() if not name.startswith("PLUMB_")}
        self.environment = outer | {"PATH": f"{self.top}/bin:{os.environ['PATH']}"}

    def write(self, path, text):
        (self.top / path).parent.mkdir(parents=True, exist_ok=True)
        (self.top / path).write_text(text)

    def copy(self, script):
        shutil.copy(SCRIPTS / script, self.top / ".ci")

    def program(self, path, text):
        self.write(path, f"#!/bin/sh\n{text}\n")
        (self.top / path).chmod(0o755)

    def run_here(self, *command):
        return subprocess.run(command, cwd=self.top, env=self.environment, capture_output=True, text=True, check=False)


class Touched(InAFolder):
    def setUp(self):
        super().setUp()
        self.write("a/one.cpp", '#include <vector>\n#include "a/one.hpp"\n')
        self.write("a/two.cpp", '#include "a/both.hpp"\n')
        self.write("a/one.hpp", '#include "a/both.hpp"\n')
        self.write("a/both.hpp", '#  include "rows.inc"\n')
        self.write("a/rows.inc", "")
        self.write("b/small.cpp", '#include "a/both.hpp"\n')
        self.write("a/nowhere.hpp", "")
        self.write("build/unity.cxx", f'#include "{self.top}/a/one.cpp"\n#include "{self.top}/a/two.cpp"\n')
        entries = [{"directory": str(self.top / "build"), "file": file} for file in ("unity.cxx", str(self.top / "b/small.cpp"))]
        self.write("build/database.json", json.dumps(entries))

    def touched(self, *files):
        ran = self.run_here(SCRIPTS / "touched", "build/database.json", *files)
        self.assertEqual((ran.returncode, ran.stderr), (0, ""))
        return [pathlib.Path(entry["file"]).name for entry in json.loads(ran.stdout)]

    def test_a_source_is_linted_in_the_unit_that_holds_it(self):
        self.assertEqual(self.touched("a/two.cpp"), ["unity.cxx"])
        self.assertEqual(self.touched("b/small.cpp"), ["small.cpp"])

    def test_a_header_is_linted_once_in_the_cheapest_unit(self):
        self.assertEqual(self.touched("a/both.hpp"), ["small.cpp"])
        self.assertEqual(self.touched("a/rows.inc"), ["small.cpp"])
        self.assertEqual(self.touched("a/one.hpp"), ["unity.cxx"])
        self.assertEqual(self.touched("a/both.hpp", "a/one.hpp"), ["small.cpp", "unity.cxx"][::-1])

    def test_a_header_that_a_chosen_unit_reads_takes_no_other(self):
        self.assertEqual(self.touched("a/both.hpp", "a/one.cpp"), ["unity.cxx"])

    def test_what_no_unit_reads_is_not_linted(self):
        self.assertEqual(self.touched("a/nowhere.hpp", "README.md", "a/gone.cpp"), [])
        self.assertEqual(self.touched(), [])


class Times(InAFolder):
    def setUp(self):
        super().setUp()
        self.copy("times")
        self.copy("timed")
        self.write(".ci/limits.tsv", "# a table\ndefault\t60\nfast/dear\t100\n")
        self.write("build/fast/times.log", "dear\ta.o\t80\t0\ndear\ta.o\t70\t1.5\ndear\tb.o\t20\t0\ncheap\tc.o\t59\t0\n")
        self.write("ctest.xml", '<testsuite><testcase name="laws/A.B" time="1.5"/><testcase name="laws/A.C" time="2"/></testsuite>')

    def times(self, *arguments):
        return self.run_here(".ci/times", *arguments)

    def test_the_last_of_each_object_counts_and_the_dearest_comes_first(self):
        ran = self.times("ctest.xml")
        self.assertEqual(ran.returncode, 0)
        shown = [line.split() for line in ran.stdout.splitlines()]
        self.assertEqual([(row[0], row[-1]) for row in shown],
                         [("91.5", "fast/dear"), ("59.0", "fast/cheap"), ("3.5", "test/laws"), ("154.0", "all")])

    def test_a_custom_command_counts_for_the_folder_that_it_writes_to(self):
        self.write("build/fast/times.log", f"-\t{self.top}/build/fast/bin/variants/a.so:g++\t4\t0\n-\t../../bin/variants/b.so:g++\t3\t0\n-\t:cmake\t1\t0\n")
        rows = [line.split() for line in self.times().stdout.splitlines()]
        self.assertEqual([(row[0], row[-1]) for row in rows], [("7.0", "fast/bin/variants"), ("1.0", "fast/others"), ("8.0", "all")])

    def test_what_is_beyond_its_limit_is_named(self):
        self.write("build/other/times.log", "cheap\tc.o\t60\t1\n")
        ran = self.times()
        self.assertEqual(ran.returncode, 1)
        self.assertEqual(ran.stdout.splitlines()[-1], "other/cheap: 61 s, its limit is 60 (.ci/limits.tsv)")

    def test_a_slower_machine_has_wider_limits(self):
        names = [f"other{k}" for k in range(8)]
        self.write(".ci/limits.tsv", "default\t60\nfast/dear\t100\n" + "".join(f"fast/{name}\t90\n" for name in names))
        self.write("build/fast/times.log", "dear\ta.o\t190\t0\n" + "".join(f"{name}\ta.o\t60\t0\n" for name in names))
        self.assertEqual(self.times().returncode, 0)
        self.write("build/fast/times.log", "dear\ta.o\t210\t0\n" + "".join(f"{name}\ta.o\t60\t0\n" for name in names))
        self.assertEqual(self.times().stdout.splitlines()[-1], "fast/dear: 210 s, its limit is 200 (.ci/limits.tsv)")

    def test_an_update_leaves_room(self):
        self.assertEqual(self.times("--update").returncode, 0)
        rows = (self.top / ".ci/limits.tsv").read_text().splitlines()[1:]
        self.assertEqual(rows, ["default\t60", "fast/cheap\t180", "fast/dear\t280"])

    def test_what_cannot_be_read_is_two(self):
        self.assertEqual(self.times("none.xml").returncode, 2)
        self.write("build/fast/times.log", "dear a.o\n")
        self.assertEqual(self.times().returncode, 2)

    def test_a_launched_command_keeps_its_words_its_output_and_its_code(self):
        ran = self.run_here(".ci/timed", "log", "target", "a.o", "sh", "-c", 'echo "$1"; echo wrong >&2; exit 3', "sh", "two  words")
        self.assertEqual((ran.returncode, ran.stdout, ran.stderr), (3, "two  words\n", "wrong\n"))
        self.assertRegex((self.top / "log").read_text(), r"^target\ta\.o:sh\t[0-9.]+\t[0-9.]+\n$")


class Prose(InAFolder):
    """A sentence of 35 words is as long as one may be; the words are "w"."""

    def setUp(self):
        super().setUp()
        self.copy("prose")
        self.run_here("git", "init", "--quiet")

    def prose(self, *arguments):
        ran = self.run_here(".ci/prose", *arguments)
        return ran.returncode, ran.stdout.splitlines(), ran.stderr.splitlines()

    def holds(self, text):
        self.write("room/README.md", text)
        self.assertEqual(self.prose("room/README.md"), (0, ["1 pages: short, and of short sentences"], []))

    def breaks(self, text, *places):
        self.write("room/README.md", text)
        code, found, _ = self.prose("room/README.md")
        self.assertEqual((code, [line.split(" words: ")[0] for line in found]), (1, [f"room/README.md:{place}" for place in places]))

    def test_a_sentence_has_so_many_words(self):
        self.holds("w " * 34 + "w.\n")
        self.breaks("w " * 35 + "w.\n", "1: 36")
        self.holds("w " * 34 + "w. " + "w " * 34 + "w? (" + "w " * 34 + "w.)\n")
        self.holds("# " + "w " * 35 + "\n\n" + "w " * 35 + "\n" * 2 + "w " * 35)

    def test_a_finding_names_the_line_where_the_sentence_begins_and_its_first_words(self):
        self.write("room/README.md", "# Title\n\nShort.\nThis one\nis too " + "w " * 40 + "\nlong.\n")
        self.assertEqual(self.prose("room/README.md"), (1, ["room/README.md:4: 45 words: This one is too w w..."], []))

    def test_an_abbreviation_and_an_ellipsis_end_no_sentence(self):
        for word in ("e.g.", "Eqs.", "DIR.."):
            self.breaks(f"{'w ' * 20}{word} {'w ' * 20}\n", "1: 41")

    def test_paragraphs_items_headings_and_cells_stand_by_themselves(self):
        part = "w " * 20
        self.holds(f"# {part}\n{part}\n\n{part}\n- {part}\n- {part}\n  - {part}\n1. {part}\n\n| {part} | {part} |\n|---|---|\n| {part} | {part} |\n")
        self.breaks(f"# {part}{part}\n", "1: 40")
        self.breaks(f"{part}\n{part}\n\n- {part}\n  {part}\n\n| a | {part}{part} |\n", "1: 40", "4: 40", "7: 40")

    def test_code_is_skipped_and_inline_code_a_formula_or_a_link_is_what_is_read(self):
        long = "w " * 40
        self.holds(f"w:\n\n    {long}\n\n    {long}\n\n```\n{long}\n```\n<!-- {long} -->\n\\f[ {long} \\f]\n")
        self.holds(f"`{long}` \\f$ {long} \\f$ [w](one two \"{long}\") @ref place \"w\"" + " w" * 31)
        self.breaks("`w` " * 36, "1: 36")
        self.breaks(f"[{long}](there)", "1: 40")
        self.breaks(f"w:\n\n    {long}\n\n{long}\n", "5: 40")

    def test_what_is_quoted_is_no_prose(self):
        quoted, long = "<!-- quoted: x.txt . -->\n\n    * {}\n\n<!-- end of quotation -->\n", "w " * 40
        self.holds(quoted.format(long))
        self.breaks(quoted.format(long) + f"\n{long}\n", "7: 40")

    def test_the_front_page_and_a_room_page_have_so_many_lines(self):
        self.write("README.md", "\n" * 150)
        self.write("room/README.md", "\n" * 80)
        self.write("room/other.md", "\n" * 500)
        self.assertEqual(self.prose()[0], 0)
        self.write("README.md", "\n" * 151)
        self.write("room/README.md", "\n" * 81)
        self.assertEqual(self.prose()[:2], (1, ["README.md:151: 151 lines: at most 150", "room/README.md:81: 81 lines: at most 80"]))

    def test_notes_may_have_long_sentences_and_no_other_page(self):
        self.write("reports/notes/2026-01-01-why.md", "w " * 40)
        self.assertEqual(self.prose()[0], 0)
        self.write("reports/docs/pages/why.md", "w " * 40)
        self.assertEqual(self.prose()[:2], (1, ["reports/docs/pages/why.md:1: 40 words: w w w w w w..."]))

    def test_what_is_no_page_is_two(self):
        self.assertEqual(self.prose(), (2, [], [".ci/prose: no page: no Markdown page of the repository"]))
        for argument in ("--all", "none.md", ".ci/prose"):
            self.assertEqual(self.prose(argument), (2, [], [f".ci/prose: {argument}: no Markdown page of the repository"]))


class Checkout(InAFolder):
    def build(self, **places):
        for preset, place in places.items():
            self.write(f"build/{preset}/CMakeCache.txt", f"CMAKE_CACHEFILE_DIR:INTERNAL={place}\n")
        self.program("bin/cmake", "echo built")
        return self.run_here("bash", "-c", f"source {SCRIPTS}/setup.sh; plumb_build release", "properties/run")

    def test_what_was_configured_elsewhere_is_to_be_removed(self):
        ran = self.build(release="/old/build/release", fuzz="/old/build/fuzz", lint=self.top / "build/lint")
        self.assertEqual((ran.returncode, ran.stdout), (2, ""))
        self.assertEqual(ran.stderr, "properties/run: build/release was configured in another place, as a checkout copied or moved has it: "
                                     f"remove it (rm -rf {self.top}/build/fuzz {self.top}/build/release) and start again\n")

    def test_what_was_configured_here_is_built(self):
        ran = self.build(release=self.top / "build/release", fuzz="/old/build/fuzz")
        self.assertEqual((ran.returncode, ran.stdout), (0, "built\n"))
        self.assertEqual(self.build().returncode, 0)


class Run(InAFolder):
    """.ci/run with stand-ins for all that it runs."""

    def setUp(self):
        super().setUp()
        self.copy("run")
        self.write(".ci/setup.sh", 'complain() { echo "$*" >&2; }\nplumb_setup() { :; }\nplumb_build() { :; }\nplumb_seeds() { echo seeds; }\n')
        for target in ("contact", "pair", "ellipsoid", "methods", "scalars", "patch", "shapes", "path", "scene", "files", "mesh", "case"):
            self.write(f"fuzz/engine/{target}.options", "max_len = 8\n")
            self.write(f"fuzz/seeds/{target}", "")
            self.program(f"build/fuzz/bin/fuzz-{target}", "echo first; echo last")
            self.program(f"build/release/bin/replay-{target}", "")
        for path in (".ci/lint", ".ci/times", ".ci/workflows", ".ci/prose", ".clusterfuzzlite/configure", "reports/gate", "reports/quote",
                     "build/release/bin/plumb", "bin/clang-format-19"):
            self.program(path, "")
        self.program("properties/run", "echo '100% tests passed'")
        self.run_here("git", "init", "--quiet")

    def test_what_every_test_needs_is_installed(self):
        self.write(".ci/setup.sh", (self.top / ".ci/setup.sh").read_text() + 'plumb_setup() { echo "setup: $*"; }\n')
        suite = (SCRIPTS.parent / "properties/run").read_text()
        asked = " ".join(re.findall(r"^setup: (.*)$", self.run_here(".ci/run").stdout, re.M)).split()
        wanted = {"wasm", *re.search(r"^plumb_setup (.*)$", suite, re.M)[1].split()}
        self.assertEqual(wanted - set(asked), set())

    def test_the_last_line_is_that_of_the_test_runner(self):
        ran = self.run_here(".ci/run")
        self.assertEqual((ran.returncode, ran.stdout.splitlines()[-1]), (0, "100% tests passed"), ran.stdout)

    def test_all_steps_are_run_and_those_that_failed_are_named(self):
        self.program("properties/run", "exit 1")
        self.program("build/fuzz/bin/fuzz-contact", "exit 77")
        self.program("reports/gate", "exit 2")
        ran = self.run_here(".ci/run")
        self.assertEqual(ran.returncode, 1)
        self.assertEqual(sorted(ran.stdout.splitlines()[-3:]),
                         ["failed: fuzz-contact with sanitizers", "failed: properties/run", "failed: reports/gate"])
        self.assertEqual(ran.stdout.count("\n== "), 2 * 25)

    def test_a_step_that_does_not_come_back_has_failed(self):
        self.program("build/fuzz/bin/fuzz-pair", "kill -9 0")
        ran = self.run_here(".ci/run")
        self.assertEqual((ran.returncode, ran.stdout.splitlines()[-1]), (1, "failed: fuzz-pair with sanitizers"), ran.stdout)

    def test_what_a_step_prints_stays_together(self):
        self.program("build/fuzz/bin/fuzz-pair", "echo first; sleep 0.5; echo last")
        ran = self.run_here(".ci/run")
        self.assertEqual(ran.stdout.count("first\nlast\n"), 12)

    def test_nightly_is_everything(self):
        self.program(".ci/lint", 'echo "lint: $* $PLUMB_NIGHTLY"')
        self.assertIn("lint: --all 1\n", self.run_here(".ci/run", "--nightly").stdout)
        self.assertIn("lint:  \n", self.run_here(".ci/run").stdout)
        self.assertEqual(self.run_here(".ci/run", "--daily").returncode, 2)

    def test_an_interrupt_ends_what_runs_beside(self):
        self.program(".ci/lint", "touch begun; sleep 2; touch ended")
        with subprocess.Popen([".ci/run"], cwd=self.top, env=self.environment, stdout=subprocess.DEVNULL) as running:
            while not (self.top / "begun").exists() and running.poll() is None:
                time.sleep(0.05)
            running.send_signal(signal.SIGINT)
            self.assertEqual(running.wait(20), 130)
        time.sleep(2.5)
        self.assertFalse((self.top / "ended").exists())


class FuzzRun(InAFolder):
    """fuzz/run with stand-ins for all that it runs."""

    def setUp(self):
        super().setUp()
        self.write(".ci/setup.sh", 'complain() { echo "$*" >&2; }\nplumb_setup() { :; }\nplumb_build() { :; }\n')
        (self.top / "fuzz").mkdir()
        shutil.copy(SCRIPTS.parent / "fuzz/run", self.top / "fuzz")
        self.write("build/fuzz-run/verdict.txt", "the verdict\n")

    def ran(self, minutes, codes=""):
        """What plumb was asked for, the exit code and the last line. `codes`: cases of sh, by the words of a call."""
        self.program("build/release/bin/plumb", f'sleep 0.02; echo "$*" >>asked; case "$*" in {codes} *) exit 0 ;; esac')
        run = self.run_here("fuzz/run", "--minutes", minutes)
        asked = [line.split() for line in (self.top / "asked").read_text().splitlines()]
        return asked, run.returncode, run.stdout.splitlines()[-1]

    def test_all_parts_are_run_and_the_verdict_comes_last(self):
        asked, code, last = self.ran("2")
        self.assertEqual([words[0] for words in asked], ["fuzz-run", "fuzz-run", "fuzz-run", "report-precision", "report-stability", "report"])
        self.assertEqual((code, last), (0, "the verdict"))

    def test_more_minutes_are_more_of_each(self):
        sizes = []
        for minutes in ("0.2", "1", "5", "60", "300"):
            (self.top / "asked").unlink(missing_ok=True)
            words = self.ran(minutes)[0][2]
            sizes.append(float(words[words.index("--minutes") + 1]))
        self.assertEqual(sizes, sorted(sizes))
        self.assertEqual(len(set(sizes)), 5)

    def test_a_finding_does_not_end_the_run(self):
        asked, code, _ = self.ran("2", "*--fuzzers*) exit 1 ;; report-precision*) exit 2 ;;")
        self.assertEqual((len(asked), code), (6, 1))

    def test_what_was_interrupted_has_a_page(self):
        asked, code, _ = self.ran("2", "*--fuzzers*) exit 130 ;;")
        self.assertEqual(([words[0] for words in asked[3:]], code), (["report"], 130))

    def test_unusable_input_ends_the_run(self):
        asked, code, _ = self.ran("2", "*--fuzzers*) exit 2 ;;")
        self.assertEqual((len(asked), code), (3, 2))


if __name__ == "__main__":
    unittest.main()
