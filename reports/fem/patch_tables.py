"""The patch study's lines as text, and what of them is a finding. The limits of the laws stand here alone; CN's in tables.py."""

import tables
from patch_contact import TILT_RATIO
from tables import number, of_any, of_kind, rows

LAWS = {"volume": "volume", "foundation": "foundation", "tilted": f"foundation {TILT_RATIO}"}
SHOWN = {"auto": "CN", **LAWS, "half_space": "half-sp."}
# centre: from the force's line to a law's, radii of the patch; moment: of a force of one size about the common normal's point, relative, where
# the force's own arm is that long. Both are asked of faces; of edges, the common normal's limit.
LIMITS = {"centre": 0.05, "moment": 0.05, "least_arm": 0.1, "cn": tables.LIMITS["cn"]}
# What a setting of the calculation may move the force's centre by, radii of the patch. What is held is no error of it: it is another body.
SETTINGS = 0.02
HELD = 0.05


def is_edge(name):
    return name.startswith("edge")


def is_control(name):
    return name.startswith("control")


def findings(lines):
    """What does not hold, a sentence each."""
    out = [
        f"{line['check']}: {line['value']:.3g} {line['unit']}, above {line['limit']:g}"
        for line in of_kind(lines, "check")
        if not line["value"] <= line["limit"]
    ]
    for line in of_kind(lines, "patch"):
        out += [f"{line['geometry']} at {line['ratio']:g}: {of}" for of in patch_findings(line)]
    out += [f"convergence of {x['geometry']} at {x['ratio']:g}: {x['reason']}" for x in of_kind(lines, "convergence") if "reason" in x]
    return out


def patch_findings(line):
    if "reason" in line:
        return [line["reason"]]
    if is_control(line["geometry"]):
        return []
    return list(edge_findings(line) if is_edge(line["geometry"]) else face_findings(line))


def edge_findings(line):
    limit = next((of["below_deg"] for of in LIMITS["cn"] if line["ratio"] <= of["ratio"]), None)
    if limit is not None and not line["angles_deg"]["auto"] < limit:
        yield f"the force is {line['angles_deg']['auto']:.3g} degrees from the common normal, not below {limit:g}"


def face_findings(line):
    for law, name in LAWS.items():
        off, moment = line["centre_off"][law], line["moment_off"][law]
        if not off <= LIMITS["centre"]:
            yield f"{name}: the force is {off:.3g} radii of the patch from its centre, above {LIMITS['centre']:g}"
        if line["arm"] >= LIMITS["least_arm"] and not moment <= LIMITS["moment"]:
            yield f"{name}: the moment is off by {moment:.3g}, above {LIMITS['moment']:g}"


def text(lines):
    parts = [
        *header(of_kind(lines, "run")[0]),
        *tables.checks(of_kind(lines, "check")),
        *patches(of_kind(lines, "patch")),
        *of_any(tables.variations, of_kind(lines, "convergence")),
        *summary(lines),
    ]
    return "\n".join(parts)


def header(run):
    host = ", ".join(f"{name} {value}" for name, value in run["host"].items() if name != "commit")
    yield f"Where the force between two elastic bodies acts, face on face and edge on face, {run['mode']} mode ({host})"
    yield f"Young's modulus {run['young']:g}, Poisson's ratio {run['poisson']:g}, no friction. Held: {run['held']}."


def patches(lines):
    yield "\ndeg: degrees from the force to a normal. off: from its line to a law's, across it, in radii of the patch. arm: from its line to the"
    yield "common normal's point. mom: of a law's moment about that point, for a force of one size, against the force's own. volume: a pressure"
    yield "that is the same everywhere; foundation: one like the depth, with its tilt_ratio; half-sp.: elastic half-spaces. to half-sp.: how far the"
    yield "force's line is on the way from foundation's, 0, to that of half-spaces, 1"
    head = ["geometry", "ratio", "deg CN", "deg patch", "arm", *(f"off {of}" for of in SHOWN.values())]
    head += [*(f"mom {of}" for of in list(SHOWN.values())[1:]), "to half-sp."]
    yield from rows(head, [_row(x, len(head)) for x in lines])


def _row(line, columns):
    start = [line["geometry"], f"{line['ratio']:g}"]
    if "reason" in line:
        return start + ["-"] * (columns - 2)
    angles = [number(line["angles_deg"][name]) for name in ("auto", "foundation")]
    off = [number(line["centre_off"].get(name), 2) for name in SHOWN]
    moments = [number(line["moment_off"].get(name) if has_arm(line) else None, 2) for name in list(SHOWN)[1:]]
    return [*start, *angles, number(line["arm"], 2), *off, *moments, number(line["towards_half_space"], 2)]


def has_arm(line):
    return line["arm"] >= LIMITS["least_arm"]


def summary(lines):
    whole = [x for x in of_kind(lines, "patch") if "reason" not in x]
    faces = [x for x in whole if not is_edge(x["geometry"]) and not is_control(x["geometry"])]
    yield f"\n{len(whole)} contacts; of {len(faces)} faces, within the limit of centre, and of moment"
    for law, name in SHOWN.items():
        of = [x for x in faces if law in x["centre_off"]]
        counts = [sum(x[f"{what}_off"][law] <= LIMITS[what] for x in of) for what in ("centre", "moment")]
        yield f"  {name:10}  {counts[0]} and {counts[1]} of {len(of)}"
    found = findings(lines)
    yield f"not held: {len(found)}" if found else "all limits held"
    yield from ("  " + one for one in found)
