# SPDX-License-Identifier: BSD-3-Clause
"""A single-aisle aircraft cabin that is lit by its coves only. Metres; x forward, y right, z up."""

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray

from mesh import merged
from seats import seats
from shell import WINDOW_PITCH, shell

# Diffuse reflectance of every part; the order numbers the cell array "Part".
REFLECTANCE = {
    "Floor": 0.20,
    "Side walls": 0.70,
    "Window niches": 0.70,
    "Window panes": 0.80,
    "Overhead bins": 0.75,
    "Coves": 0.80,
    "Cove lamps": 0.70,
    "Ceiling": 0.85,
    "Bulkheads": 0.60,
    "Seat cushions": 0.40,
    "Seat backs": 0.40,
    "Armrests and frames": 0.30,
}


def _named(array, name):
    array.SetName(name)
    return array


def to_polydata(parts, exitance, reflectance=REFLECTANCE):
    """One vtkPolyData of all parts: part name -> Mesh; exitance of "Cove lamps" in lm/m^2.

    reflectance: of every part by name; its order numbers them.
    """
    names = list(reflectance)
    whole = merged([parts[name] for name in names])
    part = np.repeat(np.arange(len(names)), [len(parts[name].triangles) for name in names])
    data = vtk.vtkPolyData()
    data.SetPoints(vtk.vtkPoints())
    data.GetPoints().SetData(numpy_to_vtk(whole.points.astype(np.float32), deep=1))
    cells = vtk.vtkCellArray()
    offsets = np.arange(0, 3 * len(whole.triangles) + 1, 3)
    cells.SetData(*(numpy_to_vtkIdTypeArray(a, deep=1) for a in (offsets, whole.triangles.ravel())))
    data.SetPolys(cells)
    normals = numpy_to_vtk(whole.normals.astype(np.float32), deep=1)
    data.GetPointData().SetNormals(_named(normals, "Normals"))
    glow = np.where(part == names.index("Cove lamps"), exitance, 0.0)
    columns = {"Reflectance": np.array(list(reflectance.values()))[part], "Exitance": glow}
    for name, values in columns.items():
        data.GetCellData().AddArray(_named(numpy_to_vtk(values, deep=1), name))
    data.GetCellData().AddArray(_named(numpy_to_vtk(part.astype(np.int32), deep=1), "Part"))
    labels = vtk.vtkStringArray()
    for name in names:
        labels.InsertNextValue(name)
    data.GetFieldData().AddArray(_named(labels, "PartNames"))
    return data


def make_cabin(rows=4, windows=9, exitance=25000.0):
    """The cabin: seat rows, windows on either side (they set its length), lamps' exitance (lm/m^2).

    Points have normals into the air. Cell arrays: Reflectance, Exitance (lm/m^2) and Part, which
    the field array PartNames names.
    """
    room = windows * WINDOW_PITCH
    parts = shell(windows)
    parts.update(seats(rows, first_row=room - 0.8 * (rows - 1) - 1.35))
    return to_polydata(parts, exitance)
