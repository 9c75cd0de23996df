# SPDX-License-Identifier: BSD-3-Clause
"""What each rank does for TestSeveralRanks. Run by `pvbatch --mpi --sym`: every rank runs all of it.

rank_scenes.py same OUTPUT [SCENE]: lights scenes of which each rank has a part; their values go to OUTPUT.
rank_scenes.py statistics OUTPUT: a table of a map of which each rank has a part.
rank_scenes.py suggestion OUTPUT: the lamp that is suggested for a surface of which each rank has a part.
rank_scenes.py errors OUTPUT: see rank_stops.py.
"""

import json
import sys
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet, vtkPolyData

from vtkIllumination import (vtkIlluminanceSensors, vtkIlluminanceStatistics, vtkIlluminatedAppearance,
                             vtkIlluminationMapSmoothing, vtkSuggestedLamp, vtkSurfaceRefinement)

sys.path[:0] = [str(Path(__file__).resolve().parent)]
from rank_pieces import (RANK, RANKS, ball, fields, illumination_map, lamp, piece, poly_data,  # noqa: E402
                         room, wall)
from rank_stops import errors  # noqa: E402


def lamps():
    shining = wall(np.array([0.4, 0.4, 0.99]), (0.0, 0.2, 0.0), (0.2, 0.0, 0.0), 2)
    exitance = {"Exitance": np.array([1000.0, 0.0, 2000.0, 500.0])}
    return [lamp((0.3, 0.4, 0.8), "First", on_rank=0), lamp((0.7, 0.6, 0.9), "Second", on_rank=1),
            piece(shining, exitance, "scattered")]


ALL = {"RegisterBackSide": True, "LampContributions": True, "GroupMeans": True, "Interreflection": True,
       "AccuracyRegionArray": "Region"}


def photons(threads, how):
    yield illumination_map(piece(*room(), how), lamps(), threads, Method=0, Photons=30000, **ALL)


def continued(threads, how):
    filters = illumination_map(piece(*room(), how), lamps(), threads, Method=0, Photons=8000, **ALL)
    filters.Update()
    filters.SetPhotons(30000)
    yield filters


def relit(threads, how):
    """Lamps are dimmed after tracing, the surface that shines too."""
    own = lamps()
    filters = illumination_map(piece(*room(), how), own, threads, Method=0, Photons=20000, **ALL)
    filters.Update()
    seconds = filters.GetOutputDataObject(0).GetFieldData().GetArray("Seconds").GetTuple1(0)
    for luminaire, factor in zip(own, (0.0, 0.3, 0.5)):
        if luminaire.GetFieldData().GetArray("LuminaireDimming"):
            luminaire.GetFieldData().GetArray("LuminaireDimming").SetTuple1(0, factor)
        elif luminaire.GetCellData().GetArray("Exitance"):
            exitance = vtk_to_numpy(luminaire.GetCellData().GetArray("Exitance"))
            exitance *= factor
        luminaire.Modified()
    filters.Update()
    assert filters.GetOutputDataObject(0).GetFieldData().GetArray("Seconds").GetTuple1(0) == seconds
    yield filters


def target(threads, how):
    yield illumination_map(piece(*room(), how), (), threads, Method=0, Photons=10**7, TargetRelativeError=0.15)


def gathered(threads, how):
    yield illumination_map(piece(*room(), how), lamps(), threads, Method=1, Photons=20000, GatherRays=30, **ALL)


def curved(threads, how):
    model, arrays = room()
    yield illumination_map(piece(model, arrays, how), (), threads, Method=0, Photons=20000, CurvedSurface=True)
    yield illumination_map(piece(model, arrays, how), (), threads, Method=1, Photons=20000, GatherRays=20,
                           CurvedSurface=True)


def adaptive(threads, how):
    yield illumination_map(piece(*room(2), how), (), threads, Method=1, Photons=20000, GatherRays=20,
                           AdaptiveRefinement=True, MaximumCells=3000)


def smoothed(threads, how):
    for properties in ({"Method": 0, "GroupMeans": True}, {"Method": 1, "GatherRays": 20}):
        light = illumination_map(piece(*room(), how), (), threads, Photons=20000, **properties)
        smoothing = vtkIlluminationMapSmoothing()
        smoothing.SetInputConnection(light.GetOutputPort())
        smoothing.SetNumberOfThreads(threads)
        yield smoothing


def blocks(threads, how):
    """Two blocks, of which the ball has no normals."""
    model, arrays = room()
    whole = vtkMultiBlockDataSet()
    walls = sum(len(cell) == 4 for cell in model[2])
    for i, chosen in enumerate((slice(0, walls), slice(walls, None))):
        part = {name: values[chosen] for name, values in arrays.items()}
        whole.SetBlock(i, piece((model[0], model[1], model[2][chosen]), part, how,
                                with_normals=i == 0))
    yield illumination_map(whole, (), threads, Method=0, Photons=20000)


def refined(threads, how):
    del threads
    refinement = vtkSurfaceRefinement()
    refinement.SetInputDataObject(piece(*room(2), how))
    yield refinement


def appearance(threads, how):
    """The exposure is that of the whole."""
    light = illumination_map(piece(*room(), how), (), threads, Photons=20000)
    result = vtkIlluminatedAppearance()
    result.SetInputConnection(light.GetOutputPort())
    yield result


