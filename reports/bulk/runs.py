"""What studies of many bodies share: runs that are kept, a line of several seeds with its interval, and the options."""

import argparse
import concurrent.futures
import json
import math
import os
import pathlib
import shutil
import subprocess
import sys

from scenes import Failed

TOP = pathlib.Path(__file__).resolve().parents[2]
STUDENT = {2: 12.706, 3: 4.303, 4: 3.182, 5: 2.776, 6: 2.571, 7: 2.447, 8: 2.365, 9: 2.306, 10: 2.262}  # 95 %, both sides


def kept(folder, tree):
    """The folder, in which that scene has been run to its end."""
    file, text = folder.with_name(folder.name + ".json"), json.dumps(tree)
    if not (file.exists() and file.read_text() == text and is_complete(folder)):
        shutil.rmtree(folder, ignore_errors=True)
        file.write_text(text)
        done = subprocess.run([os.environ["PLUMB_SCENE"], file, "--out", folder, "--threads", "1"], capture_output=True, text=True, check=False)
        if done.returncode != 0:
            raise Failed(f"{file.name}: {done.stderr.strip()}")
    return folder


def is_complete(folder):
    run = folder / "run.json"
    return run.exists() and json.loads(run.read_text())["complete"]


def interval(numbers):
    """Mean, and half of the 95 % interval of it; none of one number."""
    mean = sum(numbers) / len(numbers)
    if len(numbers) < 2:
        return mean, None
    spread = math.sqrt(sum((x - mean) ** 2 for x in numbers) / (len(numbers) - 1))
    return mean, STUDENT.get(len(numbers), 1.96) * spread / math.sqrt(len(numbers))


def text_of(numbers, digits):
    mean, half = interval(numbers)
    return f"{mean:.{digits}f}" + ("" if half is None else f" +- {half:.{digits}f}")


def options(name, about, bodies, seeds):
    parser = argparse.ArgumentParser(prog=f"reports/bulk/run {name}", description=about)
    parser.add_argument("--bodies", type=int, default=bodies)
    parser.add_argument("--seeds", type=int, default=seeds)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    parser.add_argument("--out", type=pathlib.Path, default=TOP / "build" / name)
    parser.add_argument("--record", nargs="?", const=name, metavar="NAME", help=f"and reports/results/NAME.txt ({name})")
    return parser


def study(asked, head, kinds, run, row):
    """The table, a line for each kind: `row(kind, [run(kind, seed) of each seed])`. The exit code."""
    if asked.bodies < 30 or asked.seeds < 1 or asked.jobs < 1:
        print("--bodies: at least 30; --seeds and --jobs: at least 1", file=sys.stderr)
        return 2
    asked.out.mkdir(parents=True, exist_ok=True)
    lines = [head]
    try:
        with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
            ends = {kind: [pool.submit(run, kind, seed) for seed in range(1, asked.seeds + 1)] for kind in kinds}
            try:
                for kind in kinds:
                    lines.append(row(kind, [end.result() for end in ends[kind]]).rstrip())
                    print(lines[-1], file=sys.stderr, flush=True)
            except BaseException:
                pool.shutdown(wait=False, cancel_futures=True)  # what has not begun does not
                raise
    except Failed as failed:
        print(failed, file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        return 130
    text = f"commit {os.environ.get('PLUMB_COMMIT', 'unknown')}\ncommand {asked.command}\n" + "\n".join(lines) + "\n"
    if asked.record:
        (TOP / "reports/results" / f"{asked.record}.txt").write_text(text)
    print(text, end="")
    return 0
