"""Each law of scenes against exact results: the table of README.md."""

import argparse
import math
import os
import pathlib
import sys
import time

import adhesion
import bodies
import impacts
import lammps
import resting
import rocking
import table
from case import Case, Set
from scenes import Failed, Runner

ACCURACIES = (1e-2, 1e-3, 1e-4)
MISSING = (
    ("5: oblique, one normal velocity", "data of the paper not at hand"),
    ("6: spinning ball on a plane", "data of the paper not at hand"),
    ("7: two balls, one spins", "data of the paper not at hand"),
    ("8: two unlike balls, one spins", "data of the paper not at hand"),
    ("JKR and DMT of elliptic patches", "JKR has none in closed form; DMT: a test of the force"),
)


def measured(runner, case, accuracies):
    """{quantity: [measured, ..]}; NaN and the reason where a run failed."""
    out, reasons = {quantity: [] for quantity in case.exact}, []
    for accuracy in accuracies:
        try:
            read = case.read(runner.run(case.name, case.scene, accuracy))
        except Failed as failed:
            reasons.append(str(failed))
            read = {}
        for quantity, numbers in out.items():
            numbers.append(float(read.get(quantity, math.nan)))
    return out, reasons


def rows_of_case(runner, case, accuracies):
    numbers, reasons = measured(runner, case, accuracies)
    for quantity, exact in case.exact.items():
        yield table.Row(case.test, case.source, quantity, float(exact), numbers[quantity], float(case.scale.get(quantity, exact)), case.limit,
                        "; ".join(reasons))


def worst(rows):
    """NaN is worse than any number."""
    return max(rows, key=lambda row: math.inf if math.isnan(row.errors[-1]) else row.errors[-1])


def rows_of_set(runner, group, accuracies):
    found = {}
    for case in group.cases:
        for row in rows_of_case(runner, case, accuracies):
            found.setdefault(row.quantity, []).append(row)
    for rows in found.values():
        row = worst(rows)
        row.test = group.test
        yield row


def everything(quick):
    yield from impacts.cases()
    yield from adhesion.cases()
    yield from resting.cases()
    yield from rocking.cases()
    yield from bodies.sets(2 if quick else 20)


def rows(runner, groups, accuracies):
    for group in groups:
        yield from (rows_of_set if isinstance(group, Set) else rows_of_case)(runner, group, accuracies)


def main(arguments=None):
    top = pathlib.Path(__file__).resolve().parents[2]
    parser = argparse.ArgumentParser(prog="reports/verify/run", description=__doc__)
    parser.add_argument("--accuracy", type=float, nargs="+", default=ACCURACIES, help="coarsest first")
    parser.add_argument("--only", default="", help="tests whose names hold this")
    parser.add_argument("--quick", action="store_true", help="two bodies in the place of twenty")
    parser.add_argument("--ranks", type=int, nargs="+", default=(), help="and through LAMMPS on so many processes, at the first accuracy")
    parser.add_argument("--out", type=pathlib.Path, default=top / "build/verify")
    parser.add_argument("--record", action="store_true", help="and reports/results/verify.txt: of all tests")
    asked = parser.parse_args(arguments)
    if asked.record and (asked.only or asked.quick or tuple(asked.accuracy) != ACCURACIES):
        print("--record: takes all tests: leave --only, --quick and --accuracy out", file=sys.stderr)
        return 2
    if min(asked.ranks, default=1) < 1:
        print("--ranks: at least 1", file=sys.stderr)
        return 2
    if asked.ranks and not lammps.Lammps().program.exists():
        print(f"--ranks: {lammps.Lammps().program}: is not built: liblammps-dev or MPI is missing", file=sys.stderr)
        return 2
    begun = time.monotonic()
    done, runner = [], Runner(asked.out / "scenes")
    groups = [group for group in everything(asked.quick) if asked.only in group.test]
    for row in rows(runner, groups, asked.accuracy):
        done.append(row)
        print(table.line(row), flush=True)
    if not done:
        print(f"--only {asked.only}: there is no such test", file=sys.stderr)
        return 2
    through = lammps.rows(runner, groups, asked.accuracy[0], asked.ranks) if asked.ranks else []
    text = table.text(done, MISSING, asked.accuracy, os.environ.get("PLUMB_COMMIT", "unknown"))
    text += lammps.text(through, asked.accuracy[0]) if through else ""
    asked.out.mkdir(parents=True, exist_ok=True)
    (asked.out / "verify.txt").write_text(text)
    if asked.record:
        (top / "reports/results/verify.txt").write_text(text)
    said = [table.summary(done)] + ([lammps.summary(through)] if through else [])
    print(f"\n{'; '.join(said)}; {time.monotonic() - begun:.0f} s; {asked.out / 'verify.txt'}")
    return 0 if all(row.holds for row in [*done, *through]) else 1


if __name__ == "__main__":
    try:
        sys.exit(main())
    except KeyboardInterrupt:
        sys.exit(130)
