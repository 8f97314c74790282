"""The contact of two bodies, and the proof of it."""

import plumb

egg = plumb.Body(semi_axes=(1, 1, 1.5), position=(0, 0, 0))
brick = plumb.Body((0.8, 0.6, 0.4), (1.5, 0.3, 0.4), quaternion=(0.9, 0.1, 0.3, 0), exponents=(8, 8))

contact = plumb.solve(egg, brick)
print(contact.status, contact.verdict)
print("overlap", round(contact.overlap, 12), "normal", contact.normal)
print("points", *contact.points)

# The brick moves: the next solve starts where the last one ended.
brick = brick.moved(position=brick.position + [0.001, 0, 0])
contact = plumb.solve(egg, brick, last=contact)
print("overlap", round(contact.overlap, 12), "after", contact.evaluations, "evaluations")

# 20 digits that are proved: the overlap lies between the two.
certificate = plumb.certify(egg, brick, digits=20)
print(certificate.overlap.lower, "to", certificate.overlap.upper)
assert certificate.overlap.lower <= certificate.overlap.upper
assert abs(float(certificate.overlap.lower) - contact.overlap) < 1e-12
