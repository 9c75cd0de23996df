# SPDX-License-Identifier: BSD-3-Clause
"""The cabin with a table that is folded out and a material for every part. Metres."""

import sys
from pathlib import Path

import numpy as np
from paraview import servermanager, simple
from vtk.util.numpy_support import vtk_to_numpy

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "common"), str(HERE.parent / "cabin")]

from cabin_geometry import REFLECTANCE, to_polydata  # noqa: E402
from illumination import as_source  # noqa: E402
from mesh import merged, mirrored, moved, rounded_box  # noqa: E402
from refine import refined  # noqa: E402
from seats import AISLE, ARMREST, PLACE, SEAT_PITCH, seats  # noqa: E402
from shell import WINDOW_PITCH, shell  # noqa: E402

ROWS, WINDOWS = 4, 9
ROOM = WINDOWS * WINDOW_PITCH
FIRST_ROW = ROOM - 1.35  # x of the seats of row 1, the foremost
PART_NAMES = [*REFLECTANCE, "Tables"]
TABLES = ("1E",)  # seats with a table before them
TABLE_AHEAD, TABLE_TOP = 0.43, 0.69  # of a seat's x = 0; above the floor

# Properties of Surface Material; colours are red, green, blue and linear.
MATERIALS = {
    "Floor": {"DiffuseReflectance": (0.34, 0.035, 0.045)},
    "Side walls": {"Preset": "White Paint"},
    "Window niches": {"Preset": "White Paint"},
    "Window panes": {"Preset": "Clear Glass"},
    "Overhead bins": {"Preset": "White Paint"},
    "Coves": {"Preset": "White Paint"},
    "Cove lamps": {"Preset": "White Paint"},
    "Ceiling": {"Preset": "White Paint"},
    "Bulkheads": {"Preset": "Wood"},
    "Seat cushions": {"DiffuseReflectance": (0.16, 0.18, 0.21)},
    "Seat backs": {"DiffuseReflectance": (0.16, 0.18, 0.21)},
    "Armrests and frames": {"DiffuseReflectance": (0.10, 0.10, 0.10)},
    "Tables": {
        "DiffuseReflectance": (0.11, 0.06, 0.035),
        "GlossyReflectance": (0.2, 0.2, 0.2),
        "Roughness": 0.15,
    },
}
LONGEST = {  # edges, m; of the others as in cabin/
    "Floor": 0.08, "Side walls": 0.08, "Overhead bins": 0.08, "Bulkheads": 0.09,
    "Seat cushions": 0.05, "Seat backs": 0.05, "Armrests and frames": 0.1, "Tables": 0.03,
}  # fmt: skip
BODIES = ("Seat cushions", "Seat backs", "Armrests and frames", "Tables")  # closed, each by itself


def place(seat):
    """x and y (m) of a seat such as 1F: rows from the front, A to F from left to right."""
    x = FIRST_ROW - SEAT_PITCH * (int(seat[0]) - 1)
    from_aisle = {"C": -0.5, "B": -1.5, "A": -2.5, "D": 0.5, "E": 1.5, "F": 2.5}[seat[1]]  # places
    return x, from_aisle * PLACE + np.copysign(AISLE / 2.0 + ARMREST / 2.0, from_aisle)


def table():
    """A table that has been folded out of an armrest, for the seat at x = y = 0; its top at 0.69 m."""
    board = moved(rounded_box((0.13, 0.2, 0.01), 0.008, (4, 6, 1), 2), (TABLE_AHEAD, 0.0, TABLE_TOP - 0.01))
    arm = moved(rounded_box((0.16, 0.012, 0.015), 0.01, (2, 1, 1), 1), (0.34, PLACE / 2.0 - 0.03, 0.655))
    return merged([board, arm, mirrored(arm)])


def make_scene():
    """The cabin with tables and materials, a vtkPolyData.

    Its cell array Part says which part a cell is of (PartNames), Exitance where light is emitted
    (1, or else 0).
    """
    parts = shell(WINDOWS)
    parts.update(seats(ROWS, FIRST_ROW - SEAT_PITCH * (ROWS - 1)))
    parts["Tables"] = merged([moved(table(), (*place(seat), 0.0)) for seat in TABLES])
    for name, longest in LONGEST.items():
        parts[name] = refined(parts[name], longest, curved=name in BODIES)
    cabin = to_polydata(parts, 1.0, dict.fromkeys(PART_NAMES, 0.0))
    cabin.GetCellData().RemoveArray("Reflectance")  # Surface Material says more
    return with_materials(cabin)


def with_materials(cabin):
    """The cabin as a chain of Surface Material filters leaves it, one for each part."""
    chain = [as_source(cabin)]
    for number, name in enumerate(PART_NAMES):
        chain.append(
            simple.SurfaceMaterial(
                Input=chain[-1], CellArray="Part", CellValue=number, **MATERIALS[name]
            )
        )
    chain[-1].UpdatePipeline()
    scene = servermanager.Fetch(chain[-1])
    for proxy in reversed(chain):
        simple.Delete(proxy)
    return scene


def places(scene):
    """Where means are taken: name -> which points."""
    corners = vtk_to_numpy(scene.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    part = np.empty(scene.GetNumberOfPoints(), dtype=int)  # parts share no points
    part[corners] = vtk_to_numpy(scene.GetCellData().GetArray("Part"))[:, None]
    of = {name: part == number for number, name in enumerate(PART_NAMES)}
    x, y, z = vtk_to_numpy(scene.GetPoints().GetData()).T
    above = (np.abs(x - place("1E")[0] - TABLE_AHEAD) < 0.25) & (y > 0.7) & (y < 1.1)
    return {
        "Table 1E": of["Tables"] & (z > TABLE_TOP - 0.001),
        "Bin above it": of["Overhead bins"] & above & (z < 1.9),
        "Carpet": of["Floor"],
        "Lower side walls": of["Side walls"] & (z < 0.6),
        "Seat cushions": of["Seat cushions"],
        "Ceiling": of["Ceiling"],
    }
