# SPDX-License-Identifier: BSD-3-Clause
"""What each rank does for TestSeveralRanks. Run by `pvbatch --mpi --sym`: every rank runs all of it.

rank_scenes.py same OUTPUT [SCENE]: lights scenes of which each rank has a part; their values go to OUTPUT.
rank_scenes.py statistics OUTPUT: a table of a map of which each rank has a part.
rank_scenes.py errors OUTPUT: bad input and stops of all kinds, some on one rank only.
"""

import json
import sys
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkParallelCore import vtkMultiProcessController

from vtkIllumination import (vtkIlluminanceSensors, vtkIlluminanceStatistics, vtkIlluminatedAppearance,
                             vtkIlluminationMap, vtkIlluminationMapSmoothing, vtkLuminaireSource,
                             vtkSurfaceRefinement)

CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK = CONTROLLER.GetLocalProcessId() if CONTROLLER else 0
RANKS = CONTROLLER.GetNumberOfProcesses() if CONTROLLER else 1

# ---- models: points, normals, cells (corners), arrays by name


def wall(origin, first, second, cells):
    """A grid of squares; its front is where first x second looks."""
    steps = np.linspace(0.0, 1.0, cells + 1)
    u, v = np.meshgrid(steps, steps, indexing="ij")
    points = origin + u.reshape(-1, 1) * np.array(first) + v.reshape(-1, 1) * np.array(second)
    normal = np.cross(first, second)
    normals = np.tile(normal / np.linalg.norm(normal), (len(points), 1))
    at = lambda i, j: i * (cells + 1) + j  # noqa: E731
    corners = [(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)) for i in range(cells) for j in range(cells)]
    return points, normals, corners


def ball(centre, radius, rows):
    """A sphere of triangles with exact normals."""
    around = 2 * rows
    normals = [(0.0, 0.0, 1.0)]
    for i in range(1, rows):
        for j in range(around):
            polar, azimuth = np.pi * i / rows, 2 * np.pi * j / around
            normals.append((np.sin(polar) * np.cos(azimuth), np.sin(polar) * np.sin(azimuth), np.cos(polar)))
    normals.append((0.0, 0.0, -1.0))
    at = lambda i, j: 1 + (i - 1) * around + j % around  # noqa: E731
    corners = []
    for j in range(around):
        corners.append((0, at(1, j), at(1, j + 1)))
        corners.append((len(normals) - 1, at(rows - 1, j + 1), at(rows - 1, j)))
        for i in range(1, rows - 1):
            corners += [(at(i, j), at(i + 1, j), at(i + 1, j + 1)), (at(i, j), at(i + 1, j + 1), at(i, j + 1))]
    return np.array(centre) + radius * np.array(normals), np.array(normals), corners


def together(parts):
    points, normals, corners = [], [], []
    for p, n, c in parts:
        first = sum(len(q) for q in points)
        corners += [tuple(first + i for i in cell) for cell in c]
        points.append(p)
        normals.append(n)
    return np.concatenate(points), np.concatenate(normals), corners


def room(cells=4):
    """A closed room with a ball, in colours; some of it shines like a mirror."""
    x, y, z = np.eye(3)
    model = together([wall(0 * x, x, y, cells), wall(z, y, x, cells), wall(0 * x, y, z, cells), wall(x, z, y, cells),
                      wall(0 * x, z, x, cells), wall(y, x, z, cells), ball((0.6, 0.5, 0.3), 0.2, 6)])
    middles = np.array([model[0][list(cell)].mean(axis=0) for cell in model[2]])
    mirror = np.where(middles[:, 0] > 0.9, 0.3, 0.0)
    arrays = {"DiffuseReflectance": 0.2 + 0.4 * middles, "SpecularReflectance": mirror,
              "Region": (middles[:, 2] < 0.5).astype(float)}
    return model, arrays


# ---- pieces


