# SPDX-License-Identifier: BSD-3-Clause
"""The scenes whose accuracy is measured: surface, lamp and, where it is known, the exact answer."""

import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk

EXAMPLES = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(EXAMPLES / "common"), str(EXAMPLES / "cabin")]

import bodies  # noqa: E402
from accuracy import point_areas  # noqa: E402
from cabin_geometry import make_cabin  # noqa: E402

ILLUMINANCE = 1000.0  # lx: of the parallel light at a right angle, and everywhere in the room
REFLECTANCE = 0.75  # of the room
ROOM = (4.0, 3.0, 2.4)  # m
CELLS = 12  # squares along each edge of the room


@dataclass
class Truth:
    """What a map is compared with."""

    lux: object  # illuminance of every point
    error: float = 0.0  # its own relative error: 0 where it is exact


@dataclass
class Scene:
    """A surface under light; lengths in metres."""

    name: str
    title: str  # for figures
    surface: object  # vtkPolyData of triangles with point normals
    lamp: dict  # properties of the filter
    exact: object  # Truth; None where only a long run tells
    largest: int  # photons up to which the curves run
    long: int = 0  # photons of the long run, if that is the truth
    luminaire: dict | None = None  # properties of a Luminaire, in place of the filter's lamp
    counted: object = None  # which points count; None: all

    def areas(self):
        """The area that each point stands for (m²), 0 where it does not count."""
        areas = point_areas(self.surface)
        return areas if self.counted is None else areas * self.counted

    def share(self, error, lux):
        """Area-weighted RMS of errors at points (lx), as a share of the mean of lux."""
        areas = self.areas()
        return float(np.sqrt(np.average(error**2, weights=areas)) / np.average(lux, weights=areas))

    def relative_error(self, lux, truth=None):
        """Area-weighted RMS error of a map (lx), as a share of the mean illuminance.

        The noise of the truth, which is independent of the map's, is taken out.
        """
        truth = truth or self.exact
        square = self.share(lux - truth.lux, truth.lux) ** 2
        return float(np.sqrt(max(square - truth.error**2, 0.0)))


def with_cell_value(surface, name, value):
    """Gives every cell of a vtkPolyData the same value, in an array of that name."""
    array = numpy_to_vtk(np.full(surface.GetNumberOfCells(), value), deep=1)
    array.SetName(name)
    surface.GetCellData().AddArray(array)
    return surface


def wall(axis, side):
    """One wall of the room: its point normals look inwards along the axis (0 to 2)."""
    plane = vtk.vtkPlaneSource()
    plane.SetResolution(CELLS, CELLS)
    u, v = (0.5 * ROOM[i] * np.eye(3)[i] for i in range(3) if i != axis)
    centre = 0.5 * side * ROOM[axis] * np.eye(3)[axis]
    plane.SetOrigin(*(centre - u - v))
    plane.SetPoint1(*(centre + u - v))
    plane.SetPoint2(*(centre - u + v))
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputConnection(plane.GetOutputPort())
    triangles.Update()
    surface = triangles.GetOutput()
    inwards = np.tile(-side * np.eye(3, dtype=np.float32)[axis], (surface.GetNumberOfPoints(), 1))
    normals = numpy_to_vtk(inwards, deep=1)
    normals.SetName("Normals")
    surface.GetPointData().SetNormals(normals)
    return surface


def sphere():
    """16 by 8 facets under parallel light, black: E = E0 max(n . l, 0)."""
    surface = bodies.sphere()
    _, normals = bodies.points_and_normals(surface)
    direction = np.array([0.40, 0.70, -0.60]) / np.linalg.norm([0.40, 0.70, -0.60])
    lamp = {
        "LampType": "Parallel",
        "LampDirection": direction.tolist(),
        "ParallelIlluminance": ILLUMINANCE,
        "Reflectance": 0.0,
    }
    exact = ILLUMINANCE * np.maximum(-normals @ direction, 0.0)
    return Scene("sphere", "Coarse sphere, parallel light", surface, lamp, Truth(exact), 10_000_000)


def room():
    """A closed room with a coarse ball in it; all that is there glows evenly and reflects.

    With exitance M and reflectance rho everywhere, E = M / (1 - rho) everywhere.
    """
    walls = [wall(axis, side) for axis in range(3) for side in (-1.0, 1.0)]
    surface = bodies.appended(*walls, bodies.sphere())
    with_cell_value(surface, "Exitance", ILLUMINANCE * (1.0 - REFLECTANCE))
    lamp = {
        "LampType": "Emitting Facets",
        "ExitanceArray": "Exitance",
        "Reflectance": REFLECTANCE,
    }
    exact = np.full(surface.GetNumberOfPoints(), ILLUMINANCE)
    title = "Closed room with a coarse ball, all glowing"
    return Scene("room", title, surface, lamp, Truth(exact), 2_000_000)


def cabin():
    """An aircraft cabin that its coves light; the exact answer is not known."""
    lamp = {
        "LampType": "Emitting Facets",
        "ExitanceArray": "Exitance",
        "ReflectanceArray": "Reflectance",
    }
    title = "Aircraft cabin, cove light"
    return Scene("cabin", title, make_cabin(), lamp, None, 5_000_000, long=16_000_000)


SCENES = {"sphere": sphere, "room": room, "cabin": cabin}
