"""Meshes of linear or second-order tetrahedra of a body: the unit ball's (ball.py), mapped onto it."""

import dataclasses

import numpy as np

EDGES = np.array([(0, 1), (1, 2), (2, 0), (3, 0), (3, 2), (3, 1)])  # of gmsh's tetrahedron, in its order of the nodes between
FACES = np.array([(0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0)])  # CalculiX's faces S1 to S4 by corners


class MeshFailure(Exception):
    """No mesh, or one with elements that the map has turned inside out."""


@dataclasses.dataclass
class Mesh:
    nodes: np.ndarray  # n x 3, world
    elements: np.ndarray  # m x 4 or m x 10, rows of nodes, CalculiX's order
    faces: np.ndarray  # k x 2: element and face 1 to 4, of the surface


def onto_body(body, nodes, elements, triangles):
    """What ball_mesh gives, onto the body and into the world. MeshFailure where an element is turned inside out."""
    order = 1 if elements.shape[1] == 4 else 2
    surface = np.zeros(len(nodes), bool)
    surface[triangles.reshape(-1)] = True
    nodes[surface] /= np.linalg.norm(nodes[surface], axis=1, keepdims=True)
    local = body.of_sphere(nodes)
    if order == 2:
        _straighten(local, elements, surface)
        elements = elements[:, [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]]
    if volumes(local, elements).min() <= 0:
        raise MeshFailure("the map turns an element inside out")
    return Mesh(body.to_world(local), elements, _faces(elements, triangles))


def _straighten(local, elements, surface):
    """Nodes between corners, inside: half-way. Those of the surface stay on it."""
    between = elements[:, 4:]
    halves = (local[elements[:, EDGES[:, 0]]] + local[elements[:, EDGES[:, 1]]]) / 2
    inside = ~surface[between]
    local[between[inside]] = halves[inside]


def volumes(nodes, elements):
    """Of the tetrahedra of the corners."""
    a, b, c, d = (nodes[elements[:, k]] for k in range(4))
    return np.einsum("ij,ij->i", b - a, np.cross(c - a, d - a)) / 6


def _faces(elements, triangles):
    wanted = {tuple(sorted(corners)) for corners in triangles[:, :3].tolist()}
    out = []
    for face, corners in enumerate(FACES, start=1):
        for element, nodes in enumerate(np.sort(elements[:, corners], axis=1).tolist()):
            if tuple(nodes) in wanted:
                out.append((element, face))
    return np.array(sorted(out))
