"""Where two bodies overlap along a face or an edge, seen along the common normal: a window along its own axes, and sums of columns.

The sums are the patch's numbers by other means than plumb's: of a thin lens its volume is that of the gap's columns.
"""

import dataclasses

import numpy as np

from gap import Gap, basis_of, gap_on, lens_window


@dataclasses.dataclass(frozen=True)
class FlatLens:
    gap: Gap
    centre: np.ndarray  # 3, of the lens's area
    half: np.ndarray  # half its length and half its width: of the ellipse with its second moments
    reach: float  # from the centre to its furthest cell

    @staticmethod
    def of(pair, normal, inside, cells=96):
        coarse = _seen(pair, basis_of(normal), inside, 48)
        _, axes = _axes(coarse)
        frame = basis_of(normal, along=axes[:, 1] @ coarse.frame[:2])
        gap = _seen(pair, frame, _middles(coarse).mean(axis=0), cells)
        variances, _ = _axes(gap)
        centre = _middles(gap).mean(axis=0)
        flat = (_middles(gap) - centre) @ frame[:2].T
        return FlatLens(gap, centre, 2 * np.sqrt(variances[::-1]), np.linalg.norm(flat, axis=1).max())

    @property
    def normal(self):
        return self.gap.frame[2]

    @property
    def depth(self):
        """Of the cells in which the bodies overlap."""
        return -self.gap.values.reshape(-1)[_is_lens(self.gap)]

    @property
    def area(self):
        return len(self.depth) * self.gap.step.prod()

    @property
    def volume(self):
        return self.depth.sum() * self.gap.step.prod()

    @property
    def centre_of_depth(self):
        """Where a pressure like the depth acts; `centre` is where one acts that is the same everywhere."""
        return self.depth @ _middles(self.gap) / self.depth.sum()

    def patch_radius(self):
        """As contact.Lens has it: of a circle of half the area."""
        return float(np.sqrt(self.area / 2 / np.pi))

    def surface_points(self, body, spacing):
        """Of body 0 or 1, about so far apart."""
        points = (self.gap.points1, self.gap.points2)[body]
        every = np.maximum(1, (spacing / self.gap.step).astype(int))
        is_asked = np.zeros(self.gap.values.shape, bool)
        is_asked[every[0] // 2 :: every[0], every[1] // 2 :: every[1]] = True
        return points[is_asked.reshape(-1) & _is_lens(self.gap)]


def _seen(pair, frame, inside, cells):
    return gap_on(*pair, frame, *lens_window(*pair, frame, inside), cells)


def _is_lens(gap):
    return np.nan_to_num(gap.values.reshape(-1), nan=1) < 0


def _middles(gap):
    """Of the columns, n x 3."""
    return ((gap.points1 + gap.points2) / 2)[_is_lens(gap)]


def _axes(gap):
    """Variances of the lens's area, ascending, and their axes as columns, in frame[0] and frame[1]."""
    middles = _middles(gap)
    return np.linalg.eigh(np.cov((middles - middles.mean(axis=0)) @ gap.frame[:2].T, rowvar=False))
