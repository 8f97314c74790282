"""Pictures of what plumb says when it is asked: the shrinker's ranges, a row of a campaign's table, and contacts that tilt."""
import json
import math
import subprocess
import tempfile
from pathlib import Path

from svg import BODY1, INK, RIGHT, SOFT, WRONG, Plan

WIDTH = 250  # of a scale, in pixels


def ends_of(number):
    """What is probed of a number: corpus and page `shrinking` say it."""
    if "semi_axes" in number["number"]:
        return number["value"] / 10, number["value"] * 10, True
    if "overlap_ratio" in number["number"]:
        return 1e-3, 0.9, True
    return (0, 180, False) if "euler_zxz_deg[1]" in number["number"] or "line_deg[0]" in number["number"] else (-180, 180, False)


def place(number, value):
    low, high, is_log = ends_of(number)
    share = math.log(value / low) / math.log(high / low) if is_log else (value - low) / (high - low)
    return WIDTH * min(1, max(0, share))


def shrunk(plumb, case):
    """Exit code 1: there is a finding, as there should be."""
    said = subprocess.run([plumb, "shrink", case, "--method", "original_cn", "--json"], capture_output=True, text=True)
    return json.loads(said.stdout)


def what_matters(plumb, case):
    said = shrunk(plumb, case)
    numbers = said["matters"] + said["indifferent"]
    plan = Plan(640, 74 + 34 * len(numbers), "Over which values of each number the finding is there")
    plan.label((16, 28), f"{said['method']}: {said['finding']}", WRONG, 15, "start", "600")
    plan.label((250, 28), "each number changed alone, over all that is probed", SOFT, 13)
    for row, number in enumerate(numbers):
        top, left = 48 + 34 * row, 270
        start, end = place(number, number["low"]), place(number, number["high"])
        plan.label((254, top + 14), number["words"].replace("semi-axes", "axes").replace("semi-axis", "axis"), INK, 13, "end")
        plan.path([(left, top + 10), (left + WIDTH, top + 10)], SOFT, 1.2)
        plan.path([(left + start, top + 10), (left + max(end, start + 2), top + 10)], WRONG, 9)
        plan.dot((left + place(number, number["value"]), top + 10), INK, 4)
        plan.label((left + WIDTH + 14, top + 14), f"{number['low']:g} .. {number['high']:g}", SOFT, 12.5)
    plan.label((270, 66 + 34 * len(numbers)), "red: the finding is there. dot: the value of the case", SOFT, 13)
    return plan


def counted(plumb, cases):
    with tempfile.TemporaryDirectory() as folder:
        arguments = ["campaign", "--family", "spheroid", "--cases", str(cases), "--seed", "1", "--method", "original_cn", "--out", folder]
        subprocess.run([plumb, *arguments], capture_output=True, check=True)
        return json.loads(Path(folder, "summary.json").read_text())["methods"]["original_cn"]


def draw_shares(plan, row):
    plan.label((16, 26), "original_cn", INK, 15, "start", "600")
    plan.label((16, 50), "finding, and share % of the answers judged; the line is the 95 % interval", SOFT, 13)
    shares = sorted(row["x_finding_shares"].items(), key=lambda item: -item[1]["share"])
    for line, (name, share) in enumerate(shares):
        top, scale = 66 + 24 * line, 3.6
        colour = RIGHT if name == "none" else WRONG
        low, high = (100 * end for end in share["interval_95"])
        plan.label((150, top + 12), name, colour, 13, "end")
        plan.path([(160, top + 8), (160 + scale * 100 * share["share"], top + 8)], colour, 10)
        plan.path([(160 + scale * low, top + 8), (160 + scale * high, top + 8)], INK, 2)
        plan.label((176 + scale * high, top + 12), f"{100 * share['share']:.1f} [{low:.1f}, {high:.1f}]", SOFT, 12.5)
    return 66 + 24 * len(shares)


