# SPDX-License-Identifier: BSD-3-Clause
"""The paper's cylinder and sphere: coarse triangles, exact normals. Metres, z up."""

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray, vtk_to_numpy

RADIUS = 0.5  # of the sphere
CYLINDER_RADIUS = 0.42
CYLINDER_HALF_HEIGHT = 0.6
SPHERE_CENTRE = (0.6, 0.0, 0.0)
CYLINDER_CENTRE = np.array([-0.6, 0.0, 0.0])


def sphere():
    """16 by 8 facets on a sphere."""
    source = vtk.vtkSphereSource()
    source.SetCenter(SPHERE_CENTRE)
    source.SetRadius(RADIUS)
    source.SetThetaResolution(16)
    source.SetPhiResolution(9)  # counts the poles
    source.Update()
    return source.GetOutput()


def icosphere(centre, radius, subdivisions):
    """An icosahedron whose triangles are divided in four so often and lifted onto the sphere."""
    source = vtk.vtkPlatonicSolidSource()
    source.SetSolidTypeToIcosahedron()
    source.Update()
    surface = source.GetOutput()
    for _ in range(subdivisions):
        divide = vtk.vtkLinearSubdivisionFilter()
        divide.SetInputData(surface)
        divide.Update()
        surface = divide.GetOutput()
        points = vtk_to_numpy(surface.GetPoints().GetData())
        points /= np.linalg.norm(points, axis=1, keepdims=True)
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    corners = corners[:, ::-1]  # VTK's icosahedron is inside out
    return to_surface(radius * points + centre, points, corners)


def to_surface(points, normals, triangles):
    """A vtkPolyData of points (n, 3), their unit normals (n, 3) and triangles (m, 3)."""
    surface = vtk.vtkPolyData()
    surface.SetPoints(vtk.vtkPoints())
    surface.GetPoints().SetData(numpy_to_vtk(np.asarray(points, dtype=np.float32), deep=1))
    array = numpy_to_vtk(np.asarray(normals, dtype=np.float32), deep=1)
    array.SetName("Normals")
    surface.GetPointData().SetNormals(array)
    cells = vtk.vtkCellArray()
    offsets = np.arange(0, 3 * len(triangles) + 1, 3)
    cells.SetData(*(numpy_to_vtkIdTypeArray(a, deep=1) for a in (offsets, np.ravel(triangles))))
    surface.SetPolys(cells)
    return surface


def disk(centre, normal, across, sides, rings):
    """A flat disk of so many sides; across: its radius (m) times the unit vector to one corner."""
    angle = 2.0 * np.pi * np.arange(sides) / sides
    rim = np.cos(angle)[:, None] * across + np.sin(angle)[:, None] * np.cross(normal, across)
    share = np.arange(1, rings + 1)[:, None, None] / rings
    points = np.vstack([np.zeros(3), (share * rim).reshape(-1, 3)]) + centre
    j = np.arange(sides)
    following = (j + 1) % sides
    triangles = [np.stack([np.zeros_like(j), 1 + j, 1 + following], axis=1)]
    for inner in 1 + sides * np.arange(rings - 1):
        outer = inner + sides
        triangles.append(np.stack([inner + j, outer + j, outer + following], axis=1))
        triangles.append(np.stack([inner + j, outer + following, inner + following], axis=1))
    return to_surface(points, np.tile(normal, (len(points), 1)), np.concatenate(triangles))


def cylinder():
    """An upright cylinder of 12 sides; its ends are flat and have points of their own."""
    up = np.array([0.0, 0.0, CYLINDER_HALF_HEIGHT])
    axis = vtk.vtkLineSource()
    axis.SetPoint1(*(CYLINDER_CENTRE - up))
    axis.SetPoint2(*(CYLINDER_CENTRE + up))
    axis.SetResolution(12)
    tube = vtk.vtkTubeFilter()
    tube.SetInputConnection(axis.GetOutputPort())
    tube.SetRadius(CYLINDER_RADIUS)
    tube.SetNumberOfSides(12)
    triangles = vtk.vtkTriangleFilter()
    triangles.SetInputConnection(tube.GetOutputPort())
    triangles.Update()
    side = triangles.GetOutput()
    side.GetPointData().GetNormals().SetName("Normals")  # as the other surfaces'
    corner = CYLINDER_RADIUS * points_and_normals(side)[1][0]
    ends = [disk(CYLINDER_CENTRE + s * up, (0.0, 0.0, s), corner, 12, 3) for s in (1.0, -1.0)]
    return appended(side, *ends)


def appended(*surfaces):
    """One vtkPolyData of several."""
    append = vtk.vtkAppendPolyData()
    for surface in surfaces:
        append.AddInputData(surface)
    append.Update()
    return append.GetOutput()


def points_and_normals(surface):
    """Points (m) and unit normals of a vtkPolyData, each (n, 3), in double precision."""
    points = vtk_to_numpy(surface.GetPoints().GetData()).astype(float)
    normals = vtk_to_numpy(surface.GetPointData().GetNormals()).astype(float)
    return points, normals / np.linalg.norm(normals, axis=1, keepdims=True)
