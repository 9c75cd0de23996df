# SPDX-License-Identifier: BSD-3-Clause
"""Photons that have hit a surface: registered on its points, and the illuminance by their density
(Jensen, "Realistic Image Synthesis Using Photon Mapping", 2001, chapter 7).
"""

import numpy as np
from scene import array, corners, points

import bodies

AT_ONCE = 64  # points whose nearest photons are looked for together
LARGEST_FACTOR = 16.0  # of a compensated photon: the default of WeightBound


class Hits:
    """Photons on the fronts of a surface whose cells are the first of the scene.

    cells, places (m), flux (lm) and directions of the hits; barycentric: their coordinates in the
    triangles.
    """

    def __init__(self, photons, surface):
        cells = array(photons, "OriginalCellIds")
        on = (cells < surface.GetNumberOfCells()) & (array(photons, "Side") > 0)
        self.cells, self.flux = cells[on], array(photons, "Flux")[on]
        self.places, self.directions = points(photons)[on], array(photons, "Direction")[on]
        self.corners = corners(surface)[self.cells]
        self.point_normals = bodies.points_and_normals(surface)[1]
        self._find_barycentric(points(surface)[self.corners])

    def _find_barycentric(self, triangles):
        """Also the triangles' normals, of any length."""
        a, b, c = triangles.transpose(1, 0, 2)
        self.facet_normals = np.cross(b - a, c - a)
        to = triangles - self.places[:, None]
        opposite = np.cross(np.roll(to, -1, axis=1), np.roll(to, -2, axis=1))
        areas = np.einsum("hcx,hx->hc", opposite, self.facet_normals)
        self.barycentric = areas / areas.sum(axis=1, keepdims=True)

    def compensation(self):
        """The paper's factor m of each hit, formula (2): the cosine between ray and interpolated normal
        over the cosine between ray and facet's normal.
        """

        def cosine(normals):
            return -np.einsum("hx,hx->h", self.directions, normals) / np.linalg.norm(normals, axis=1)

        smooth = np.einsum("hc,hcx->hx", self.barycentric, self.point_normals[self.corners])
        return np.clip(cosine(smooth) / cosine(self.facet_normals), 0.0, LARGEST_FACTOR)

    def registered(self, count, factor):
        """Flux (lm) on each of count points of the surface: formula (1), or (3) with factor m."""
        shares = self.barycentric * (self.flux * factor)[:, None]
        return np.bincount(self.corners.ravel(), shares.ravel(), count)


def density(queries, hits, nearest, within, factors):
    """Illuminance (lx) of points (n, 3) by their nearest photons: one row for each factor.

    The disk that reaches to the last of so many photons divides the flux of all others: where the
    density is even that is right on the mean. within: m, largest radius of a disk. factors: arrays
    of what each photon's flux is multiplied by.
    """
    fluxes = np.array([hits.flux * factor for factor in factors])
    found = []
    for first in range(0, len(queries), AT_ONCE):
        away = queries[first : first + AT_ONCE, None] - hits.places[None]
        square = np.einsum("qhx,qhx->qh", away, away)
        near = np.argpartition(square, nearest - 1, axis=1)[:, :nearest]
        square = np.take_along_axis(square, near, axis=1)
        limit = np.minimum(square[:, -1:], within**2)  # the last of them is the farthest
        found.append((fluxes[:, near] * (square < limit)).sum(axis=2) / (np.pi * limit[:, 0]))
    return np.hstack(found)
