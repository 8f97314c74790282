"""Meshes of linear or second-order tetrahedra of a body: the unit ball's (ball.py), mapped onto it."""

import dataclasses

import numpy as np

EDGES = np.array([(0, 1), (1, 2), (2, 0), (3, 0), (3, 2), (3, 1)])  # of gmsh's tetrahedron, in its order of the nodes between
FACES = np.array([(0, 1, 2), (0, 3, 1), (1, 3, 2), (2, 3, 0)])  # CalculiX's faces S1 to S4 by corners
# Weights of the corners at a second-order tetrahedron's points of integration.
INTEGRATION = np.full((4, 4), (5 - np.sqrt(5)) / 20) + np.eye(4) / np.sqrt(5)


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
    if least_volumes(local, elements).min() <= 0:
        raise MeshFailure("the map turns an element inside out")
    if order == 2:
        elements = elements[:, [0, 1, 2, 3, 4, 5, 6, 7, 9, 8]]
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


def least_volumes(nodes, elements):
    """By an element's map at the least of its four points of integration, where the engine asks; gmsh's order."""
    if elements.shape[1] == 4:
        return volumes(nodes, elements)
    places = nodes[elements]
    return np.min([_mapped(places, weights) for weights in INTEGRATION], axis=0) / 6


def _mapped(places, weights):
    """The determinant of each second-order tetrahedron's map where the corners weigh so much; places m x 10 x 3."""
    slope = np.zeros((10, 4))  # of the shape functions, by the weights
    slope[range(4), range(4)] = 4 * weights - 1
    for node, (a, b) in enumerate(EDGES, start=4):
        slope[node, a], slope[node, b] = 4 * weights[b], 4 * weights[a]
    return np.linalg.det(np.einsum("mni,nk->mik", places, slope[:, 1:] - slope[:, :1]))


def _faces(elements, triangles):
    wanted = {tuple(sorted(corners)) for corners in triangles[:, :3].tolist()}
    out = []
    for face, corners in enumerate(FACES, start=1):
        for element, nodes in enumerate(np.sort(elements[:, corners], axis=1).tolist()):
            if tuple(nodes) in wanted:
                out.append((element, face))
    return np.array(sorted(out))
