"""The plane in which half-spaces settle, from several starts, beside the common normal and the finite elements."""

import numpy as np

import calculix
import half_space
from contact import degrees_between
from superellipsoid import pair_of


def settled(case, answers, fem):
    """A dictionary for each start; `fem`: what contact.judged gave, or a reason why there is nothing to compare with."""
    pair = pair_of(case)
    starts = {name: np.array(answers[name]["normal"]) for name in ("auto", "geometric_potential") if name in answers}
    line = pair[1].position - pair[0].position
    starts["centre_line"] = line / np.linalg.norm(line)
    return [{"start": name} | _settled(pair, normal, answers["auto"], fem) for name, normal in starts.items()]


def _settled(pair, normal, cn, fem):
    try:
        pressed, planes = half_space.settle(*pair, normal, np.array(cn["contact_point"]), calculix.MODULUS)
    except half_space.NotSettled as error:
        return {"reason": str(error)}
    force = float(np.linalg.norm(pressed.force))
    end, radius = pressed.force / force, float(np.sqrt(pressed.area / np.pi))
    cn_normal = np.array(cn["normal"])
    own = {
        "start_deg": degrees_between(normal, end),
        "planes": planes,
        "cn_deg": degrees_between(end, cn_normal),
        "direction": end.tolist(),
        "force": force,
        "patch_radius": radius,
        "curvatures": curvatures(pair, cn_normal, np.array(cn["contact_point"]), pressed.centre, radius),
    }
    return own if "reason" in fem else own | _beside(fem, end, pressed.centre, force, radius)


def curvatures(pair, normal, point, centre, radius):
    """Of the gap along the common normal, where it is a patch's radius away: on the far side, at the point and on the side to which the
    pressure's centre has moved. Alike, and the force is along the common normal."""
    shift = centre - point
    shift -= shift @ normal * normal
    along = shift / np.linalg.norm(shift)
    step = 0.15 * radius

    def gap_at(places):
        base = point + places[:, None] * along
        return pair[1].heights(base, normal, -1) - pair[0].heights(base, normal, +1)

    places = radius * np.array([-1.0, 0.0, 1.0])
    return ((gap_at(places + step) - 2 * gap_at(places) + gap_at(places - step)) / step**2).tolist()


def _beside(fem, end, centre, force, radius):
    off = centre - np.array(fem["centre"])
    return {
        "fem_deg": degrees_between(end, fem["direction"]),
        "fem_force": fem["force"] / force,
        "fem_patch": fem["fem_patch_radius"] / radius,
        "centre_off": float(np.linalg.norm(off - off @ end * end) / fem["patch_radius"]),
    }
