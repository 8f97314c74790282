"""plumb: the contact of two ellipsoids or superquadrics, its common normal, and a judge of both.

    >>> contact = plumb.solve(plumb.Body((1, 1, 2), (0, 0, 0)), plumb.Body((1, 1, 1), (1.5, 0, 0)))
    >>> contact.overlap
    0.5

One pair       Body, solve, diagnose, methods
Many pairs     Bodies, solve_batch
Proved         certify, certify_all: bounds that are proved, 50 digits
The harness    campaign, scene, check, replay, shrink: the program `plumb`, in a process of its own

Lengths in one unit of the caller's own, world frame, quaternions (w, x, y, z) that take body axes to the world's. overlap > 0: the
bodies penetrate by that length; < 0: they are -overlap apart. The normal points from body 1 to body 2.
"""

from ._batch import Bodies, Contacts, solve_batch
from ._native import Body, Contact, PoseDerivative, __version__
from ._solve import Diagnosis, Method, diagnose, methods, solve
from ._words import Status, Verdict

__all__ = [
    "Bodies",
    "Body",
    "Contact",
    "Contacts",
    "Diagnosis",
    "Method",
    "PoseDerivative",
    "Status",
    "Verdict",
    "__version__",
    "diagnose",
    "methods",
    "solve",
    "solve_batch",
]
