# SPDX-License-Identifier: BSD-3-Clause
"""Writes the examples' cabin for GatheringAccuracy: pvpython cabin_mesh.py FOLDER/cabin.mesh.

The file: numbers of points and triangles (uint64); points and normals (float32, 3 each), corners of
triangles (uint32, 3 each), reflectance and exitance of triangles (float32 each, lm/m²).
"""

import sys
from pathlib import Path

import numpy as np
from vtk.util.numpy_support import vtk_to_numpy

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "examples" / "cabin"))

from cabin_geometry import make_cabin  # noqa: E402


def write_mesh(surface, path):
    """Writes a vtkPolyData of triangles with normals, Reflectance and Exitance."""
    points = vtk_to_numpy(surface.GetPoints().GetData())
    normals = vtk_to_numpy(surface.GetPointData().GetNormals())
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    cells = [vtk_to_numpy(surface.GetCellData().GetArray(name)) for name in ("Reflectance", "Exitance")]
    with open(path, "wb") as file:
        np.array([len(points), len(corners)], dtype=np.uint64).tofile(file)
        for values, kind in ((points, np.float32), (normals, np.float32), (corners, np.uint32)):
            values.astype(kind).tofile(file)
        for values in cells:
            values.astype(np.float32).tofile(file)


if __name__ == "__main__":
    write_mesh(make_cabin(), sys.argv[1])
