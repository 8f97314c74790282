"""Pairs that the tests share: a fixed seed, overlaps and gaps of a few per cent."""

import numpy as np

import plumb


def pairs(count, exponents=None, seed=1):
    """Bodies of aspect up to 3 at distances about touching; exponents between the two given, else ellipsoids."""
    random = np.random.default_rng(seed)
    axes = random.uniform(1 / 3, 1, (2, count, 3))
    turns = random.normal(size=(2, count, 4))
    powers = random.uniform(*exponents, (2, count, 2)) if exponents else (np.full((count, 2), 2.0),) * 2
    line = random.normal(size=(count, 3))
    line *= (random.uniform(0.8, 1.7, count) / np.linalg.norm(line, axis=1))[:, None]
    return plumb.Bodies(axes[0], np.zeros((count, 3)), turns[0], powers[0]), plumb.Bodies(axes[1], line, turns[1], powers[1])


def fields(contacts):
    """Those of an answer, by their names."""
    return {name: value for name, value in vars(contacts).items() if value is not None}
