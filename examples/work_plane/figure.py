# SPDX-License-Identifier: BSD-3-Clause
"""The picture: plans of the office with what its sensors measure."""

import numpy as np
import vtk

import bodies
from comparison import with_array
from pictures import Camera, Panel, Row, Scale, draw
from scene import CUPBOARD, LENGTH, WIDTH

CAMERA = Camera(
    position=(LENGTH / 2, WIDTH / 2, 12.0),
    focus=(LENGTH / 2, WIDTH / 2, 0.0),
    up=(0.0, 1.0, 0.0),
    angle=24.5,
)


def valid_part(sensors):
    """The cells of a grid whose sensors are all valid."""
    chosen = vtk.vtkThreshold()
    chosen.SetInputData(sensors)
    chosen.SetInputArrayToProcess(0, 0, 0, vtk.vtkDataObject.FIELD_ASSOCIATION_POINTS, "Valid")
    chosen.SetThresholdFunction(vtk.vtkThreshold.THRESHOLD_UPPER)
    chosen.SetUpperThreshold(0.5)
    surface = vtk.vtkGeometryFilter()
    surface.SetInputConnection(chosen.GetOutputPort())
    surface.Update()
    return surface.GetOutput()


def plan(sensors, array):
    """The valid part with one point array, and the cupboard where the plane cuts it (NaN)."""
    (x0, y0, _), (x1, y1, _) = CUPBOARD
    height = sensors.GetPoint(0)[2]
    corners = [(x0, y0, height), (x1, y0, height), (x1, y1, height), (x0, y1, height)]
    cupboard = bodies.to_surface(corners, 4 * [(0.0, 0.0, 1.0)], [(0, 1, 2), (0, 2, 3)])
    return bodies.appended(valid_part(sensors), with_array(cupboard, np.full(4, np.nan), array))


def draw_plans(path, desks, eyes):
    """Draws the work plane and the plane of eyes from above."""
    panels = [
        Panel(f"{name} illuminance at {height} m", plan(found, f"{name}Illuminance"), f"{name}Illuminance")
        for name, height, found in (("Horizontal", 0.75, desks), ("Cylindrical", 1.2, eyes))
    ]
    scale = Scale("lx", 100.0, 550.0, line_every=25.0)
    heading = "An office of 7.2 m by 4.8 m with six luminaires and a cupboard (grey), from above"
    draw(path, [Row(scale, panels, CAMERA, 640)], heading=heading)
