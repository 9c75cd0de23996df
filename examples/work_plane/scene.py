# SPDX-License-Identifier: BSD-3-Clause
"""An office with six recessed luminaires and two cupboards, and its sensors. Metres, z up."""

from pathlib import Path

import numpy as np
from paraview import servermanager, simple
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import bodies
from illumination import as_source

LENGTH, WIDTH, HEIGHT = 7.2, 4.8, 2.8
FLOOR, WALLS, CEILING, CUPBOARDS = 0.2, 0.5, 0.7, 0.4  # reflectances
MAINTENANCE = 0.8  # of the luminaires' flux that is left before they are cleaned
FILE = str(Path(__file__).resolve().parent / "panel_4000lm.ies")
PLACES = [(x, y, HEIGHT) for y in (1.2, 3.6) for x in (1.2, 3.6, 6.0)]
CUPBOARD = ((5.6, 0.0, 0.0), (6.8, 0.9, 1.8))  # two opposite corners
DESK_HEIGHT, EYE_HEIGHT = 0.75, 1.2  # of the work plane and of someone who sits


def box(low, high, reflectances, inward):
    """Six rectangles of two triangles; reflectances: of bottom, sides and top."""
    low, high = np.array(low), np.array(high)
    parts = []
    for axis in range(3):
        u, v = np.roll(np.eye(3), axis + 1, axis=1)[0], np.roll(np.eye(3), axis + 2, axis=1)[0]
        size = high - low
        for end, corner in enumerate((low, low + size * np.eye(3)[axis])):
            points = [corner, corner + size * u, corner + size * (u + v), corner + size * v]
            outward = np.eye(3)[axis] * (1.0 if end else -1.0)
            normal = -outward if inward else outward
            turned = np.dot(np.cross(u, v), normal) < 0.0
            order = [(0, 2, 1), (0, 3, 2)] if turned else [(0, 1, 2), (0, 2, 3)]
            part = bodies.to_surface(points, [normal] * 4, order)
            rho = reflectances[1] if axis < 2 else reflectances[0 if end == 0 else 2]
            array = numpy_to_vtk(np.full(2, rho), deep=1)
            array.SetName("DiffuseReflectance")
            part.GetCellData().AddArray(array)
            parts.append(part)
    return bodies.appended(*parts)


def office(black=False):
    """The surfaces as one vtkPolyData; black: nothing reflects, and there is no cupboard."""
    share = 0.0 if black else 1.0
    size = (LENGTH, WIDTH, HEIGHT)
    room = box((0, 0, 0), size, [share * rho for rho in (FLOOR, WALLS, CEILING)], inward=True)
    return room if black else bodies.appended(room, box(*CUPBOARD, 3 * [CUPBOARDS], inward=False))


def luminaires():
    """Six ParaView sources of the photometric file, dimmed by the maintenance factor."""
    return [
        simple.Luminaire(
            LuminaireName=f"Panel {i + 1}",
            Type="Photometric File",
            FileName=FILE,
            Position=place,
            Dimming=MAINTENANCE,
        )
        for i, place in enumerate(PLACES)
    ]


class Office:
    """The office lit by Illumination Map, whose sensors can be read."""

    def __init__(self, black=False):
        self.lamps = luminaires()
        self.lit = simple.IlluminationMap(
            Input=as_source(office(black)), Luminaires=self.lamps, Photons=2048
        )

    def sensors(self, **properties):
        """The output of Illuminance Sensors as a vtkPolyData; properties are those of the filter."""
        proxy = simple.IlluminanceSensors(Input=self.lit, Luminaires=self.lamps, **properties)
        proxy.UpdatePipeline()
        result = servermanager.Fetch(proxy)
        simple.Delete(proxy)
        if result.GetPointData().GetArray("Valid") is None:
            raise RuntimeError("Illuminance Sensors has failed; its message is above")
        return result


def values(sensors, name):
    """A point array of those sensors that are valid."""
    arrays = sensors.GetPointData()
    return vtk_to_numpy(arrays.GetArray(name))[vtk_to_numpy(arrays.GetArray("Valid")) == 1]
