# SPDX-License-Identifier: BSD-3-Clause
"""The picture: daylight factors on floor and walls, seen from outside through the near sides."""

import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy

import bodies
from comparison import with_array
from pictures import Camera, Panel, Row, Scale, draw
from scene import OUTDOORS

FACTOR = "Daylight factor"  # point array, % of the light outdoors
CAMERA = Camera(position=(-4.6, -6.2, 6.4), focus=(2.1, 0.15, 1.15), angle=32.0)
SCALE = Scale("Daylight factor, %", 0.0, 10.0, line_every=1.0, clips=True)


def facing(surface, camera):
    """The room's triangles whose lit side the camera sees, as a vtkPolyData with all points."""
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    points, _ = bodies.points_and_normals(surface)
    a, b, c = points[corners].transpose(1, 0, 2)
    towards = np.einsum("ij,ij->i", np.cross(b - a, c - a), np.array(camera.position) - a) > 0.0
    room = vtk_to_numpy(surface.GetCellData().GetArray("Room")) > 0.0
    kept = vtk.vtkExtractCells()
    kept.SetInputData(surface)
    ids = vtk.vtkIdList()
    for i in np.flatnonzero(towards & room):
        ids.InsertNextId(int(i))
    kept.SetCellList(ids)
    outside = vtk.vtkGeometryFilter()
    outside.SetInputConnection(kept.GetOutputPort())
    outside.Update()
    return outside.GetOutput()


def draw_room(path, surface, maps, rows):
    """Draws maps (name -> illuminance of every point, lx); rows: those of the table."""
    panels = []
    for (name, lux), row in zip(maps.items(), rows, strict=True):
        shown = facing(with_array(surface, 100.0 * lux / OUTDOORS, FACTOR), CAMERA)
        error = row["RMS error in the room, %"]
        panels.append(Panel(f"{name}, {row['Seconds']:.1f} s: {error:.3g} % off", shown, FACTOR))
    heading = "Daylight factors under an overcast sky (error: RMS over the room, of its mean)"
    draw(path, [Row(SCALE, panels, CAMERA, 560)], heading=heading)
