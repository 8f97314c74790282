"""The unit ball meshed by gmsh, fine where it is told: gmsh sees no body but this one.

It has no superellipsoid, and meshes an ellipsoid of its own only after a boolean operation.
"""

import dataclasses

import numpy as np

from mesh import MeshFailure

ORDER_TYPES = {1: (4, 2), 2: (11, 9)}  # gmsh's numbers of tetrahedra and triangles


@dataclasses.dataclass(frozen=True)
class Sizes:
    """Lengths in the unit ball."""

    centres: np.ndarray  # n x 3, on the sphere
    radius: float  # of the fine part, around each of them
    fine: float
    coarse: float
    growth: float = 0.35  # of an element's size, by distance


def ball_mesh(sizes, order):
    """Nodes, elements (gmsh's order) and triangles (corners) of the unit ball."""
    import gmsh  # here: it takes Ctrl-C's handler away from the process that imports it

    gmsh.initialize(["-nopopup"], readConfigFiles=False)
    try:
        gmsh.option.setNumber("General.Verbosity", 1)
        for name in ("MeshSizeExtendFromBoundary", "MeshSizeFromPoints", "MeshSizeFromCurvature"):
            gmsh.option.setNumber("Mesh." + name, 0)
        gmsh.option.setNumber("General.NumThreads", 1)
        gmsh.option.setNumber("Mesh.Algorithm", 6)
        gmsh.model.occ.addSphere(0, 0, 0, 1)
        centres = [gmsh.model.occ.addPoint(*centre) for centre in sizes.centres]
        gmsh.model.occ.synchronize()
        _set_sizes(gmsh.model.mesh.field, sizes, centres)
        gmsh.model.mesh.generate(3)
        if order == 2:
            gmsh.model.mesh.setOrder(2)
        return _taken(gmsh.model.mesh, order)
    except Exception as error:  # gmsh's Python raises nothing narrower
        raise MeshFailure(f"gmsh: {error}") from None
    finally:
        gmsh.finalize()


def _set_sizes(field, sizes, centres):
    distance = field.add("Distance")
    field.setNumbers(distance, "PointsList", centres)
    size = field.add("Threshold")
    field.setNumber(size, "InField", distance)
    field.setNumber(size, "SizeMin", sizes.fine)
    field.setNumber(size, "SizeMax", sizes.coarse)
    field.setNumber(size, "DistMin", sizes.radius)
    field.setNumber(size, "DistMax", sizes.radius + (sizes.coarse - sizes.fine) / sizes.growth)
    field.setAsBackgroundMesh(size)


def _taken(mesh, order):
    tetrahedron, triangle = ORDER_TYPES[order]
    tags, coordinates, _ = mesh.getNodes()
    per_element, per_face = {1: (4, 3), 2: (10, 6)}[order]
    elements = mesh.getElementsByType(tetrahedron)[1].reshape(-1, per_element)
    triangles = mesh.getElementsByType(triangle)[1].reshape(-1, per_face)
    used = np.unique(elements)  # without the points that only steer
    row = np.full(int(tags.max()) + 1, -1)
    row[used] = np.arange(len(used))
    place = np.empty((int(tags.max()) + 1, 3))
    place[tags] = coordinates.reshape(-1, 3)
    return place[used], row[elements], row[triangles]
