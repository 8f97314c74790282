"""What plumb says of a case: its own commands, asked once for a list of cases."""

import json
import pathlib
import subprocess

TOP = pathlib.Path(__file__).absolute().parents[2]
METHODS = ("auto", "geometric_potential", "geometric_potential_midway", "first_touch", "original_cn")


class CommandFailure(Exception):
    """plumb did not take the cases; its own line."""


def plumb(arguments, text):
    program = TOP / "build/release/bin/plumb"
    try:
        done = subprocess.run([program, *arguments], input=text, capture_output=True, text=True, check=False)
    except OSError as error:
        raise CommandFailure(f"{program}: {error.strerror}; reports/fem/run builds it") from None
    if done.returncode != 0:
        raise CommandFailure(done.stderr.strip() or f"plumb {arguments[0]}: exit {done.returncode}")
    return done.stdout


def lines_of(cases):
    return "".join(json.dumps(case) + "\n" for case in cases)


def placed(cases):
    """The same pairs with positions and quaternions, whatever they were given by: through a dump, a frame a case."""
    pairs = plumb(["import", "-"], plumb(["export", "-"], lines_of(cases)))
    out = [json.loads(line) for line in pairs.splitlines()]
    if len(out) != len(cases):
        raise CommandFailure(f"{len(cases) - len(out)} of {len(cases)} pairs do not overlap")
    return out


def answers(cases):
    """For each case: method -> answer as plumb solve --json has it; converged ones only."""
    for number, case in enumerate(cases):
        case["name"] = str(number)
    text = plumb(
        ["solve", "-", "--method", ",".join(METHODS), "--want", "overlap,normal,points", "--json"], lines_of(cases)
    )
    out = [{} for _ in cases]
    for line in text.splitlines():
        answer = json.loads(line)
        if answer["status"] == "converged":
            out[int(answer["name"])][answer["method"]] = answer
    return out
