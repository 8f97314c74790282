"""The study's lines as text, and what of them is a finding."""

import statistics

METHODS = {
    "auto": "CN",
    "geometric_potential": "GP",
    "geometric_potential_midway": "midway",
    "first_touch": "touch",
    "original_cn": "original",
}
# cn: the force is less than this from the common normal, at that overlap and below. It is so many times further from GP's normal, where the
# two normals are so far apart.
LIMITS = {"cn": [{"ratio": 0.005, "below_deg": 0.2}, {"ratio": 0.02, "below_deg": 1.0}], "times": 5, "apart_deg": 5}
SETTINGS_DEG = 0.2  # the most that a setting of the calculation may turn the force: lesser differences are not told apart


def of_kind(lines, kind):
    return [line for line in lines if line["kind"] == kind]


def findings(lines):
    """What the study does not hold, a sentence each."""
    out = [
        f"{line['check']}: {line['value']:.3g} {line['unit']}, above {line['limit']:g}"
        for line in of_kind(lines, "check")
        if not line["value"] <= line["limit"]
    ]
    for line in of_kind(lines, "answer"):
        where = f"{line['geometry']} at {line['ratio']:g}"
        out += [f"{where}: {of}" for of in answer_findings(line)]
    for kind in ("half_space", "convergence"):
        out += [f"{kind} of {x['geometry']} at {x['ratio']:g}: {x['reason']}" for x in of_kind(lines, kind) if "reason" in x]
    return out


def answer_findings(line):
    if "reason" in line:
        return [line["reason"]]
    angles, out = line["angles_deg"], []
    limit = next((of["below_deg"] for of in LIMITS["cn"] if line["ratio"] <= of["ratio"]), None)
    if limit is not None and not angles["auto"] < limit:
        out.append(f"the force is {angles['auto']:.3g} degrees from the common normal, not below {limit:g}")
    apart = line["cn_to_gp_deg"]
    if apart is None:
        out.append("GP has no answer")
    elif apart > LIMITS["apart_deg"] and not angles["geometric_potential"] > LIMITS["times"] * angles["auto"]:
        out.append(f"the force is {angles['geometric_potential']:.3g} degrees from GP's, {angles['auto']:.3g} from CN's")
    return out


def number(value, digits=3):
    return "-" if value is None else f"{value:.{digits}g}"


def rows(head, table):
    """Columns to their widest; the first two to the left."""
    wide = [max(len(row[k]) for row in [head, *table]) for k in range(len(head))]
    for row in [head, *table]:
        cells = [cell.ljust(wide[k]) if k < 2 else cell.rjust(wide[k]) for k, cell in enumerate(row)]
        yield "  " + "  ".join(cells).rstrip()


def text(lines):
    parts = [
        *header(of_kind(lines, "run")[0]),
        *checks(of_kind(lines, "check")),
        *answers(lines),
        *of_any(half_spaces, of_kind(lines, "half_space")),
        *of_any(variations, of_kind(lines, "convergence")),
        *summary(lines),
    ]
    return "\n".join(parts)


def of_any(table, lines):
    """No table of nothing."""
    return table(lines) if lines else ()


def header(run):
    host = ", ".join(f"{name} {value}" for name, value in run["host"].items() if name != "commit")
    yield f"The force between two elastic bodies and each method's normal, {run['mode']} mode ({host})"
    yield f"Young's modulus {run['young']:g}, Poisson's ratio {run['poisson']:g}, no friction. Held: {run['held']}."


def checks(lines):
    yield "\nChecks"
    yield from rows(
        ["check", "of", "value", "limit"],
        [[x["check"], x["unit"], f"{x['value']:.2e}", f"{x['limit']:g}"] for x in lines],
    )


def answers(lines):
    yield "\nDegrees between the force and each method's normal; off: from the pressure's centre to the contact point, across the force, in"
    yield "radii of the patch; patch: its radius in parts of body 1's largest semi-axis. CN: auto; GP, midway, touch: as certified; original: where"
    yield "original_cn converges; -: no answer"
    head = ["geometry", "ratio", *METHODS.values(), "CN to GP", *(f"off {name}" for name in METHODS.values()), "patch"]
    largest = {g["name"]: max(g["bodies"][0]["semi_axes"]) for g in of_kind(lines, "geometry")}
    table = []
    for x in of_kind(lines, "answer"):
        if "reason" in x:
            table.append([x["geometry"], f"{x['ratio']:g}"] + ["-"] * (len(head) - 2))
            continue
        angles = [number(x["angles_deg"].get(name)) for name in METHODS]
        off = [number(x["centre_off"].get(name), 2) for name in METHODS]
        patch = number(x["patch_radius"] / largest[x["geometry"]])
        table.append([x["geometry"], f"{x['ratio']:g}", *angles, number(x["cn_to_gp_deg"]), *off, patch])
    yield from rows(head, table)


