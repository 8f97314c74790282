"""A hundred thousand pairs at once, from numpy arrays and back."""

import numpy as np

import plumb

n = 100_000
random = np.random.default_rng(1)
line = random.normal(size=(n, 3))
line /= np.linalg.norm(line, axis=1, keepdims=True)

# One row a pair; an array of one dimension holds for all of them.
eggs = plumb.Bodies(semi_axes=(1, 1, 2), position=(0, 0, 0), quaternion=random.normal(size=(n, 4)))
others = plumb.Bodies(random.uniform(0.5, 1, (n, 3)), 2 * line, random.normal(size=(n, 4)))

contacts = plumb.solve_batch(eggs, others, want="overlap,normal,charts", threads=2)

touching = contacts.verdict == plumb.Verdict.overlapping
print(f"{touching.sum()} of {n} pairs overlap, by {contacts.overlap[touching].mean():.3f} on average")
force = 1e5 * contacts.overlap[touching, None] * contacts.normal[touching]
print("forces on body 2:", force.shape)

# In a loop of time steps the arrays are used again, and each pair starts where its last solve ended.
others.position[:] *= 0.99
plumb.solve_batch(eggs, others, out=contacts, last=contacts, threads=2)
assert (contacts.status == plumb.Status.converged).all()
assert (contacts.verdict == plumb.Verdict.overlapping).sum() > touching.sum()