def owners(cells, how):
    """[cell] The rank that has it."""
    numbers = np.arange(cells)
    if how == "scattered":
        return numbers * 2654435761 % 2**32 // 7 % RANKS
    if how == "hole":  # the middle rank has nothing
        return np.where(numbers % 2, 0, RANKS - 1)
    if how == "last":
        return np.full(cells, RANKS - 1)
    return numbers * RANKS // cells


def poly_data(points, normals, corners, arrays):
    data = vtkPolyData()
    vtk_points = vtkPoints()
    vtk_points.SetData(numpy_to_vtk(np.ascontiguousarray(points), deep=True))
    data.SetPoints(vtk_points)
    cells = vtkCellArray()
    flat = np.array([i for cell in corners for i in (len(cell), *cell)], dtype=np.int64)
    cells.ImportLegacyFormat(numpy_to_vtkIdTypeArray(flat, deep=True))
    data.SetPolys(cells)
    if normals is not None:
        array = numpy_to_vtk(np.ascontiguousarray(normals), deep=True)
        array.SetName("Normals")
        data.GetPointData().SetNormals(array)
    for name, values in arrays.items():
        array = numpy_to_vtk(np.ascontiguousarray(values), deep=True)
        array.SetName(name)
        data.GetCellData().AddArray(array)
    return data


def piece(model, arrays, how="ranges", rank=None, with_normals=True):
    """This rank's cells and their points, which have another order on each rank."""
    rank = RANK if rank is None else rank
    points, normals, corners = model
    own = np.flatnonzero(owners(len(corners), how) == rank)
    used = np.unique([i for cell in own for i in corners[cell]]).astype(int)
    if rank % 2:
        used = used[::-1]
    number = {point: i for i, point in enumerate(used)}
    return poly_data(points[used], normals[used] if with_normals else None,
                     [tuple(number[i] for i in corners[cell]) for cell in own],
                     {name: values[own] for name, values in arrays.items()})


def lamp(position, name, kind="POINT", on_rank=0):
    """A luminaire, as a source is: on one rank only."""
    if RANK != on_rank % RANKS:
        return vtkPolyData()
    source = vtkLuminaireSource()
    source.SetType(getattr(source, kind))
    source.SetPosition(position)
    source.SetLuminaireName(name)
    source.Update()
    return source.GetOutput()


def set_all(result, properties):
    for name, value in properties.items():
        getattr(result, "Set" + name)(value)


def illumination_map(surface, luminaires=(), threads=1, **properties):
    result = vtkIlluminationMap()
    result.SetInputDataObject(surface)
    for luminaire in luminaires:
        result.AddInputDataObject(1, luminaire)
    result.SetNumberOfThreads(threads)
    result.SetLampType(result.POINT)
    result.SetLampPosition(0.3, 0.4, 0.9)
    set_all(result, properties)
    return result


# ---- scenes that must be the same on any number of ranks


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


def fields(result):
    """Field data and the table, but for how long it took and what memory it needed."""
    data = result.GetOutputDataObject(0).GetFieldData()
    tables = [data]
    if result.GetNumberOfOutputPorts() > 1:
        tables.append(result.GetOutputDataObject(1).GetRowData())
    found = []
    for table in tables:
        for i in range(table.GetNumberOfArrays()):
            array = table.GetAbstractArray(i)
            if "Second" not in array.GetName() and array.GetName() != "MemoryNeeded":  # which threads add to
                found.append([array.GetName(), [str(array.GetVariantValue(j)) for j in
                                                range(array.GetNumberOfValues())]])
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


# ---- errors and stops


def with_bad_value(rank):
    model, arrays = room()
    data = piece(model, arrays)
    if RANK == rank:
        data.GetCellData().GetArray("DiffuseReflectance").SetComponent(0, 0, 1.5)
    return data


def without_array(rank):
    data = piece(*room())
    if RANK == rank:
        data.GetCellData().RemoveArray("DiffuseReflectance")
    return data