def sensors(threads, how):
    """At points of which each rank has some, the second one none, and on a grid."""
    light = illumination_map(piece(*room(), how), lamps(), threads, Photons=20000)
    points = wall(np.array([0.1, 0.1, 0.7]), (0.8, 0.0, 0.0), (0.0, 0.8, 0.0), 6)[0]
    own = np.arange(len(points)) // 4 * RANKS // (len(points) // 4 + 1)
    own = np.where(own == 1, 0, own)  # those of the first rank come first
    for layout in ("POINTS", "BOX", "POLYGONS"):
        result = vtkIlluminanceSensors()
        result.SetInputConnection(0, light.GetOutputPort())
        for luminaire in lamps():
            result.AddInputDataObject(1, luminaire)
        if layout == "POINTS":
            result.SetInputDataObject(2, poly_data(points[own == RANK], None, [], {}))
        elif layout == "POLYGONS":
            result.SetInputDataObject(2, piece(wall(np.zeros(3), (1.0, 0, 0), (0, 1.0, 0), 4), {}, how))
        result.SetLayout(getattr(result, layout))
        result.SetSpacing(0.3)
        result.SetMargin(0.1)
        result.SetGatherRays(64)
        result.SetPhotons(20000)
        result.SetNumberOfThreads(threads)
        yield result


SAME = (photons, continued, relit, target, gathered, curved, adaptive, smoothed, blocks, refined, appearance, sensors)


def surfaces(data):
    if isinstance(data, vtkPolyData):
        return [data]
    return [data.GetBlock(i) for i in range(data.GetNumberOfBlocks()) if data.GetBlock(i)]


def rows(data):
    """What the points have: for each its place and all values, as bytes."""
    found = []
    for surface in surfaces(data):
        if surface.GetNumberOfPoints() == 0:
            continue
        arrays = surface.GetPointData()
        names = sorted(name for name in (arrays.GetArrayName(i) for i in range(arrays.GetNumberOfArrays()))
                       if name != "OriginalPointIds")
        columns = [vtk_to_numpy(surface.GetPoints().GetData())] + [vtk_to_numpy(arrays.GetArray(n)) for n in names]
        columns = [np.asarray(c, dtype=np.float64).reshape(surface.GetNumberOfPoints(), -1) + 0.0 for c in columns]
        table = np.hstack(columns)
        found += [",".join(names) + ":" + row.tobytes().hex() for row in table]
    return found


def cells(data):
    """The corners of all cells by their places, and the values of cells."""
    found = []
    for surface in surfaces(data):
        arrays = surface.GetCellData()
        names = sorted(name for name in (arrays.GetArrayName(i) for i in range(arrays.GetNumberOfArrays()))
                       if name != "OriginalCellIds")
        for c in range(surface.GetNumberOfCells()):
            ids = surface.GetCell(c).GetPointIds()
            corners = [surface.GetPoint(ids.GetId(i)) for i in range(ids.GetNumberOfIds())]
            found.append(repr((corners, [arrays.GetArray(n).GetTuple(c) for n in names])))
    return found


def same(output, only=""):
    found = {}
    for scene in (scene for scene in SAME if only in ("", scene.__name__)):
        for threads in (1, 2):
            for how in ("ranges", "scattered") if RANKS > 1 else ("ranges",):
                for i, result in enumerate(scene(threads, how)):
                    result.Update()
                    data = result.GetOutputDataObject(0)
                    found[f"{scene.__name__} {i}, {threads} threads, {how}"] = {
                        "points": sorted(set(rows(data))), "cells": sorted(cells(data)), "fields": fields(result)}
    (output / f"same_{RANKS}_{RANK}.json").write_text(json.dumps(found))


def statistics(output):
    """By parts of the room: numbers of the table, which the first rank has."""
    model, arrays = room()
    arrays["Part"] = (model[0][[cell[0] for cell in model[2]], 2] > 0.3).astype(float)
    light = illumination_map(piece(model, arrays, "scattered"), Method=0, Photons=20000, GroupMeans=True)
    result = vtkIlluminanceStatistics()
    result.SetInputConnection(light.GetOutputPort())
    result.SetPartArray("Part")
    result.Update()
    table = result.GetOutput()
    columns = [table.GetColumn(i) for i in range(table.GetNumberOfColumns())]
    found = {column.GetName(): [column.GetValue(row) for row in range(table.GetNumberOfRows())]
             for column in columns}
    (output / f"statistics_{RANKS}_{RANK}.json").write_text(json.dumps(found))


def suggestion(output):
    """The lamp that is suggested for a room of which each rank has a part, or none."""
    suggested = vtkSuggestedLamp()
    suggested.SetInputData(piece(*room(), "last"))
    suggested.Update()
    found = [suggested.GetLampType(), suggested.GetLampSize(), *suggested.GetLampPosition(),
             *suggested.GetLampDirection()]
    (output / f"suggestion_{RANKS}_{RANK}.json").write_text(json.dumps(found))


if __name__ == "__main__":
    {"same": same, "statistics": statistics, "suggestion": suggestion, "errors": errors}[sys.argv[1]](Path(sys.argv[2]), *sys.argv[3:])
