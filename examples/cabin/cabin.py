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

PHOTONS = 20_000_000
TITLES = {
    "Flat": "Flat (the paper's Fig. 7)",
    "Facet Ratio": "Facet Ratio (Fig. 8)",
    "Vertex Normalised": "Vertex Normalised (ours)",
}
SHOWN = (30.0, 4000.0)  # lx, logarithmic, along the aisle
DETAIL = 600.0  # lx, linear from 0, of the bin and the seats


def write_surface(surface, path):
    """Writes a vtkPolyData. Inline: ParaView 5.11 of Debian 12 cannot read back data that are appended."""
    writer = vtk.vtkXMLPolyDataWriter()
    writer.SetInputData(surface)
    writer.SetFileName(str(path))
    writer.SetDataModeToBinary()
    writer.Write()


def triangles_of(surface):
    """Corners (m, 3) and areas (m², (m,)) of the triangles of a vtkPolyData."""
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    a, b, c = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)[corners].transpose(1, 0, 2)
    return corners, 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)


def part_row(name, area, ours, others):
    """Illuminance (lx) of one part's triangles, and how far the others are off (RMS, of the mean)."""
    order = np.argsort(ours)
    low, high = np.interp([0.05, 0.95], np.cumsum(area[order]) / area.sum(), ours[order])
    mean = np.average(ours, weights=area)
    row = {"Part": name, "Area, m²": float(area.sum())}
    row.update({"Mean, lx": float(mean), "5 %, lx": float(low), "95 %, lx": float(high)})
    for title, lux in others.items():
        off = np.sqrt(np.average((lux - ours) ** 2, weights=area)) / mean
        row[f"{title} differs by, %"] = 100.0 * float(off)
    return row


def part_rows(maps):
    """A row for every part; maps: registration -> IlluminationMap, the last one is the reference."""
    surface = next(iter(maps.values())).surface
    corners, area = triangles_of(surface)
    lux = {title: found.array()[corners].mean(axis=1) for title, found in maps.items()}
    _, ours = lux.popitem()
    part = vtk_to_numpy(surface.GetCellData().GetArray("Part"))
    names = surface.GetFieldData().GetAbstractArray("PartNames")
    rows = []
    for i in range(names.GetNumberOfValues()):
        own = part == i
        others = {title: values[own] for title, values in lux.items()}
        rows.append(part_row(names.GetValue(i), area[own], ours[own], others))
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
    maps = {
        registration: illuminate(
            cabin,
            LampType="Emitting Facets",
            ExitanceArray="Exitance",
            ReflectanceArray="Reflectance",
            Registration=registration,
            Photons=PHOTONS,
        )
        for registration in TITLES
    }
    runs = [run_row(registration, found.facts) for registration, found in maps.items()]
    tables.write(runs, output / "cabin_runs", "Cabin: photons and time")
    tables.write(part_rows(maps), output / "cabin_parts", "Cabin: illuminance, Vertex Normalised")
    titled = {TITLES[registration]: found for registration, found in maps.items()}
    draw_cabin(output / "cabin.png", titled, *SHOWN, DETAIL)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