def with_nan(rank):
    data = piece(*room())
    if RANK == rank:
        data.GetPoints().SetPoint(0, float("nan"), 0, 0)
    return data


def with_bad_cell(rank):
    data = piece(*room())
    if RANK == rank:
        corners = data.GetCell(0).GetPointIds().GetNumberOfIds()
        data.GetPolys().ReplaceCellAtId(0, corners, (0, 1, 2, 3)[:corners - 1] + (10**6,))
    return data


def with_short_array(rank):
    data = piece(*room())
    if RANK == rank:
        data.GetCellData().GetArray("Region").SetNumberOfTuples(1)
    return data


def aborting(result, rank):
    """One rank's user stops it as soon as it tells its progress."""
    if RANK == rank:
        result.AddObserver("ProgressEvent", lambda *_: result.SetAbortExecute(1))
    return result


def on_map_of(data, result, properties):
    """A filter on a map of the data."""
    light = illumination_map(data, Method=0, Photons=10000)
    result.SetInputConnection(light.GetOutputPort())
    set_all(result, properties)
    return result


def smoothing_of(data, **properties):
    return on_map_of(data, vtkIlluminationMapSmoothing(), properties)


def smoothing_nothing():
    result = vtkIlluminationMapSmoothing()
    result.SetInputData(vtkPolyData())
    return result


def one_rank_changed(rank):
    """Input that only one rank has anew: no rank may go on with the old run."""
    result = illumination_map(piece(*room()), Method=0, Photons=10000)
    result.Update()
    result.SetPhotons(20000)
    if RANK == rank:
        result.GetInputDataObject(0, 0).Modified()
    return result


def settings_of_one_rank(rank, **properties):
    result = illumination_map(piece(*room()), Photons=10000)
    if RANK == rank:
        set_all(result, properties)
    return result


FOR_EVER = 4 * 10**9


def appearance_of(data, **properties):
    return on_map_of(data, vtkIlluminatedAppearance(), properties)


def sensors_at(points, **properties):
    result = vtkIlluminanceSensors()
    light = illumination_map(piece(*room()), Method=0, Photons=10000)
    result.SetInputConnection(0, light.GetOutputPort())
    result.SetInputDataObject(2, points)
    result.SetLayout(result.POINTS)
    set_all(result, properties)
    return result


def points_of_one_rank(rank, place):
    return poly_data(np.array([place] * (RANK == rank), dtype=float).reshape(-1, 3), None, [], {})


# The array that shows that there is a result.
RESULTS = {vtkIlluminationMap: "Illuminance", vtkIlluminationMapSmoothing: "IlluminanceSmoothed",
           vtkIlluminatedAppearance: "DisplayColours", vtkIlluminanceSensors: "HorizontalIlluminance"}

