"""The gap between two bodies along a direction, on a grid across it, and the lens in which they overlap."""

import dataclasses

import numpy as np


def basis_of(normal, along=None):
    """Rows t1, t2, normal: right-handed, orthonormal; t1 nearest to `along`, if given."""
    normal = normal / np.linalg.norm(normal)
    other = np.eye(3)[np.argmin(np.abs(normal))]
    t1 = np.cross(other, normal) if along is None else along - along @ normal * normal
    t1 /= np.linalg.norm(t1)
    return np.array([t1, np.cross(normal, t1), normal])


@dataclasses.dataclass
class Gap:
    """On a grid of n x n cells of `step`: values gap < 0 where the bodies overlap, nan where a line misses one of them."""

    frame: np.ndarray  # rows t1, t2, normal
    step: np.ndarray  # 2
    points1: np.ndarray  # n n x 3, body 1's surface, the last along the normal
    points2: np.ndarray  # body 2's, the first
    values: np.ndarray  # n x n


def gap_on(first, second, frame, centre, half, cells):
    """half: half the window along t1 and t2, as lengths."""
    step = 2 * np.asarray(half) / cells
    ticks = (np.arange(cells) + 0.5 - cells / 2)
    x, y = np.meshgrid(ticks * step[0], ticks * step[1], indexing="ij")
    base = centre + x.reshape(-1, 1) * frame[0] + y.reshape(-1, 1) * frame[1]
    up, down = first.heights(base, frame[2], +1), second.heights(base, frame[2], -1)
    return Gap(
        frame,
        step,
        base + up[:, None] * frame[2],
        base + down[:, None] * frame[2],
        (down - up).reshape(cells, cells),
    )


def lens_window(first, second, frame, inside, cells=48, margin=1.15):
    """Centre and half widths of a window that holds where the bodies overlap, seen along frame[2]. `inside`: a point within both."""
    reach = max(first.semi_axes.max(), second.semi_axes.max()) * 2
    centre, half = np.asarray(inside, float), np.array([reach, reach])
    for _ in range(40):
        gap = gap_on(first, second, frame, centre, half, cells)
        is_lens = np.nan_to_num(gap.values, nan=1) < 0
        if not is_lens.any():
            half = half / 2
            continue
        wanted_centre, wanted = _box(is_lens, gap.step, half)
        centre = centre + wanted_centre[0] * frame[0] + wanted_centre[1] * frame[1]
        is_cut = _is_cut(is_lens)  # as where cells too wide for a narrow strip saw a part of it alone
        wanted = wanted * np.where(is_cut, 1.5, margin)
        if np.all((wanted > 0.8 * half) & ~is_cut):
            return centre, wanted
        half = wanted
    raise ValueError("no window was found that holds where the bodies overlap")


def _is_cut(mask):
    """By the window's rim, along either axis."""
    return np.array([mask[[0, -1]].any(), mask[:, [0, -1]].any()])


def _box(mask, step, half):
    """The middle of the cells that are set, from the window's middle, and half of their extent with a cell on either side."""
    middle, extent = np.zeros(2), np.zeros(2)
    for axis in (0, 1):
        set_ = np.flatnonzero(mask.any(axis=1 - axis))
        low, high = set_[0] * step[axis] - half[axis], (set_[-1] + 1) * step[axis] - half[axis]
        middle[axis], extent[axis] = (low + high) / 2, (high - low) / 2 + step[axis]
    return middle, extent
