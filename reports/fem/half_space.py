"""Elastic half-spaces pressed together along a given plane: a second reference, of another kind than finite elements.

Each body is taken for a half-space (the deformation of a patch that is small against it), the gap between them is the true one of the two
surfaces along the plane's normal. Normal displacements of a pressure that is constant in each cell by Love's closed form (Johnson, Contact
Mechanics, 3.25), as a discrete convolution by FFT; pressures by conjugate gradients with the pressures at least 0 and the gaps at least 0
(Polonsky & Keer, Wear 231 (1999) 206-219), here with the approach given in the place of the force.
The plane is an input. The force's own direction, the pressure over the surfaces' true normals, is the next plane (settle).
"""

import dataclasses

import numpy as np

from gap import basis_of, gap_on, lens_window


class NotSettled(Exception):
    """Pressures or the plane did not come to rest in the steps given."""


def influence(cells, step, modulus):
    """The transform of the displacement at each offset from a cell under pressure 1; step 2, modulus 1 / sum of (1 - nu^2) / E."""
    offsets = np.concatenate([np.arange(cells), np.arange(-cells, 0)])
    x, y = np.meshgrid(offsets * step[0], offsets * step[1], indexing="ij")

    def corner(a, b):
        """b asinh(a / |b|) + a asinh(b / |a|), each 0 where its factor is."""
        with np.errstate(divide="ignore", invalid="ignore"):
            return np.where(b != 0, b * np.arcsinh(a / np.abs(b)), 0) + np.where(a != 0, a * np.arcsinh(b / np.abs(a)), 0)

    a, b = step / 2
    whole = corner(x + a, y + b) - corner(x - a, y + b) - corner(x + a, y - b) + corner(x - a, y - b)
    return np.fft.rfft2(whole / (np.pi * modulus))


def pressures(gap, step, modulus, limit=2000):
    """Pressures p >= 0 with gap + u(p) >= 0 and 0 where p > 0, n x n. Cells whose gap is nan cannot touch."""
    cells = gap.shape[0]
    transform = influence(cells, step, modulus)
    can_touch = np.isfinite(gap)
    depth = np.where(can_touch, -gap, -1)

    def displaced(p):
        return np.fft.irfft2(np.fft.rfft2(p, s=(2 * cells, 2 * cells)) * transform)[:cells, :cells]

    p = np.where(depth > 0, depth, 0)
    p *= np.sum(p * depth) / np.sum(p * displaced(p))
    along, last, is_fresh = np.zeros_like(p), 1.0, True
    scale = depth.max()
    for _ in range(limit):
        rest = displaced(p) - depth  # the gap that is left
        touching = p > 0
        left = np.where(touching, rest, 0)
        size = np.sum(left * left)
        wrong = np.where(can_touch & ~touching, np.minimum(rest, 0), 0)
        if np.sqrt(size / touching.sum()) < 1e-9 * scale and -wrong.min() < 1e-9 * scale:
            return p
        along = np.where(touching, left + (0 if is_fresh else size / last) * along, 0)
        last = size
        pushed = displaced(along)
        length = np.sum(left * along) / np.sum(along * pushed)
        p = np.maximum(p - length * along, 0)
        added = (p == 0) & (rest < 0) & can_touch
        is_fresh = bool(added.any())
        p[added] -= length * rest[added]
    raise NotSettled(f"pressures: {limit} steps")


@dataclasses.dataclass
class Pressed:
    """What one plane gives."""

    force: np.ndarray  # 3, on body 2: the pressure over the true normals
    centre: np.ndarray  # 3, of the pressure
    area: float  # in contact, seen along the plane's normal


def press(first, second, normal, inside, modulus, cells, along=None):
    """along: an axis of the grid, so that a narrow patch is not across it."""
    frame = basis_of(normal, along)
    centre, half = lens_window(first, second, frame, inside)
    gap = gap_on(first, second, frame, centre, half, cells)
    p = pressures(gap.values, gap.step, modulus).reshape(-1)
    on = p > 0
    one, two = gap.points1[on], gap.points2[on]
    normals = first.normals(one) - second.normals(two)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    cell = gap.step.prod()
    force = (p[on] / (normals @ frame[2])) @ normals * cell
    return Pressed(force, p[on] @ ((one + two) / 2) / p[on].sum(), on.sum() * cell)


def settle(first, second, normal, inside, modulus, cells=96, limit=60, tolerance_deg=1e-5, along=None):
    """Plane by plane until the force is along the plane's normal; the last Pressed and how many planes there were."""
    for planes in range(1, limit + 1):
        pressed = press(first, second, normal, inside, modulus, cells, along)
        turned = pressed.force / np.linalg.norm(pressed.force)
        angle = np.degrees(np.arctan2(np.linalg.norm(np.cross(turned, normal)), turned @ normal))
        normal, inside = turned, pressed.centre
        if angle < tolerance_deg:
            return pressed, planes
    raise NotSettled(f"the plane: {limit} planes, still turning by {angle:.2g} degrees")