# name -> (filter, words of the one error or None, whether there is a map)
STOPS = {
    "nothing": (lambda: illumination_map(vtkPolyData()), "no polygons", False),
    "one rank without cells": (lambda: illumination_map(piece(*room(), "hole"), Photons=10000), None, True),
    "all on the last rank": (lambda: illumination_map(piece(*room(), "last"), Photons=10000), None, True),
    "no luminaire": (lambda: illumination_map(piece(*room()), [vtkPolyData()]), "luminaire 1 is none", False),
    "bad value": (lambda: illumination_map(with_bad_value(2)), "cell 0 on rank 2: DiffuseReflectance (red) is 1.5", False),
    "missing array": (lambda: illumination_map(without_array(1)), "on rank 1 has no cell array 'DiffuseReflectance'",
                      False),
    "short array": (lambda: illumination_map(with_short_array(0)), "rank 0 of 3: cell array 'Region' has 1 values",
                    False),
    "not finite": (lambda: illumination_map(with_nan(1)), "are not finite", False),
    "bad cell": (lambda: illumination_map(with_bad_cell(2)), "rank 2 of 3: cell 0 uses point 1000000", False),
    "bad setting": (lambda: illumination_map(piece(*room()), MaximumPathLength=0), "maximum path length", False),
    "bad setting on one rank": (lambda: settings_of_one_rank(1, MaximumPathLength=0), "rank 1 of 3: the maximum path",
                                False),
    "too little memory on one rank": (lambda: settings_of_one_rank(2, MemoryLimit=1e-6), "rank 2 of 3", False),
    "too little memory": (lambda: illumination_map(piece(*room()), MemoryLimit=1e-6), "its limit is 1e-06 GiB", False),
    "abort while tracing": (lambda: aborting(illumination_map(piece(*room()), Method=0, Photons=FOR_EVER), 1), None,
                            True),
    "abort while gathering": (lambda: aborting(illumination_map(piece(*room(12)), Method=1, Photons=10000,
                                                                GatherRays=16384), 2), None, True),
    "time limit": (lambda: illumination_map(piece(*room()), Method=0, Photons=FOR_EVER, TimeLimit=0.3), None, True),
    "time limit while gathering": (lambda: illumination_map(piece(*room(12)), Method=1, Photons=10000,
                                                            GatherRays=16384, TimeLimit=0.3), None, True),
    "one rank changed": (lambda: one_rank_changed(1), None, True),
    "smoothing nothing": (smoothing_nothing, "no polygons", False),
    "smoothing, bad setting": (lambda: smoothing_of(piece(*room()), FeatureAngle=-1.0), "FeatureAngle", False),
    "smoothing, abort": (lambda: aborting(smoothing_of(piece(*room())), 1), None, False),
    "appearance, one rank without cells": (lambda: appearance_of(piece(*room(), "hole")), None, True),
    "appearance, bad setting on one rank": (lambda: appearance_of(piece(*room()), Reflectance=2.0 if RANK == 1 else 0.5),
                                            "rank 1 of 3: Reflectance is 2", False),
    "appearance, missing array": (lambda: appearance_of(piece(*room()), IlluminanceArray="Nothing"), "Nothing", False),
    "appearance, abort": (lambda: aborting(appearance_of(piece(*room())), 2), None, False),
    "sensors of one rank": (lambda: sensors_at(points_of_one_rank(1, (0.5, 0.5, 0.7)), GatherRays=16), None, True),
    "no sensors": (lambda: sensors_at(vtkPolyData()), "no points", False),
    "sensors not finite": (lambda: sensors_at(points_of_one_rank(2, (0.5, np.nan, 0.7))), "sensor 0", False),
    "sensors, abort": (lambda: aborting(sensors_at(points_of_one_rank(0, (0.5, 0.5, 0.7)), Photons=10**9), 1), None,
                       False),
}


def errors(output):
    found = {}
    for name, (make, *expected) in STOPS.items():
        result = make()
        messages = []

        def tell(_object, _event, text, to=messages):
            to.append(text)

        tell.CallDataType = "string0"
        for source in (result, result.GetInputAlgorithm()):
            if source:
                source.AddObserver("ErrorEvent", tell)
        result.Update()
        data = result.GetOutputDataObject(0)
        has = data.GetPointData().HasArray(RESULTS[type(result)]) != 0
        found[name] = {"errors": messages, "map": bool(has), "points": data.GetNumberOfPoints(),
                       "fields": fields(result), "expected": expected}
        # All ranks can go on with something else.
        again = illumination_map(piece(*room(1)), Method=0, Photons=2000)
        again.Update()
        found[name]["after"] = bool(again.GetOutput().GetPointData().HasArray("Illuminance")) or RANK > 2
    (output / f"errors_{RANK}.json").write_text(json.dumps(found))


if __name__ == "__main__":
    {"same": same, "statistics": statistics, "errors": errors}[sys.argv[1]](Path(sys.argv[2]), *sys.argv[3:])
