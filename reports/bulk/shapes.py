"""The shapes that are packed, all of the volume of a ball of diameter 1, and what others found for each."""

import dataclasses
import math

DONEV = "Donev et al. 2004, Science 303, 990"
MAN = "Man et al. 2005, PRL 94, 198001"
DELANEY = "Delaney & Cleary 2010, EPL 89, 34002"


@dataclasses.dataclass(frozen=True)
class Shape:
    name: str
    ratios: tuple            # of the semi-axes
    exponent: float          # both
    published: str = ""      # packing fraction, as the source has it
    source: str = ""
    protocols: tuple = ("damped",)

    def volume(self, a, b, c):
        """Of |x/a|^n + |y/b|^n + |z/c|^n <= 1."""
        n = self.exponent
        return 8 * a * b * c * math.gamma(1 + 1 / n) ** 3 / math.gamma(1 + 3 / n)

    def semi_axes(self):
        scale = (math.pi / 6 / self.volume(*self.ratios)) ** (1 / 3)
        return [scale * r for r in self.ratios]

    def radius(self):
        """Of a ball that holds it."""
        return max(self.semi_axes()) * max(1, 3 ** (1 / 2 - 1 / self.exponent))


SHAPES = (
    Shape("ball", (1, 1, 1), 2, "0.64", DELANEY, ("damped", "cooled")),
    Shape("ellipsoid", (1.25, 1, 0.8), 2, "0.74 +- 0.005 in the core", MAN, ("damped", "cooled")),
    Shape("oblate-0.5", (1, 1, 0.5), 2),
    Shape("oblate-0.75", (1, 1, 0.75), 2),
    Shape("prolate-1.5", (1, 1, 1.5), 2),
    Shape("prolate-2", (1, 1, 2), 2),
    Shape("superball-2.5", (1, 1, 1), 2.5),
    Shape("superball-3", (1, 1, 1), 3),
    Shape("superball-4", (1, 1, 1), 4),
)
