# SPDX-License-Identifier: BSD-3-Clause
"""Triangle meshes with analytic normals: grids, rounded boxes, bent copies. Lengths in metres."""

from dataclasses import dataclass

import numpy as np


@dataclass
class Mesh:
    """A smooth piece of surface: every point has one normal, which points into the air."""

    points: np.ndarray  # (n, 3), m
    normals: np.ndarray  # (n, 3), unit vectors
    triangles: np.ndarray  # (m, 3), indices of points, counterclockwise seen from the air


def oriented(points, normals, triangles):
    """A Mesh whose triangles are wound the way the normals of their corners say."""
    corners = points[triangles]
    facing = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    wrong = np.einsum("ij,ij->i", facing, normals[triangles].sum(axis=1)) < 0.0
    triangles = triangles.copy()
    triangles[wrong] = triangles[wrong][:, ::-1]
    return Mesh(points, normals, triangles)


def grid(points, normals, closed=False):
    """A Mesh through the points of an (n, m, 3) grid; closed joins the last column to the first."""
    rows, columns = points.shape[:2]
    index = np.arange(rows * columns).reshape(rows, columns)
    if closed:
        index = np.hstack([index, index[:, :1]])
    a, b, c, d = index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]
    triangles = np.concatenate([np.stack(t, axis=-1).reshape(-1, 3) for t in ((a, b, c), (a, c, d))])
    return oriented(points.reshape(-1, 3), normals.reshape(-1, 3), triangles)


def merged(meshes):
    """One Mesh of many; points are not shared between them."""
    first = np.cumsum([0] + [len(m.points) for m in meshes])
    return Mesh(
        np.concatenate([m.points for m in meshes]),
        np.concatenate([m.normals for m in meshes]),
        np.concatenate([m.triangles + start for m, start in zip(meshes, first)]),
    )


def welded(mesh, tolerance=1e-6):
    """The same Mesh with points that coincide (within tolerance, m) made one."""
    key = np.round(mesh.points / tolerance).astype(np.int64)
    _, kept, where = np.unique(key, axis=0, return_index=True, return_inverse=True)
    return Mesh(mesh.points[kept], mesh.normals[kept], where.reshape(-1)[mesh.triangles])


def moved(mesh, offset):
    """A copy, shifted by offset (m)."""
    return Mesh(mesh.points + np.asarray(offset), mesh.normals, mesh.triangles)


def mirrored(mesh):
    """The mirror image on the other side of the aisle: y becomes -y."""
    flip = np.array([1.0, -1.0, 1.0])
    return Mesh(mesh.points * flip, mesh.normals * flip, mesh.triangles[:, ::-1])


def bent(mesh, bend, step=1e-5):
    """A copy with every point moved to bend(points).

    The normals follow exactly: they turn with the cofactors of the bend's Jacobian, which is taken
    by central differences of step (m). A bend that mirrors turns no surface inside out.
    """
    shifts = step * np.eye(3)
    a, b, c = ((bend(mesh.points + s) - bend(mesh.points - s)) / (2.0 * step) for s in shifts)
    cofactors = np.stack([np.cross(b, c), np.cross(c, a), np.cross(a, b)], axis=1)
    normals = np.einsum("nij,ni->nj", cofactors, mesh.normals)
    mirror = np.sign(np.einsum("ni,ni->n", a, cofactors[:, 0]))[:, None]
    normals *= mirror / np.linalg.norm(normals, axis=1, keepdims=True)
    return oriented(bend(mesh.points), normals, mesh.triangles)


def _edge_samples(half, radius, flat, rounding):
    """Along one axis of a rounded box's face: positions on the inner box and slopes of the normal."""
    inner = half - radius
    slope = np.tan(np.pi / 4.0 * np.linspace(0.0, 1.0, rounding + 1)[1:] ** 1.6)
    position = np.concatenate(
        [np.full(rounding, -inner), np.linspace(-inner, inner, flat + 1), np.full(rounding, inner)]
    )
    return position, np.concatenate([-slope[::-1], np.zeros(flat + 1), slope])


def rounded_box(half, radius, flat, rounding):
    """A closed box with all edges and corners rounded, centred on the origin.

    half: half its extent along x, y, z (m); radius of the rounding (m), below the least of half;
    flat: segments along x, y, z of the flat middle; rounding: segments per eighth of a turn.
    """
    faces = []
    for axis in range(3):
        u, v = (axis + 1) % 3, (axis + 2) % 3
        along_u, slope_u = _edge_samples(half[u], radius, flat[u], rounding)
        along_v, slope_v = _edge_samples(half[v], radius, flat[v], rounding)
        for sign in (-1.0, 1.0):
            inner = np.zeros((len(along_u), len(along_v), 3))
            normals = np.zeros_like(inner)
            inner[..., u], inner[..., v] = np.meshgrid(along_u, along_v, indexing="ij")
            normals[..., u], normals[..., v] = np.meshgrid(slope_u, slope_v, indexing="ij")
            inner[..., axis] = sign * (half[axis] - radius)
            normals[..., axis] = sign
            normals /= np.linalg.norm(normals, axis=-1, keepdims=True)
            faces.append(grid(inner + radius * normals, normals))
    return welded(merged(faces))
