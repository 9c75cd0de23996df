# SPDX-License-Identifier: BSD-3-Clause
"""A room with a table, lit on as many ranks as it is started with.

    mpiexec -n 3 pvbatch --mpi light.py

The model is read on one rank, as most of ParaView's readers do, and Redistribute Data Set divides it
between the ranks. It prints a line with what the map is.
"""

import json
import sys
from pathlib import Path

from paraview import servermanager, simple

sys.path[:0] = [str(Path(__file__).resolve().parents[1] / "common")]
from illumination import load_plugin  # noqa: E402

# Rectangles by their corner and two edges, m; the front is where first x second looks.
ROOM = [((0, 0, 0), (4, 0, 0), (0, 3, 0)), ((0, 0, 2.5), (0, 3, 0), (4, 0, 0)), ((0, 0, 0), (0, 3, 0), (0, 0, 2.5)),
        ((4, 0, 0), (0, 0, 2.5), (0, 3, 0)), ((0, 0, 0), (0, 0, 2.5), (4, 0, 0)), ((0, 3, 0), (4, 0, 0), (0, 0, 2.5))]
TABLE = [((1.2, 1, 0.75), (1.6, 0, 0), (0, 0.9, 0)), ((1.2, 1, 0.73), (0, 0.9, 0), (1.6, 0, 0))]
EDGE = 0.17  # m, of a cell, about

# Makes the model on the one rank that reads a file. It has no normals: Redistribute Data Set makes one point of those
# in one place, whatever their normals, and Illumination Map computes normals that fit.
MODEL = """
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkCleanPolyData
from vtkmodules.vtkParallelCore import vtkMultiProcessController
model = vtkAppendPolyData()
for origin, point1, point2, cells in %r:
    rectangle = vtkPlaneSource()
    rectangle.SetOrigin(origin)
    rectangle.SetPoint1(point1)
    rectangle.SetPoint2(point2)
    rectangle.SetResolution(*cells)
    model.AddInputConnection(rectangle.GetOutputPort())
controller = vtkMultiProcessController.GetGlobalController()
if not controller or controller.GetLocalProcessId() == 0:
    merged = vtkCleanPolyData()
    merged.SetInputConnection(model.GetOutputPort())
    merged.Update()
    self.GetOutput().CopyStructure(merged.GetOutput())
"""


def model():
    """Corners of all rectangles, and their numbers of cells."""
    return [(corner, *(tuple(c + e for c, e in zip(corner, edge)) for edge in edges),
             tuple(round(max(map(abs, edge)) / EDGE) for edge in edges)) for corner, *edges in ROOM + TABLE]


def ranks():
    """On which this script's server runs."""
    return servermanager.vtkProcessModule.GetProcessModule().GetNumberOfLocalPartitions()


def lit(photons, divided):
    """The room with its map; `divided` is whether Redistribute Data Set comes before."""
    surface = simple.ProgrammableSource(OutputDataSetType="vtkPolyData", Script=MODEL % (model(),))
    if divided:
        # Assigns each cell to one rank. Split cells would make another surface of it.
        surface = simple.RedistributeDataSet(Input=surface, BoundaryMode="Assign to one region")
        surface = simple.ExtractSurface(Input=surface)
    material = simple.SurfaceMaterial(Input=surface, DiffuseReflectance=[0.6, 0.6, 0.6])
    lamp = simple.Luminaire(Type="Point", Position=[2.0, 1.5, 2.3], LuminousFlux=3000)
    return simple.IlluminationMap(Input=material, Luminaires=[lamp], Photons=photons, Method="Final Gathering",
                                  NumberOfThreads=1)


def facts(result):
    """The map in numbers that do not depend on which rank has what."""
    result.UpdatePipeline()
    least, most = result.PointData["Illuminance"].GetRange()
    total = servermanager.Fetch(simple.IntegrateVariables(Input=result))
    errors = servermanager.Fetch(result, idx=1).GetColumnByName("RelativeError")
    return {"Ranks": ranks(),
            "Cells": int(result.GetDataInformation().GetNumberOfCells()),
            "Least, lx": least, "Most, lx": most,
            "Flux, lm": total.GetPointData().GetArray("Illuminance").GetValue(0),
            "Error, %": 100.0 * errors.GetValue(errors.GetNumberOfTuples() - 1)}


if __name__ == "__main__":
    load_plugin()
    count = int(sys.argv[1]) if len(sys.argv) > 1 else 100000
    print("MAP " + json.dumps(facts(lit(count, divided=ranks() > 1))), flush=True)
