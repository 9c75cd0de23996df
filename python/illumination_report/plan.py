# SPDX-License-Identifier: BSD-3-Clause
"""The isolux plan: a horizontal level of a lit surface from above, with lines of equal illuminance."""

from dataclasses import dataclass

import numpy as np
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator
from matplotlib.tri import Triangulation

HORIZONTAL = np.cos(np.radians(5.0))  # facets that are steeper are no part of a level
SAME_LEVEL = 1e-4  # of the size of all: levels that differ by less are one
# The axis that points up -> the axes of the plan to the right and upwards, as seen from above.
AXES = {"z": ((0, 1.0), (1, 1.0)), "y": ((0, 1.0), (2, -1.0)), "x": ((1, 1.0), (2, 1.0))}


@dataclass
class Level:
    """Facets of one height that face upwards."""

    height: float  # data's unit
    surfaces: list  # LitTriangles


def _levels(surfaces, up):
    """Heights of triangles that face up (NaN for others) by surface, and how far heights may differ."""
    axis = "xyz".index(up)
    heights = []
    points = np.concatenate([surface.points for surface in surfaces])
    tolerance = SAME_LEVEL * max(np.linalg.norm(np.ptp(points, axis=0)), 1e-300)
    for surface in surfaces:
        vectors = surface.area_vectors()
        normals = surface.normals[surface.corners].sum(axis=1)
        against = np.einsum("ij,ij->i", vectors, normals) < 0.0
        upward = np.where(against, -1.0, 1.0) * vectors[:, axis] / np.linalg.norm(vectors, axis=1)
        z = surface.points[surface.corners][:, :, axis]
        flat = (upward > HORIZONTAL) & (np.ptp(z, axis=1) <= tolerance)
        heights.append(np.where(flat, z.mean(axis=1), np.nan))
    return heights, tolerance


def find_level(surfaces, up="z", height=None):
    """The Level with the largest area, or the one nearest to a height (data's unit); None if no facet
    is horizontal.

    surfaces: LitTriangles. up: "x", "y" or "z".
    """
    if not surfaces:
        return None
    heights, tolerance = _levels(surfaces, up)
    areas = [np.linalg.norm(surface.area_vectors(), axis=1) for surface in surfaces]
    all_heights, all_areas = np.concatenate(heights), np.concatenate(areas)
    flat = np.isfinite(all_heights)
    if not flat.any():
        return None
    order = np.argsort(all_heights[flat])
    z, area = all_heights[flat][order], all_areas[flat][order]
    starts = np.concatenate([[0], np.flatnonzero(np.diff(z) > tolerance) + 1])
    total = np.add.reduceat(area, starts)
    middle = np.add.reduceat(area * z, starts) / total
    chosen = np.argmax(total) if height is None else np.argmin(np.abs(middle - height))
    low = z[starts[chosen]]
    high = z[np.append(starts[1:], len(z))[chosen] - 1]
    parts = []
    for surface, own in zip(surfaces, heights):
        inside = np.isfinite(own) & (own >= low) & (own <= high)
        if inside.any():
            parts.append(surface.only(inside))
    return Level(float(middle[chosen]), parts)


def draw_plan(level, lamps=(), up="z", metres_per_unit=1.0):
    """A figure of a Level with isolux lines. lamps: places (data's unit) that are marked."""
    (right, right_sign), (above, above_sign) = AXES[up]
    figure = Figure(figsize=(8.0, 6.0), dpi=130)
    FigureCanvasAgg(figure)
    axes = figure.add_subplot()
    values = np.concatenate([s.illuminance[np.unique(s.corners)] for s in level.surfaces])
    steps = MaxNLocator(nbins=9, steps=[1, 2, 5, 10]).tick_values(values.min(), values.max())
    for surface in level.surfaces:
        x = right_sign * metres_per_unit * surface.points[:, right]
        y = above_sign * metres_per_unit * surface.points[:, above]
        mesh = Triangulation(x, y, surface.corners)
        filled = axes.tricontourf(mesh, surface.illuminance, steps, cmap="inferno")
        own = surface.illuminance[np.unique(surface.corners)]
        between = steps[(steps > own.min()) & (steps < own.max())]
        if len(between) > 0:
            lines = axes.tricontour(mesh, surface.illuminance, between, colors="white", linewidths=0.8)
            axes.clabel(lines, fmt="%g", fontsize=8)
    for lamp in lamps:
        place = (right_sign * lamp[right], above_sign * lamp[above])
        axes.plot(*(metres_per_unit * p for p in place), "x", color="#00d0ff", markersize=8)
    axes.set_aspect("equal")
    axes.set_xlabel(f"{'' if right_sign > 0 else '−'}{'xyz'[right]}, m")
    axes.set_ylabel(f"{'' if above_sign > 0 else '−'}{'xyz'[above]}, m")
    figure.colorbar(filled, ax=axes, label="Illuminance, lx", shrink=0.85)
    figure.tight_layout()
    return figure
