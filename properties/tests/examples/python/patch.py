"""A die on a die, tilted by next to nothing: the point of contact jumps, the patch does not."""

import plumb

die = plumb.Body((1, 1, 1), (0, 0, 0), exponents=(8, 8))
for tilt in (-1e-12, 1e-12):
    upper = die.moved(position=(0, 0, 1.99), quaternion=(1, 0, tilt / 2, 0))  # about y
    contact = plumb.solve(die, upper, want="points,patch")
    patch = contact.patch
    assert patch.error < 0.01  # as exact as it is wanted here
    print(f"point at x = {contact.contact_point[0]:.2g}, patch at x = {patch.centre[0]:.2g}")
    print(f"  volume {patch.volume:.2g}, area {patch.area:.2g}, widths {patch.second_moments**0.5}")
