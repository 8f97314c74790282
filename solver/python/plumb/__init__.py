"""plumb: the contact of two ellipsoids, superquadrics or other convex shapes, its common normal, and a judge of both.

    >>> contact = plumb.solve(plumb.Body((1, 1, 2), (0, 0, 0)), plumb.Body((1, 1, 1), (1.5, 0, 0)))
    >>> contact.overlap
    0.5

One pair       Body, solve, diagnose, methods
Other shapes   ConvexBody, {shapes}
Many pairs     Bodies, solve_batch
Proved         certify, certify_all: rigorous bounds, 50 digits
The harness    campaign, check, shrink, replay, scene, scene_plan, named_scene, case, bodies_of

Lengths in one unit of the caller's own, world frame, quaternions (w, x, y, z) that take body axes to the world's. overlap > 0: the
bodies penetrate by that length; < 0: they are -overlap apart. The normal points from body 1 to body 2.
"""

import importlib.util as _util
import sys as _sys

if _util.find_spec("numpy") is None:
    _told = f"{_sys.executable} has no numpy: pip install numpy, or install python3-numpy and call Debian's own /usr/bin/python3"
    if _sys.argv[0] == "-m":  # python3 -m plumb: one line, as any program's
        print(_told, file=_sys.stderr)
        _sys.exit(2)
    raise ImportError(_told)

from . import _shapes
from ._batch import Bodies, Contacts, solve_batch
from ._case import bodies_of, case
from ._certify import Bounds, Certificate, certify, certify_all
from ._harness import Campaign, Replay, campaign, check, named_scene, replay, scene, scene_plan, shrink
from ._native import Body, Contact, ConvexBody, Patch, PoseDerivative, __version__
from ._program import find_program
from ._shapes import *
from ._solve import Diagnosis, Method, diagnose, methods, solve
from ._words import Status, Verdict

__all__ = [
    "Bodies",
    "Body",
    "Bounds",
    "Campaign",
    "Certificate",
    "Contact",
    "Contacts",
    "ConvexBody",
    "Diagnosis",
    "Method",
    "Patch",
    "PoseDerivative",
    "Replay",
    "Status",
    "Verdict",
    "__version__",
    "bodies_of",
    "campaign",
    "case",
    "certify",
    "certify_all",
    "check",
    "diagnose",
    "find_program",
    "methods",
    "named_scene",
    "replay",
    "scene",
    "scene_plan",
    "shrink",
    "solve",
    "solve_batch",
]
__all__ += _shapes.__all__
__doc__ = (__doc__ or "").replace("{shapes}", ", ".join(_shapes.__all__))
