# SPDX-License-Identifier: BSD-3-Clause
"""How fast Surface Refinement comes near the exact surface."""

import numpy as np

import bodies
from scene import SHAPES, refined, small_triangles

CHART = "Mean distance of the triangles from the exact surface, in % of the radius"
TURNS = tuple(24.0 / 2**i for i in range(6))  # degrees: MaximumTurn
RADII = {"Cylinder": "radius", "Sphere": "radius", "Torus": "tube"}  # of the bodies, by attribute
PLACES = 200_000  # of samples in a mesh, but 4 to 256 in each triangle


def samples(surface):
    """Places in all triangles of a vtkPolyData (m, k, 3), and the triangles' areas (m,)."""
    points, _ = bodies.points_and_normals(surface)
    corners = points[bodies.vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)]
    a, b, c = corners.transpose(1, 0, 2)
    side = int(np.clip(np.sqrt(PLACES / len(corners)), 2, 16))
    area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    return np.einsum("kc,mcx->mkx", small_triangles(side), corners), area


def distances(surface, shape):
    """Mean and largest distance of a surface's triangles from the exact one (m)."""
    places, area = samples(surface)
    off = np.abs(shape.distance(places.reshape(-1, 3))).reshape(places.shape[:2])
    return float(np.average(off.mean(axis=1), weights=area)), float(off.max())


def input_mesh(shape, times):
    """A body's coarse mesh with so many times the facets along every edge."""
    return shape.mesh(*(times * count for count in shape.coarse))


def turns_rows(turns=TURNS, times=1):
    """A row for each turn: mean distance in % of the radius, and triangles, of every body.

    times: so many times the facets of the coarse bodies along every edge.
    """
    rows = []
    for turn in turns:
        row = {"MaximumTurn, degrees": turn}
        for name, shape in SHAPES.items():
            surface = refined(input_mesh(shape, times), MaximumTurn=turn)
            mean, _ = distances(surface, shape)
            row[f"{name}, %"] = 100.0 * mean / getattr(shape, RADII[name])
            row[f"{name}, triangles"] = surface.GetNumberOfCells()
        rows.append(row)
    return rows