def draw_angles(plan, row, top):
    answers = row["x_statuses"]["converged"]
    off = row["x_converged"]["angle_error_above_0.01_deg"]["share"]
    x = lambda degrees: 40 + 560 * (math.log10(degrees) + 6) / (math.log10(180) + 6)
    plan.label((16, top + 22), f"conv.% {100 * answers / row['x_answers']:.1f}: the angles of these answers, right or wrong, in degrees", SOFT, 13)
    plan.path([(x(0.01), top + 62), (x(180), top + 62)], WRONG, 9)
    plan.path([(x(1e-6), top + 62), (x(180), top + 62)], SOFT, 1.2)
    plan.label(((x(0.01) + x(180)) / 2 - 60, top + 50), f">0.01deg: {100 * off:.1f} %", WRONG, 13, "middle")
    for power in range(-6, 3):
        plan.label((x(10.0**power), top + 84), f"1e{power}", SOFT, 12, "middle")
    for name, shift in (("p50", 0), ("p99", 16)):
        value = row["angle_error_deg"][name]
        plan.dot((x(value), top + 62), INK, 4)
        plan.label((x(value), top + 106), f"{name} {value:.3g}", INK, 13, "middle")


def row_of_the_table(plumb, cases=400):
    row = counted(plumb, cases)
    plan = Plan(640, 190 + 24 * len(row["x_finding_shares"]), f"What a row of a campaign's table says, for {cases} spheroid pairs")
    draw_angles(plan, row, draw_shares(plan, row))
    return plan


def die(exponent, height, tilt):
    turn = [math.cos(tilt / 2), 0, math.sin(tilt / 2), 0]
    return {"shape": {"superellipsoid": {"semi_axes": [1, 1, 1], "exponents": [exponent] * 2}}, "position": [0, 0, height], "orientation": {"quaternion_wxyz": turn}}


def distances(plumb, exponent, decades):
    """Of two dice pressed in by 0.01: how far from the middle the contact's point is, and the centre of the patch."""
    with tempfile.TemporaryDirectory() as folder:
        cases = Path(folder, "tilts.jsonl")
        bodies = [[die(exponent, 0, 0), die(exponent, 1.99, 10.0**decade)] for decade in decades]
        cases.write_text("".join(json.dumps({"format": "plumb/case-1", "name": "tilt", "bodies": pair}) + "\n" for pair in bodies))
        said = subprocess.run([plumb, "solve", cases, "--json", "--want", "overlap,points,patch"], capture_output=True, text=True, check=True)
    answers = [json.loads(line) for line in said.stdout.splitlines()]
    return [abs(answer["contact_point"][0]) for answer in answers], [abs(answer["patch"]["centre"][0]) for answer in answers]


def centre_against_tilt(plumb, least=1e-3):
    """What is below `least` is not drawn: there a machine's own rounding begins."""
    plan = Plan(640, 330, "How far from the middle a tilted die's contact is: the point, and the centre of the patch")
    place = lambda decade, value: (70 + 36 * (decade + 16), 270 - 80 * math.log10(value / least))
    for decade in range(-16, -1, 2):
        plan.path([place(decade, least), place(decade, 1)], SOFT, 0.5)
        plan.label((place(decade, least)[0], 288), f"1e{decade}", SOFT, 12, "middle")
    for power in range(-3, 1):
        plan.path([place(-16, 10.0**power), place(-2, 10.0**power)], SOFT, 0.5)
        plan.label((62, place(-16, 10.0**power)[1] + 4), f"1e{power}" if power else "1", SOFT, 12, "end")
    decades = range(-16, -1)
    for exponent in (4, 8, 20, 50):
        for values, colour in zip(distances(plumb, exponent, decades), (WRONG, RIGHT)):
            seen = [place(decade, value) for decade, value in zip(decades, values) if value >= least]
            plan.path(seen, colour, 2)
            for pixel in seen:
                plan.dot(pixel, colour, 2.4)
            if colour == WRONG:
                plan.label((seen[-1][0] + 8, seen[-1][1] + (-2 if exponent == 50 else 8)), f"{exponent}", colour, 12.5)
    plan.label((70, 18), "distance from the middle of the face; half a die is 1, the overlap is 0.01", SOFT, 13)
    plan.label((80, 240), "red: the point, at exponents 4, 8, 20, 50", WRONG, 13)
    plan.label((80, 260), "green: the centre of the patch", RIGHT, 13)
    plan.label((322, 312), "tilt, rad", SOFT, 13, "middle")
    return plan


def pictures(plumb, case):
    return {"centre-against-tilt.svg": centre_against_tilt(plumb), "what-matters.svg": what_matters(plumb, case), "row-of-the-table.svg": row_of_the_table(plumb)}
