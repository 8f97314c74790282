# %% [markdown]
# # Which normal does a contact get?
#
# The source compares definitions of a contact. Here two equal spheroids of aspect 2, turned at random, are pushed into each other, and each
# method's normal is held against the certified common normal.

# %%
import sys

import matplotlib.pyplot as plt
import numpy as np

import plumb

SHAPE = (1, 1, 2)
RATIOS = 10.0 ** np.arange(-5, -0.5, 0.5)
METHODS = {
    "original_cn": "original equations (converged answers)",
    "geometric_potential": "geometric potential, two deepest points",
    "geometric_potential_midway": "geometric potential, midway",
    "auto": "auto",
}

# %% [markdown]
# ## Pairs
# The batch finds the distance at which each pair has its overlap: it is moved by what is missing, a few times over. The ratio is that
# overlap over the sum of the shortest semi-axes.

# %%
random = np.random.default_rng(7)
turns1, turns2 = random.normal(size=(2, 30, 4))
line = random.normal(size=(30, 3))
line /= np.linalg.norm(line, axis=1, keepdims=True)


def pairs_with(ratio):
    first = plumb.Bodies(SHAPE, (0, 0, 0), turns1)
    distance = np.full(30, 3.0)
    for _ in range(40):
        second = plumb.Bodies(SHAPE, distance[:, None] * line, turns2)
        distance += plumb.solve_batch(first, second, want="overlap").overlap - 2 * ratio
    return [(first[i], second[i]) for i in range(len(first))]


# %% [markdown]
# ## Angles
# One run of `plumb certify` proves the normals of all pairs of a ratio.


# %%
def angle_deg(a, b):
    return np.degrees(np.arctan2(np.linalg.norm(np.cross(a, b)), np.dot(a, b)))


def median_angle(method, pairs, normals):
    contacts = [plumb.solve(body1, body2, method) for body1, body2 in pairs]
    angles = [
        angle_deg(contact.normal, normal)
        for contact, normal in zip(contacts, normals)
        if contact.status == plumb.Status.converged
    ]
    return np.median(angles)


medians = {method: [] for method in METHODS}
for ratio in RATIOS:
    pairs = pairs_with(ratio)
    normals = [np.array(proved.normal, float) for proved in plumb.certify_all(pairs, digits=20)]
    for method, angles in medians.items():
        angles.append(median_angle(method, pairs, normals))

# %% [markdown]
# ## The picture
# The normal through the two deepest points does not tend to the common normal as the overlap vanishes; the one midway does, to first order.

# %%
figure, axes = plt.subplots(figsize=(7, 4.5), layout="constrained")
for method, label in METHODS.items():
    axes.loglog(RATIOS, np.maximum(medians[method], 1e-15), "o-", label=label)
axes.set_xlabel("overlap / (sum of the shortest semi-axes)")
axes.set_ylabel("angle to the certified common normal, median (degrees)")
axes.set_title("30 pairs of equal spheroids, aspect 2")
axes.legend()
figure.savefig(sys.argv[1] if len(sys.argv) > 1 else "misalignment.png", dpi=120)
