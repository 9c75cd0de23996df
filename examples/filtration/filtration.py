# SPDX-License-Identifier: BSD-3-Clause
"""The cabin before and after filtration (the paper's figure 9), and the photons that it saves.

Run by pvbatch: filtration.py OUTPUT_DIR. Writes filtration.png and two tables there.
"""

import sys
import time
from pathlib import Path

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "common"), str(HERE.parent / "cabin")]

import tables  # noqa: E402
from cabin_geometry import make_cabin  # noqa: E402
from comparison import with_array  # noqa: E402
from figure import draw_cabin  # noqa: E402
from illumination import IlluminationMap, illuminate, load_plugin, smooth  # noqa: E402

PHOTONS = 500_000
REFERENCE_PHOTONS = 30_000_000
REFERENCE_SEED = 1000
CABIN = {"LampType": "Emitting Facets", "ExitanceArray": "Exitance", "ReflectanceArray": "Reflectance"}
SHOWN = (30.0, 4000.0)  # lx, logarithmic, along the aisle
ABOVE = ("Coves", "Cove lamps", "Ceiling")  # lit straight from the lamps
DETAIL = 600.0  # lx, linear from 0, of the bin and the seats


def vertex_areas(surface):
    """A third of the triangles around each point (m²)."""
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    a, b, c = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)[corners].transpose(1, 0, 2)
    areas = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    return np.bincount(corners.ravel(), np.repeat(areas / 3.0, 3), surface.GetNumberOfPoints())


class Reference:
    """A map of many photons, and how far another one is from the truth."""

    def __init__(self, found):
        self.areas = vertex_areas(found.surface)
        self.lux = found.array()
        self.own = found.array("StandardError") ** 2

    def rms(self, lux, points):
        """Error over the area of some points, in % of their mean, without the reference's noise."""
        square = np.average((lux - self.lux)[points] ** 2 - self.own[points], weights=self.areas[points])
        return 100.0 * np.sqrt(square) / np.average(self.lux[points], weights=self.areas[points])


def points_of_parts(surface):
    """For each part of the cabin the numbers of its points."""
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    part = vtk_to_numpy(surface.GetCellData().GetArray("Part"))
    names = surface.GetFieldData().GetAbstractArray("PartNames")
    return {
        names.GetValue(i): np.unique(corners[part == i]) for i in range(names.GetNumberOfValues())
    }


def vtk_smoothing(surface):
    """What VTK has to offer for point data: each value moves towards the mean of its neighbours."""
    smoothing = vtk.vtkAttributeSmoothingFilter()
    smoothing.SetInputData(surface)
    smoothing.Update()
    return vtk_to_numpy(smoothing.GetOutput().GetPointData().GetArray("Illuminance"))


def timed(function, *arguments, **properties):
    """The function's result and the seconds it took."""
    start = time.perf_counter()
    return function(*arguments, **properties), time.perf_counter() - start


def main(output):
    """Lights the cabin, smooths it, measures, draws."""
    load_plugin()
    cabin = make_cabin()
    reference = Reference(illuminate(cabin, Photons=REFERENCE_PHOTONS, Seed=REFERENCE_SEED, **CABIN))
    raw = illuminate(cabin, Photons=PHOTONS, **CABIN)
    smoothed, seconds = timed(smooth, raw.surface)
    filtered = vtk_to_numpy(smoothed.GetPointData().GetArray("IlluminanceSmoothed"))
    told = vtk_to_numpy(smoothed.GetPointData().GetArray("StandardErrorSmoothed"))
    by_vtk, vtk_seconds = timed(vtk_smoothing, raw.surface)

    parts = points_of_parts(cabin)
    parts["Below the lamps"] = np.concatenate(
        [points for name, points in parts.items() if name not in ABOVE])
    rows = []
    for name, points in parts.items():
        before, after, rival = (reference.rms(lux, points) for lux in (raw.array(), filtered, by_vtk))
        expected = np.sqrt(np.average(told[points] ** 2, weights=reference.areas[points]))
        mean = np.average(reference.lux[points], weights=reference.areas[points])
        rows.append({
            "Part": name,
            "Before, %": before,
            "VTK's smoothing, %": rival,
            "Ours, %": after,
            "as it tells, %": 100.0 * expected / mean,
            "Photons saved, factor": (before / after) ** 2,
        })
    tables.write(rows, output / "filtration", "Filtration: the cabin's error (RMS, of the part's mean)")
    saving = rows[-1]["Photons saved, factor"]
    more = illuminate(cabin, Photons=int(saving * PHOTONS), **CABIN)
    times = [{"Map": "Illumination Map", "Seconds": raw.facts["Seconds"]},
             {"Map": "Illumination Map Smoothing", "Seconds": seconds},
             {"Map": "VTK's attribute smoothing", "Seconds": vtk_seconds},
             {"Map": "Illumination Map with the photons saved", "Seconds": more.facts["Seconds"]}]
    tables.write(times, output / "filtration_times", "Filtration: time")
    million = f"{PHOTONS / 1e6:g} million photons"
    draw_cabin(
        output / "filtration.png",
        {
            f"Before: {million}": raw,
            "After Illumination Map Smoothing": IlluminationMap(
                with_array(raw.surface, filtered, "Illuminance"), {}),
            f"Before: {saving * PHOTONS / 1e6:.1f} million photons": more,
        },
        *SHOWN,
        DETAIL,
    )


if __name__ == "__main__":
    main(Path(sys.argv[1]))