def half_spaces(lines):
    yield "\nHalf-spaces pressed together along a plane, and again along the force that comes out, until the two are one. turned: from the first"
    yield "plane to the last; to CN, to FEM: of the last; FEM's force, patch and centre against the half-spaces' (radii of the patch); bends: by how"
    yield "much the gap's curvature a patch's radius away from the contact point, against the centre's shift, is that on its side. Of FEM's patch"
    yield "the radius is that of the contact elements under pressure"
    head = ["geometry", "start", "ratio", "turned", "planes", "to CN", "to FEM", "force", "patch", "centre", "bends"]
    table = [
        [x["geometry"], x["start"], f"{x['ratio']:g}", number(x.get("start_deg")), str(x.get("planes", "-"))]
        + [number(x.get(name)) for name in ("cn_deg", "fem_deg", "fem_force", "fem_patch")]
        + [number(x.get("centre_off"), 2), number(bends(x))]
        for x in lines
    ]
    yield from rows(head, table)


def bends(line):
    """How many times the gap is as curved on the far side; None where that cannot be said."""
    far, _, near = line.get("curvatures") or (None, None, 0)
    return far / near if near else None


def variations(lines):
    yield "\nWhat the result hangs on: against the study's own setting, degrees that the force turns, its relative change, that of the radius of the"
    yield "contact elements under pressure, and the shift of the pressure's centre in radii of the patch"
    head = ["geometry", "varied", "setting", "turned", "force", "patch", "centre"]
    fields = ("turned_deg", "force_change", "patch_change", "centre_shift")
    yield from rows(
        head, [[x["geometry"], x["varied"], x["setting"], *(number(x.get(name), 2) for name in fields)] for x in lines]
    )


def summary(lines):
    whole = [x for x in of_kind(lines, "answer") if "reason" not in x]
    yield f"\n{len(whole)} contacts of {len(of_kind(lines, 'geometry'))} geometries"
    for ratio in sorted({x["ratio"] for x in whole}):
        here = [x for x in whole if x["ratio"] == ratio]
        yield f"  ratio {ratio:g}: worst {max(x['angles_deg']['auto'] for x in here):.3g} degrees from CN, " + gp_range(here)
    yield from medians(whole)
    found = findings(lines)
    yield f"not held: {len(found)}" if found else "all limits held"
    yield from ("  " + one for one in found)


def medians(lines):
    """Of the degrees from the force and of the distances from the pressure's centre, over the contacts in which a method answers."""
    yield "\nMedians, over the contacts in which the method answers; further, nearer: contacts in which its normal is by more than"
    yield f"{SETTINGS_DEG:g} degrees further from the force than CN's, or nearer: what the settings may turn is not told apart"
    head = ["ratio", "method", "answers", "degrees", "off", "further", "nearer"]
    yield from rows(head, [_median(lines, ratio, name) for ratio in sorted({x["ratio"] for x in lines}) for name in METHODS])


def _median(lines, ratio, method):
    of = [x for x in lines if x["ratio"] == ratio and method in x["angles_deg"]]
    row = [f"{ratio:g}", METHODS[method], str(len(of))]
    if not of:
        return row + ["-"] * 4
    degrees, off = (statistics.median(x[field][method] for x in of) for field in ("angles_deg", "centre_off"))
    beyond = [x["angles_deg"][method] - x["angles_deg"]["auto"] for x in of]
    counts = sum(by > SETTINGS_DEG for by in beyond), sum(by < -SETTINGS_DEG for by in beyond)
    return [*row, number(degrees), number(off, 2), *map(str, counts)]


def gp_range(lines):
    apart = [x for x in lines if (x["cn_to_gp_deg"] or 0) > LIMITS["apart_deg"]]
    if not apart:
        return f"GP nowhere further than {LIMITS['apart_deg']} degrees from CN"
    gp = [x["angles_deg"]["geometric_potential"] for x in apart]
    least = min(x["angles_deg"]["geometric_potential"] / x["angles_deg"]["auto"] for x in apart)
    return f"{min(gp):.3g} to {max(gp):.3g} from GP where that is > {LIMITS['apart_deg']} from CN ({len(gp)}), at least {least:.3g} times as far"
