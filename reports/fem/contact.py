"""One contact by finite elements: meshes for where the bodies overlap, the calculation, and what it says beside each method's answer."""

import dataclasses

import numpy as np

import calculix
from ball import Sizes, ball_mesh
from gap import basis_of, gap_on, lens_window
from mesh import MeshFailure, onto_body


@dataclasses.dataclass(frozen=True)
class Mode:
    """Of the meshes. The lens is where the undeformed bodies overlap: half its narrower width is divided
    so often, where it is not much narrower than wide."""

    order: int = 2
    division: float = 2.5
    coarse: float = 0.4  # far away, in parts of the semi-axes


def degrees_between(u, v):
    return float(np.degrees(np.arctan2(np.linalg.norm(np.cross(u, v)), np.dot(u, v))))


@dataclasses.dataclass(frozen=True)
class Lens:
    """Where two bodies overlap, seen along the common normal."""

    frame: np.ndarray
    centre: np.ndarray
    half: np.ndarray  # of the box around it, along frame[0] and frame[1]
    area: float

    @staticmethod
    def of(pair, answer):
        margin = 1.15
        frame = basis_of(np.array(answer["normal"]))
        centre, half = lens_window(*pair, frame, np.array(answer["contact_point"]), margin=margin)
        gap = gap_on(*pair, frame, centre, half, cells=192)
        return Lens(frame, centre, half / margin, np.count_nonzero(gap.values < 0) * gap.step.prod())

    def patch_radius(self):
        """Of the circle that is as large as Hertz's patch, which has half the area of the lens. What "radii of the patch" are."""
        return float(np.sqrt(self.area / 2 / np.pi))

    def rim(self):
        return self.centre + np.array([sign * self.half[k] * self.frame[k] for k in (0, 1) for sign in (-1, 1)])


def sizes_for(body, lens, point, mode):
    """In the unit ball whose image the body is."""
    at = body.to_sphere(body.to_body(np.array([point])))[0]
    at /= np.linalg.norm(at)
    reach = np.linalg.norm(body.to_sphere(body.to_body(lens.rim())) - at, axis=1)
    # A narrow lens is divided less often across: as often as it asks for would be the square of its aspect in elements.
    narrow, wide = reach.min(), reach.max()
    return Sizes(at[None], wide, narrow * (wide / narrow) ** (1 / 3) / mode.division, mode.coarse)


def mesh_of(body, sizes, order):
    """With smaller elements afar, and at last by the contact, where the map onto the body turns large ones inside out."""
    for afar, near in ((1, 1), (0.7, 1), (0.5, 1), (0.5, 0.8), (0.5, 0.6)):
        try:
            smaller = dataclasses.replace(sizes, coarse=afar * sizes.coarse, fine=near * sizes.fine)
            return onto_body(body, *ball_mesh(smaller, order))
        except MeshFailure as error:
            failure = error
    raise failure


def meshes_and_deck(pair, answer, lens, mode, setting, is_shown=False):
    """Of an overlapping pair, CN's answer to it and its lens."""
    meshes = [
        mesh_of(body, sizes_for(body, lens, point, mode), mode.order) for body, point in zip(pair, answer["points"])
    ]
    zone = calculix.Zone(np.array(answer["contact_point"]), lens.half.min() / np.sqrt(2), lens.half.max())
    return meshes, calculix.deck_of(meshes, [body.position for body in pair], zone, setting, is_shown)


def pressure_centre(result):
    """Where the line of action of the force meets the plane across it through the middle of the patch."""
    force, moment = result.forces[1], result.moments[1]
    square = force @ force
    foot = np.cross(force, moment) / square
    return foot + force * ((result.middle - foot) @ force) / square


def judged(result, answers, radius):
    """The fields of an answer line: the force against each method's normal, its line against each method's contact point, in
    parts of the patch's radius."""
    force, centre = result.forces[1], pressure_centre(result)
    size = np.linalg.norm(force)
    direction = force / size

    def off(answer):
        rest = np.array(answer["contact_point"]) - centre
        return float(np.linalg.norm(rest - rest @ direction * direction) / radius)

    return {
        "force": float(size),
        "direction": direction.tolist(),
        "angles_deg": {name: degrees_between(direction, a["normal"]) for name, a in answers.items()},
        "centre": centre.tolist(),
        "centre_off": {name: off(a) for name, a in answers.items()},
        "patch_radius": radius,
        "fem_patch_radius": float(np.sqrt(result.area / np.pi)),
        "balance": float(np.linalg.norm(result.forces.sum(axis=0)) / size),
        "lines_apart": float(np.linalg.norm(np.cross(result.moments.sum(axis=0), direction)) / (size * radius)),
        "elements_agree": float(np.linalg.norm(result.contact_force - force) / size),
        "iterations": result.iterations,
        "nodes": result.nodes,
    }
