# SPDX-License-Identifier: BSD-3-Clause
"""How far illumination maps are from the truth, their noise taken out."""

from dataclasses import dataclass

import numpy as np
from vtk.util.numpy_support import vtk_to_numpy


@dataclass
class Accuracy:
    """Error of an illumination map against the exact one; all in shares of the brightest point."""

    rms: float  # area-weighted RMS error, without what the noise adds to it
    rms_error: float  # standard error of rms
    largest: float  # largest error at a point, noise included
    noise: float  # area-weighted RMS standard error of the map that was judged


def point_areas(surface):
    """A third of the area of all triangles around each point of a vtkPolyData of triangles."""
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    a, b, c = points[corners].transpose(1, 0, 2)
    area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    return np.bincount(corners.ravel(), np.repeat(area / 3.0, 3), len(points))


def mean_square_bias(maps, exact, weights):
    """Weighted mean square of (mean of the maps - exact), less what their noise contributes."""
    variance = maps.var(axis=0, ddof=1) / len(maps)
    return np.sum(weights * ((maps.mean(axis=0) - exact) ** 2 - variance))


def accuracy(maps, exact, areas):
    """Accuracy of the mean of independent maps (one row each); areas weigh the points."""
    maps, exact = maps / exact.max(), exact / exact.max()
    weights = areas / areas.sum()
    count = len(maps)
    square = mean_square_bias(maps, exact, weights)
    without = [mean_square_bias(np.delete(maps, i, axis=0), exact, weights) for i in range(count)]
    jackknife = np.sqrt((count - 1) / count * np.sum((without - np.mean(without)) ** 2))
    rms = np.sqrt(max(square, 0.0))
    noise = np.sqrt(np.sum(weights * maps.var(axis=0, ddof=1)) / count)
    return Accuracy(
        rms=rms,
        rms_error=jackknife / (2.0 * rms) if square > jackknife else np.sqrt(jackknife),
        largest=np.abs(maps.mean(axis=0) - exact).max(),
        noise=noise,
    )
