"""The board: every solver that is built, on the same pairs; reports/board/run sets up what it asks.

Asked are the libraries of build/release/board and build/release/bin/peers, the programs of build/board/npm, and plumb's own methods. The doctor
sees each first; one that cannot be loaded is left out. Every row's answers are drawn from at random and held against second-opinion."""

import argparse
import collections
import glob
import json
import math
import os
import random
import re
import subprocess
import sys
import time

sys.path.insert(0, "properties/second_opinion")
import by_hand  # shares no code with plumb  # noqa: E402

BIN = "build/release/bin"
OWN = "auto,new_cn,corrected_cn,original_cn,geometric_potential,geometric_potential_midway"
LEVELS = ["rounding", "1e-6rad", "0.01deg", "1deg"]
DRAWN = 50  # of the flagged, and of the passed answers of a row
# What is about another pair, or about no answer: one answer does not show it.
UNSEEN = ("asymmetric", "nondeterministic", "nonconverged", "not_finite", "slow", "crash")
SETTINGS = {"mujoco.mjs": ["", " 1e-10 100"]}  # a program's arguments, a row for each: its defaults, then tuned
PROBLEMS = {"geometric_potential": "deepest_points", "geometric_potential_midway": "midway"}


def plumb(*arguments, codes=(0, 1)):
    """What a command prints; its findings (exit 1) are results."""
    done = subprocess.run([f"{BIN}/plumb", *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    if done.returncode not in codes:
        sys.exit(f"board: plumb {' '.join(arguments[:2])}: {done.stderr.strip().splitlines()[-1]}")
    return done.stdout


def found_solvers():
    libraries = sorted(glob.glob("build/release/board/*.so")) + sorted(glob.glob(f"{BIN}/peers/*.so"))
    programs = [p for p in sorted(glob.glob("build/board/npm/*.mjs")) if not p.endswith("plumb_solver.mjs")]
    commands = [f"node {path}{words}" for path in programs for words in SETTINGS.get(os.path.basename(path), [""])]
    return [["--solver", path] for path in libraries] + [["--solver-command", command] for command in commands]


def examined(solvers):
    """By name: what the doctor says, and the option that loads it."""
    out = {}
    for option in solvers:
        done = subprocess.run([f"{BIN}/plumb", "doctor", *option, "--json"], capture_output=True, text=True)
        if done.returncode not in (0, 1):
            print(f"left out: {option[1]}: {done.stderr.strip()}", file=sys.stderr)
            continue
        said = json.loads(done.stdout)
        out[said["solver"]] = {"option": option, "doctor": said}
    return out


def interval(k, n):
    """Clopper and Pearson's, 95 %, by bisection of the binomial tails."""
    def tail(p, least):  # P(at least `least` of n)
        terms = (math.lgamma(n + 1) - math.lgamma(i + 1) - math.lgamma(n - i + 1) + i * math.log(p) + (n - i) * math.log1p(-p)
                 for i in range(least, n + 1))
        return sum(math.exp(t) for t in terms)
    def root(least, target):
        low, high = 1e-12, 1 - 1e-12
        for _ in range(60):
            middle = (low + high) / 2
            low, high = (middle, high) if tail(middle, least) < target else (low, middle)
        return low
    return (root(k, 0.025) if k > 0 else 0.0), (root(k + 1, 0.975) if k < n else 1.0)


def share(k, n):
    if n == 0:
        return "-"
    low, high = interval(k, n)
    return f"{100 * k / n:.4g} [{100 * low:.3g}, {100 * high:.3g}]"


def claim_of(case, answer, abilities):
    """A line for second-opinion: rounding is the accuracy that findings are made at."""
    fields = ["status", "verdict", "overlap", "normal", "points", "contact_point"]
    problem = PROBLEMS.get(answer["method"], abilities.get("problem", "common_normal"))
    return {"bodies": case["bodies"], "answer": {f: answer[f] for f in fields if f in answer}, "problem": problem, "abilities": abilities,
            "finding": answer["finding"]}


def drawn_claims(lines, method, abilities, seed):
    """Flagged and passed answers of the method, as many as there are up to DRAWN of each."""
    flagged, passed = [], []
    for line in lines:
        for answer in line["answers"]:
            if answer["method"] != method or not answer["judged"] or answer["finding"] in UNSEEN:
                continue
            (passed if answer["finding"] == "none" else flagged).append(claim_of(line["case"], answer, abilities))
    draw = random.Random(f"{seed} {method}")
    return [c for claims in (flagged, passed) for c in draw.sample(claims, min(DRAWN, len(claims)))]


def second_opinions(lines, rows, out):
    """How often the independent program says what the judge said: by method, its words counted. A contradiction is printed."""
    contradicted = False
    for method, row in rows.items():
        claims = drawn_claims(lines, method, row["abilities"], 1)
        path = f"{out}/claims.jsonl"
        with open(path, "w") as file:
            file.writelines(json.dumps(claim) + "\n" for claim in claims)
        done = subprocess.run([f"{BIN}/second-opinion", path], capture_output=True, text=True)
        said = [json.loads(line) for line in done.stdout.splitlines()]
        if done.returncode not in (0, 1) or len(said) != len(claims):
            sys.exit(f"board: second-opinion ended with {done.returncode} after {len(said)} of {len(claims)} lines: {done.stderr.strip()}")
        row["second_opinion"] = dict(collections.Counter(s["verdict"] for s in said))
        for claim, opinion in zip(claims, said):
            if opinion["verdict"] == "refuted":
                contradicted = True
                print(f"CONTRADICTED: {method}, {claim['finding']}: {opinion['reason']}\n  {json.dumps(claim)}", file=sys.stderr)
    return contradicted


def is_common_normal(row):
    return row["abilities"]["problem"] == "common_normal"


def excess(bodies, normal, truth):
    """What a wrong normal costs: how much further the bodies must go along it until a plane parts them, over the larger one's size."""
    size = max(max(body["shape"]["superellipsoid"]["semi_axes"]) for body in bodies)
    return (by_hand.o(bodies, normal) - by_hand.o(bodies, truth)) / size


def worst_cases(lines, rows, out):
    """By method: the answer whose normal costs most; its case in a file. A mirror image that is all but as low is far off and costs nothing. Of
    common-normal solvers alone, for another problem has another normal."""
    worst = {}
    for line in lines:
        truth = next(a for a in line["answers"] if a["method"] == "auto")
        if truth["finding"] != "none" or "normal" not in truth:
            continue
        for answer in line["answers"]:
            if answer["finding"] not in ("misaligned", "wrong_branch") or not is_common_normal(rows[answer["method"]]):
                continue
            cost = excess(line["case"]["bodies"], answer["normal"], truth["normal"])
            if cost > worst.get(answer["method"], {}).get("cost", -1):
                worst[answer["method"]] = {"cost": cost, "case": line["case"], "answer": answer, "truth": truth}
    os.makedirs(f"{out}/worst", exist_ok=True)
    for method, found in worst.items():
        rows[method]["worst"] = {"deg": found["answer"].get("angle_error_deg", math.nan), "cost": found["cost"]}
        found["file"] = f"{out}/worst/{re.sub('[^A-Za-z0-9_.+-]', '-', method)}.json"
        case = dict(found["case"], expect={"method": method, "finding": found["answer"]["finding"]})
        with open(found["file"], "w") as file:
            json.dump(case, file)
    return worst


def sentence_of(found, option):
    """What is left of the case when it is made simple; what was found, where the solver does not come back from a simpler one."""
    said = plumb("shrink", found["file"], *option, "--solver-limit", "1", "--json", codes=(0, 1, 2)).splitlines()
    explanation = json.loads(said[0]).get("explanation") if said else None
    return explanation or f"{found['answer']['method']}: {found['answer']['finding']}: {found['answer']['detail']}"


def motions(rows):
    """Motions of corpus/cases/hard/paths without a finding: one call, so that each step's reference is made once."""
    options = [word for row in rows.values() for word in row["option"]]
    said = [plumb("path", "corpus/cases/hard/paths", "--method", OWN, "--json")]
    if options:
        said.append(plumb("path", "corpus/cases/hard/paths", *options, "--solver-limit", "1", "--json"))
    for row in rows.values():
        row["motions"] = {"of": 0, "clean": 0}
    for line in map(json.loads, "".join(said).splitlines()):
        if "steps" in line:
            row = rows[line["method"]]["motions"]
            row["of"] += 1
            row["clean"] += line["findings"] == 0


def hard_set(rows, out, cases):
    """The frozen ladders, by the rule of report-stability: right, lost or wrong."""
    options = [word for row in rows.values() for word in row["option"]]
    path = f"{out}/stability.jsonl"
    plumb("report-stability", "corpus/cases/hard", "--method", "auto,new_cn", *options, "--arithmetic", "double", "--cases", str(cases), "--out", path)
    for line in open(path):
        row = json.loads(line)
        if row["kind"] == "row" and row["method"] in rows:
            total = rows[row["method"]].setdefault("hard", collections.Counter())
            for word in ("cases", "right", "lost", "wrong"):
                total[word] += sum(row[word])


def table(rows, auto_ns):
    out = ["| solver | version | problem | shapes | tolerance | doctor | judged | to rounding, % [95 %] | to 1e-6 rad | to 0.01 deg | to 1 deg "
           "| worst, deg (cost) | frozen hard set right | motions clean | time over auto | second opinion |", "|---" * 16 + "|"]
    for method, row in sorted(rows.items(), key=lambda item: -item[1]["right"]["0.01deg"] / max(1, item[1]["judged"])):
        a, hard, second = row["abilities"], row.get("hard"), row["second_opinion"]
        out.append("| " + " | ".join([
            method.removeprefix("solver:"), a.get("version", "-"), a["problem"], a["shapes"], f"{a['tolerance']:g}", row["doctor"], str(row["judged"]),
            *(share(row["right"][level], row["judged"]) for level in LEVELS),
            f"{row['worst']['deg']:.3g} ({row['worst']['cost']:.2g})" if row["worst"] else "-",
            f"{hard['right']} of {hard['cases']}" if hard else "-", f"{row['motions']['clean']} of {row['motions']['of']}",
            f"{row['ns'] / auto_ns:.3g}", ", ".join(f"{n} {word}" for word, n in sorted(second.items())) or "-"]) + " |")
    return "\n".join(out)


def details(rows, worst):
    out = []
    for method, found in worst.items():
        row = rows[method]
        replay = f"{BIN}/plumb replay {found['file']} " + " ".join(json.dumps(w) if " " in w else w for w in row["option"])
        out += [f"\n### {method.removeprefix('solver:')}\n", row["sentence"] + "\n", f"    {replay}\n", "Without plumb: the pair",
                f"\n    {json.dumps(found['case']['bodies'])}\n", f"Its normal {found['answer']['normal']}, overlap {found['answer'].get('overlap')};"
                f" right: normal {found['truth']['normal']}, overlap {found['truth'].get('overlap')}.",
                "How far the bodies must go along each until a plane parts them (`properties/second_opinion/by_hand.py`):\n",
                *(f"    {found[who]['normal']} {by_hand.o(found['case']['bodies'], found[who]['normal'])!r}" for who in ("answer", "truth"))]
    return "\n".join(out)


def rows_of(summary, solvers):
    rows = {}
    for method, said in summary["methods"].items():
        known = solvers.get(method)
        doctor = known["doctor"] if known else None
        abilities = doctor["abilities"] if doctor else {"problem": PROBLEMS.get(method, "common_normal"), "shapes": "superellipsoids", "tolerance": 0}
        rows[method] = {"option": known["option"] if known else [], "abilities": abilities, "judged": said["judged"], "right": said["right"],
                        "findings": said["findings"], "worst": None,
                        "doctor": "-" if doctor is None else "sane" if doctor["sane"] else doctor["sentence"],
                        "ns": summary["timing"]["ns_per_solve"][method]["p50"]}
    return rows


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("--cases", type=int, default=400, help="pairs of each of the four families")
    arguments.add_argument("--hard", type=int, default=2, help="pairs of each step of the frozen ladders")
    arguments.add_argument("--out", default="build/board")
    args = arguments.parse_args()
    os.makedirs(args.out, exist_ok=True)
    start = time.monotonic()
    solvers = examined(found_solvers())
    options = [word for known in solvers.values() for word in known["option"]]
    print(f"{len(solvers)} solvers beside plumb's own; {time.monotonic() - start:.0f} s", file=sys.stderr)
    campaign, answers = f"{args.out}/campaign", f"{args.out}/answers.jsonl"
    plumb("campaign", "--family", "all", "--cases", str(args.cases), "--seed", "1", "--method", OWN, *options, "--solver-limit", "2",
          "--answers", answers, "--out", campaign, "--force")
    summary, lines = json.load(open(f"{campaign}/summary.json")), [json.loads(line) for line in open(answers)]
    rows = rows_of(summary, solvers)
    print(f"judged; {time.monotonic() - start:.0f} s", file=sys.stderr)
    contradicted = second_opinions(lines, rows, args.out)
    worst = worst_cases(lines, rows, args.out)
    print(f"held against a second opinion; {time.monotonic() - start:.0f} s", file=sys.stderr)
    for method, found in worst.items():
        rows[method]["sentence"] = sentence_of(found, rows[method]["option"] or ["--method", method])
    print(f"made simple; {time.monotonic() - start:.0f} s", file=sys.stderr)
    motions(rows)
    print(f"moved; {time.monotonic() - start:.0f} s", file=sys.stderr)
    hard_set(rows, args.out, args.hard)
    head = (f"# The board\n\n{summary['cases']} pairs of the four families, seed 1, commit {summary['host']['commit']}; right: of the judged, with exact "
            "95 % intervals; findings at rounding. `reports/board/run` makes it again.\n\n" + table(rows, rows["auto"]["ns"]) + "\n")
    for name, text in (("table.md", head), ("board.md", head + details(rows, worst) + "\n")):
        with open(f"{args.out}/{name}", "w") as file:
            file.write(text)
    plumb("report", campaign, *options, "-o", f"{args.out}/page.html")
    with open(f"{args.out}/board.json", "w") as file:
        json.dump({"cases": summary["cases"], "rows": rows}, file, indent=1)
    print(f"{len(rows)} rows: {args.out}/board.md and {args.out}/page.html")
    return 1 if contradicted else 0


if __name__ == "__main__":
    sys.exit(main())
