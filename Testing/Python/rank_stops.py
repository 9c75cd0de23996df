# SPDX-License-Identifier: BSD-3-Clause
"""Bad input and stops of all kinds, some on one rank only, for rank_scenes.py."""

import json

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPolyData

from rank_pieces import RANK, fields, illumination_map, piece, poly_data, room, set_all
from vtkIllumination import (vtkIlluminanceSensors, vtkIlluminatedAppearance, vtkIlluminationMap,
                             vtkIlluminationMapSmoothing)


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
