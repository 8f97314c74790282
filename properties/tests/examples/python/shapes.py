"""A rounded brick that lies askew on a pyramid."""

import plumb

pyramid = plumb.ConvexBody(plumb.Polyhedron([(1, 0, 0), (0, 1, 0), (-1, 0, 0), (0, -1, 0), (0, 0, 1)]), (0, 0, 0))
brick = plumb.ConvexBody(plumb.Box((0.5, 0.25, 0.125)), (0, 0, 1.125), (1, 0.125, 0, 0), swept_radius=0.125)

contact = plumb.solve(pyramid, brick)
assert contact.status == plumb.Status.converged
print(f"overlap {contact.overlap:.6f}")
print("normal {:.6f} {:.6f} {:.6f}".format(*contact.normal))
