# SPDX-License-Identifier: BSD-3-Clause
"""Splits a mesh's long edges, so that the rims of spots of light find points. Lengths in metres."""

import numpy as np

from mesh import Mesh


def middles(mesh, edges, curved):
    """Points and normals in the middle of edges (n, 2); curved: on the arc that both normals want."""
    a, b = mesh.points[edges].transpose(1, 0, 2)
    normal_a, normal_b = mesh.normals[edges].transpose(1, 0, 2)
    points = 0.5 * (a + b)
    if curved:  # the middle of an edge of a PN triangle; Vlachos et al., Curved PN Triangles, 2001
        along = b - a
        rise_a = np.einsum("ij,ij->i", along, normal_a)[:, None]
        rise_b = np.einsum("ij,ij->i", along, normal_b)[:, None]
        points -= (rise_a * normal_a - rise_b * normal_b) / 8.0
    normals = normal_a + normal_b
    return points, normals / np.linalg.norm(normals, axis=1, keepdims=True)


def split(triangles, middle):
    """The parts of triangles (n, 3) whose edge i has the point middle[:, i] on it, or -1."""
    has = middle >= 0
    count = has.sum(axis=1)
    # Turned so that the edges with a point come first.
    first = np.where(count == 1, has.argmax(axis=1), np.where(count == 2, has.argmin(axis=1) + 1, 0))
    turn = (first[:, None] + np.arange(3)) % 3
    corners, edges = (np.take_along_axis(x, turn, axis=1) for x in (triangles, middle))
    whole = np.hstack([corners, edges])  # columns: corners 0 1 2, points 3 (0-1), 4 (1-2), 5 (2-0)
    templates = {
        0: [(0, 1, 2)],
        1: [(0, 3, 2), (3, 1, 2)],
        2: [(0, 3, 4), (3, 1, 4), (0, 4, 2)],
        3: [(0, 3, 5), (3, 1, 4), (5, 4, 2), (3, 4, 5)],
    }
    return np.concatenate(
        [whole[count == n][:, corner] for n, parts in templates.items() for corner in parts]
    )


def refined(mesh, longest, curved=False):
    """A Mesh without edges above longest (m), and without gaps where it had none.

    curved rounds it between its points, which opens gaps to neighbours that do not share them.
    """
    while True:
        edges = np.stack([mesh.triangles, np.roll(mesh.triangles, -1, axis=1)], axis=-1)
        edges, where = np.unique(np.sort(edges.reshape(-1, 2), axis=1), axis=0, return_inverse=True)
        length = np.linalg.norm(mesh.points[edges[:, 0]] - mesh.points[edges[:, 1]], axis=1)
        long = length > longest
        if not long.any():
            return mesh
        middle = np.full(len(edges), -1)
        middle[long] = len(mesh.points) + np.arange(np.count_nonzero(long))
        points, normals = middles(mesh, edges[long], curved)
        mesh = Mesh(
            np.vstack([mesh.points, points]),
            np.vstack([mesh.normals, normals]),
            split(mesh.triangles, middle[where.reshape(-1, 3)]),
        )
