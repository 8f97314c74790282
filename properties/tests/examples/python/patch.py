"""A die on a die, its tilt from next to nothing to minus that: the point of contact jumps, the patch does not."""

import numpy as np

import plumb

die = plumb.Body((1, 1, 1), (0, 0, 0), exponents=(8, 8))
contacts = []
for half_tilt in (-5e-13, 5e-13):
    upper = die.moved(position=(0, 0, 1.99), quaternion=(1, 0, half_tilt, 0))  # about y
    contacts.append(plumb.solve(die, upper, want="points,patch"))
    assert contacts[-1].patch.error < 0.01  # as exact as it is wanted here
point = np.linalg.norm(contacts[1].contact_point - contacts[0].contact_point)
centre = np.linalg.norm(contacts[1].patch.centre - contacts[0].patch.centre)
patch = contacts[1].patch
print(f"the point moves by {point:.3f}, the patch by {centre:.3f}")
print(f"volume {patch.volume:.3f}, area {patch.area:.2f}")
