"""One contact whose patch is flat: by finite elements, by half-spaces, and by the laws that plumb puts on a patch.

Each says a force along a line. Compared are the lines, and their moments about the common normal's point: of forces of one size, for each law has
a stiffness of its own.
"""

import dataclasses

import numpy as np

import calculix
import contact
import half_space
from ball import Sizes
from contact import degrees_between
from flat_lens import FlatLens
from mesh import MeshFailure
from superellipsoid import pair_of
from tasks import Task, calculation

CELLS, FINER = 48, 72  # of the half-spaces' grids, along each of the lens's axes
TOLD_APART = 0.05  # of two lines, radii of the patch
TILT_RATIO = 1.4  # of a foundation: between springs' 1 and 8/3 of a flat round punch on a half-space
SETTLED_DEG = 1e-3  # of their plane: what is asked of directions is 0.2


@dataclasses.dataclass(frozen=True)
class PatchTask(Task):
    grids: tuple = (CELLS,)  # of half-spaces


@dataclasses.dataclass(frozen=True)
class Line:
    """A force of size 1 on body 2: its direction and a point of its line of action."""

    direction: np.ndarray
    point: np.ndarray

    @staticmethod
    def of_wrench(force, moment, about):
        """moment: about the point given."""
        size = np.linalg.norm(force)
        return Line(force / size, about + np.cross(force, moment) / size**2)

    def moment_about(self, point):
        return np.cross(self.point - point, self.direction)

    def off(self, other):
        """From the other's point to this line, across it."""
        away = other.point - self.point
        return np.linalg.norm(away - away @ self.direction * self.direction)


def laws_of(patch):
    """Of plumb's patch. `volume`: a pressure that is the same everywhere; `foundation`: one like the depth; `tilted`: a foundation's, with
    TILT_RATIO as its tilt_ratio."""
    normal, centre, moment = (np.array(patch[name]) for name in ("normal", "centre", "area_moment"))
    return {
        "volume": Line.of_wrench(patch["area"] * normal, moment, centre),
        "foundation": Line(normal, centre),
        "tilted": Line.of_wrench(normal, (1 - TILT_RATIO) / patch["area"] * moment, centre),
    }


def sizes_for(body, lens, which, mode):
    """Fine by the lens, wherever it reaches, and not below it. In the unit ball whose image the body is."""
    wide, narrow = lens.half
    fine = narrow * (wide / narrow) ** (1 / 3) / mode.division  # as contact.sizes_for
    points = body.to_sphere(body.to_body(lens.surface_points(which, fine)))
    scale = np.sqrt(np.prod(np.sort(body.semi_axes)[:2]))
    return Sizes(points / np.linalg.norm(points, axis=1, keepdims=True), 1.5 * fine / scale, fine / scale, mode.coarse)


def meshes_and_deck(pair, lens, mode, setting):
    meshes = [contact.mesh_of(body, sizes_for(body, lens, k, mode), mode.order) for k, body in enumerate(pair)]
    zone = calculix.Zone(lens.centre, lens.half[1] / np.sqrt(2), 1.2 * lens.reach, lens.normal)
    return meshes, calculix.deck_of(meshes, [body.position for body in pair], zone, setting)


def calculated(task, out, engine):
    """In a process of its own, as tasks.calculated."""
    pair, cn = pair_of(task.case), task.answers["auto"]
    lens = FlatLens.of(pair, np.array(cn["normal"]), np.array(cn["contact_point"]))
    try:
        meshes, deck = meshes_and_deck(pair, lens, task.mode, task.setting)
        result = calculation(meshes, deck, task.setting, out, engine)
    except (MeshFailure, calculix.EngineFailure) as error:
        return {"reason": str(error)}
    laws = {"auto": Line(np.array(cn["normal"]), np.array(cn["contact_point"]))} | laws_of(cn["patch"])
    grid = {}
    if task.has_planes:
        halves = half_spaces(pair, lens, task.grids)
        laws |= {"half_space": halves[0]} if halves else {}
        grid = {"grid_shift": float(halves[0].off(halves[-1]) / lens.patch_radius())} if len(halves) > 1 else {}
    return judged(result, cn, lens, laws) | {"columns": columns(lens, cn["patch"])} | grid


def judged(result, cn, lens, laws):
    """The force's line beside each other, in parts of the patch's radius. Of the common normal a force along it, through its point."""
    radius = lens.patch_radius()
    fields = contact.judged(result, {"auto": cn}, radius)
    fem = Line(np.array(fields["direction"]), np.array(fields["centre"]))
    point = np.array(cn["contact_point"])
    moment = fem.moment_about(point)
    return fields | {
        "arm": float(np.linalg.norm(moment) / radius),
        "angles_deg": {name: degrees_between(fem.direction, law.direction) for name, law in laws.items()},
        "centre_off": {name: float(fem.off(law) / radius) for name, law in laws.items()},
        "moment_off": {name: relative(law.moment_about(point), moment) for name, law in laws.items()},
        "towards_half_space": between(fem, laws["foundation"], laws.get("half_space"), radius),
    }


def relative(value, wanted):
    return float(np.linalg.norm(value - wanted) / np.linalg.norm(wanted))


def between(fem, foundation, half_space_line, radius):
    """How far the force has gone from a foundation's centre, 0, to that of half-spaces, 1; None where these are not told apart."""
    if half_space_line is None or foundation.off(half_space_line) < TOLD_APART * radius:
        return None
    way = half_space_line.point - foundation.point
    way -= way @ fem.direction * fem.direction
    return float((fem.point - foundation.point) @ way / (way @ way))


def columns(lens, patch):
    """What plumb says of the patch against sums of the gap's columns."""
    laws = laws_of(patch)
    radius, normal = lens.patch_radius(), lens.normal
    uniform, winkler = Line(normal, lens.centre), Line(normal, lens.centre_of_depth)
    return {
        "area": abs(lens.area / patch["area"] - 1),
        "volume": abs(lens.volume / patch["volume"] - 1),
        "centres": float(max(uniform.off(laws["volume"]), winkler.off(laws["foundation"])) / radius),
    }


def half_spaces(pair, lens, grids):
    """The line in which they settle on each grid; none where they do not."""
    try:
        return [settled(pair, lens, cells) for cells in grids]
    except half_space.NotSettled:
        return []


def settled(pair, lens, cells):
    pressed, _ = half_space.settle(
        *pair, lens.normal, lens.centre, calculix.MODULUS, cells, tolerance_deg=SETTLED_DEG, along=lens.gap.frame[0]
    )
    return Line(pressed.force / np.linalg.norm(pressed.force), pressed.centre)
