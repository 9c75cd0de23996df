# SPDX-License-Identifier: BSD-3-Clause
"""An aircraft cabin with indirect light only: the paper's figures 7 and 8, and ours.

Run by pvbatch: cabin.py OUTPUT_DIR. Writes cabin.vtp, cabin.png and two tables there.
"""

import sys
from pathlib import Path

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "common")]

import tables  # noqa: E402
from cabin_geometry import make_cabin  # noqa: E402
from figure import draw_cabin  # noqa: E402
from illumination import illuminate, load_plugin  # noqa: E402

PHOTONS = 30_000_000
TITLES = {
    "Flat": "Flat (the paper's Fig. 7)",
    "Facet Ratio": "Facet Ratio (Fig. 8)",
    "Vertex Normalised": "Vertex Normalised (ours)",
}
SHOWN = (20.0, 5000.0)  # lx, logarithmic, along the aisle
DETAIL = 500.0  # lx, linear from 0, of the bin and the seats


def write_surface(surface, path):
    """Writes a vtkPolyData. Inline data: VTK's reader of appended data trips over expat 2.6."""
    writer = vtk.vtkXMLPolyDataWriter()
    writer.SetInputData(surface)
    writer.SetFileName(str(path))
    writer.SetDataModeToBinary()
    writer.Write()


def part_rows(found):
    """Mean and percentiles of the illuminance (lx) of every part, weighted by area."""
    surface = found.surface
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    a, b, c = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)[corners].transpose(1, 0, 2)
    area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    lux = found.array()[corners].mean(axis=1)
    part = vtk_to_numpy(surface.GetCellData().GetArray("Part"))
    names = surface.GetFieldData().GetAbstractArray("PartNames")
    rows = []
    for i in range(names.GetNumberOfValues()):
        own = part == i
        order = np.argsort(lux[own])
        share = np.cumsum(area[own][order]) / area[own].sum()
        low, high = np.interp([0.05, 0.95], share, lux[own][order])
        mean = np.average(lux[own], weights=area[own])
        row = {"Part": names.GetValue(i), "Area, m²": area[own].sum()}
        row.update({"Mean, lx": mean, "5 %, lx": low, "95 %, lx": high})
        rows.append({key: v if isinstance(v, str) else float(v) for key, v in row.items()})
    return rows


def run_row(registration, facts):
    """What one run cost and where its photons went."""
    count = {key: int(facts[f"Photons{key}"]) for key in ("Emitted", "Absorbed", "Escaped", "CutOff")}
    return {
        "Registration": registration,
        "Emitted": count["Emitted"],
        "Absorbed": count["Absorbed"],
        "Escaped": count["Escaped"],
        "Cut off": count["CutOff"],
        "Seconds": facts["Seconds"],
        "Million segments/s": facts["SegmentsPerSecond"] / 1e6,
    }


def main(output):
    """Makes the cabin, lights it three times, draws and tabulates it."""
    load_plugin()
    cabin = make_cabin()
    output.mkdir(parents=True, exist_ok=True)
    write_surface(cabin, output / "cabin.vtp")
    maps, runs = {}, []
    for registration, title in TITLES.items():
        maps[title] = illuminate(
            cabin,
            LampType="Emitting Facets",
            ExitanceArray="Exitance",
            ReflectanceArray="Reflectance",
            Registration=registration,
            Photons=PHOTONS,
        )
        runs.append(run_row(registration, maps[title].facts))
    tables.write(runs, output / "cabin_runs", "Cabin: photons and time")
    ours = maps[TITLES["Vertex Normalised"]]
    tables.write(part_rows(ours), output / "cabin_parts", "Cabin: illuminance, Vertex Normalised")
    draw_cabin(output / "cabin.png", maps, *SHOWN, DETAIL)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
