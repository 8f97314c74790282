"""The study's two pictures: angles against overlap, and one contact cut open with its deformed meshes."""

import pathlib
import tempfile

import matplotlib
import numpy as np

import calculix
import contact

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402 # after the choice of what draws
from matplotlib.collections import PolyCollection  # noqa: E402

from superellipsoid import pair_of  # noqa: E402
from tables import METHODS, of_kind  # noqa: E402

COLOURS = {"auto": "#1b7837", "geometric_potential": "#b2182b", "geometric_potential_midway": "#ef8a62", "first_touch": "#2166ac",
           "original_cn": "#762a83"}  # fmt: skip


def draw_angles(lines, path):
    """A mark for each contact and method, a line through the medians."""
    figure, axes = pyplot.subplots(figsize=(7, 4.6), layout="constrained")
    answers = [line for line in of_kind(lines, "answer") if "reason" not in line]
    ratios = sorted({line["ratio"] for line in answers})
    for place, (method, name) in enumerate(METHODS.items()):
        shift = 1.05 ** (place - 2)  # side by side
        marks = [(x["ratio"] * shift, x["angles_deg"][method]) for x in answers if method in x["angles_deg"]]
        axes.plot(*zip(*marks), ".", color=COLOURS[method], alpha=0.6)
        medians = [np.median([a for r, a in marks if r == ratio * shift]) for ratio in ratios]
        axes.plot(np.array(ratios) * shift, medians, color=COLOURS[method], label=name)
    axes.set(xscale="log", yscale="log", xlabel="overlap ratio", ylabel="degrees from the finite elements' force")
    axes.set_xticks(ratios, [f"{100 * ratio:g} %" for ratio in ratios], minor=False)
    axes.minorticks_off()
    axes.legend(ncols=2)
    axes.grid(alpha=0.3)
    figure.savefig(path, dpi=120)
    pyplot.close(figure)


def slice_of(mesh, moved, at, across):
    """Polygons in which a plane cuts the tetrahedra, each with its element: corners x 3."""
    side = (moved - at) @ across
    for element, corners in enumerate(mesh.elements[:, :4]):
        signs = side[corners]
        if signs.min() >= 0 or signs.max() <= 0:
            continue
        cuts = [
            moved[a] + (moved[b] - moved[a]) * side[a] / (side[a] - side[b])
            for a, b in ((corners[i], corners[j]) for i in range(4) for j in range(i))
            if side[a] * side[b] < 0
        ]
        yield element, np.array(cuts)


def draw_contact(task, path):
    """The bodies cut by the plane of the common normal and GP's through the contact: whole, and where they touch."""
    answers = task.answers
    pair = pair_of(task.case)
    lens = contact.Lens.of(pair, answers["auto"])
    with tempfile.TemporaryDirectory() as folder:
        meshes, deck = contact.meshes_and_deck(pair, answers["auto"], lens, task.mode, task.setting, is_shown=True)
        result = calculix.run(pathlib.Path(folder), deck, meshes, task.setting)
    centre, radius = contact.pressure_centre(result), np.sqrt(result.area / np.pi)
    up = result.forces[1] / np.linalg.norm(result.forces[1])
    across = np.cross(up, answers["geometric_potential"]["normal"])
    across /= np.linalg.norm(across)
    plane = np.array([np.cross(up, across), up])
    figure, views = pyplot.subplots(1, 2, figsize=(10, 4.8), layout="constrained")
    for view in views:
        for mesh, displaced, colour in zip(meshes, result.displacements, ("Blues", "Oranges")):
            _draw_cut(view, mesh, displaced, centre, across, plane, colour)
        view.set_aspect("equal")
        view.axis("off")
        view.autoscale()
    views[0].set_title(f"{task.geometry} at an overlap of {100 * task.ratio:g} %, deformed")
    views[1].set(xlim=(-3 * radius, 3 * radius), ylim=(-3 * radius, 3 * radius), title="where they touch")
    arrows = [(METHODS[method], answers[method]["normal"], COLOURS[method], 1) for method in ("geometric_potential", "auto")]
    for name, direction, colour, sense in [*arrows, ("force", up, "black", -1)]:
        style = {"arrowstyle": "<-" if sense > 0 else "->", "color": colour, "lw": 1.8}
        at = sense * 2.5 * radius * (plane @ np.array(direction))
        views[1].annotate(name, (0, 0), at, arrowprops=style, color=colour, ha="center", va="center", weight="bold")
    figure.savefig(path, dpi=120)
    pyplot.close(figure)


def _draw_cut(view, mesh, displaced, centre, across, plane, colour):
    polygons, shades = [], []
    size = np.linalg.norm(displaced, axis=1)
    for element, cuts in slice_of(mesh, mesh.nodes + displaced, centre, across):
        flat = (cuts - centre) @ plane.T
        around = flat - flat.mean(axis=0)
        polygons.append(flat[np.argsort(np.arctan2(around[:, 1], around[:, 0]))])
        shades.append(size[mesh.elements[element, :4]].mean())
    view.add_collection(PolyCollection(polygons, array=np.sqrt(shades), cmap=colour, edgecolors="#444", linewidths=0.25))
