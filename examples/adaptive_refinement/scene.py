# SPDX-License-Identifier: BSD-3-Clause
"""A room of two triangles a wall with a table, a pillar and a round lamp. Metres, z up."""

import time

import numpy as np
import vtk
from matplotlib.tri import LinearTriInterpolator, Triangulation
from vtk.util.numpy_support import vtk_to_numpy

import bodies
from illumination import illuminate

LOW, HIGH = np.zeros(3), np.array([4.0, 3.0, 2.5])
LAMP = (1.4, 1.2, 2.4)
TOP = (np.array([1.9, 1.0, 0.70]), np.array([3.1, 1.9, 0.75]))
LEG = 0.08  # m, width
PILLAR = (np.array([0.5, 2.2, 0.0]), np.array([0.8, 2.5, 1.6]))
GAP = 1e-4  # m, by which bodies stand off the floor, lest faces lie in one place
PHOTONS = 1_000_000
FINE = 0.05  # m: edges of the floor on which the map is looked at point by point
MARGIN = 0.02  # m: from the edge of a body's foot, where a point of that floor is left out


def box(low, high, inward=False):
    """The six faces of a box, two triangles each: lists of points (4, 3) and a normal."""
    faces = []
    for axis in range(3):
        for side in (0, 1):
            u, v = (axis + 1) % 3, (axis + 2) % 3
            corners = np.full((4, 3), high[axis] if side else low[axis], dtype=float)
            corners[:, u] = [low[u], high[u], high[u], low[u]]
            corners[:, v] = [low[v], low[v], high[v], high[v]]
            normal = np.zeros(3)
            normal[axis] = (1.0 if side else -1.0) * (-1.0 if inward else 1.0)
            faces.append((corners, normal))
    return faces


def surface_of(faces):
    """A vtkPolyData of rectangles, each with points of its own, wound as their normals say."""
    points, normals, triangles = [], [], []
    for corners, normal in faces:
        first = len(points) * 4
        turn = np.dot(np.cross(corners[1] - corners[0], corners[2] - corners[0]), normal) < 0.0
        order = (0, 3, 2, 1) if turn else (0, 1, 2, 3)
        a, b, c, d = (first + i for i in order)
        triangles += [(a, b, c), (a, c, d)]
        points.append(corners)
        normals.append(np.tile(normal, (4, 1)))
    return bodies.to_surface(np.vstack(points), np.vstack(normals), np.array(triangles))


def furniture():
    """The table's top and legs, and the pillar."""
    low, high = TOP
    boxes = [TOP, (PILLAR[0] + (0.0, 0.0, GAP), PILLAR[1])]
    for x in (low[0], high[0] - LEG):
        for y in (low[1], high[1] - LEG):
            foot = np.array([x, y, GAP])
            boxes.append((foot, foot + (LEG, LEG, low[2] - 2.0 * GAP)))
    return [face for ends in boxes for face in box(*ends)]


def room():
    """All of it as one vtkPolyData; the floor is the first face."""
    walls = box(LOW, HIGH, inward=True)
    floor = next(i for i, (_, normal) in enumerate(walls) if normal[2] > 0.5)
    walls.insert(0, walls.pop(floor))
    return surface_of(walls + furniture())


def fine_floor():
    """The floor alone with many points, to put in place of the coarse one."""
    source = vtk.vtkPlaneSource()
    source.SetPoint1(HIGH[0], 0.0, 0.0)
    source.SetPoint2(0.0, HIGH[1], 0.0)
    source.SetResolution(*(int(round(n / FINE)) for n in HIGH[:2]))
    cut = vtk.vtkTriangleFilter()
    cut.SetInputConnection(source.GetOutputPort())
    cut.Update()
    return cut.GetOutput()


def light(surface, **properties):
    """The map of a vtkPolyData by Final Gathering."""
    start = time.perf_counter()
    found = illuminate(
        surface,
        Method="Final Gathering",
        LampType="Disk",
        LampPosition=list(LAMP),
        LampDirection=[0.0, 0.0, -1.0],
        LampSize=[0.06, 0.0],
        LuminousFlux=1500.0,
        Reflectance=0.6,
        Photons=PHOTONS,
        **properties,
    )
    found.facts["All seconds"] = time.perf_counter() - start
    return found


def room_map(**properties):
    """The map of the room."""
    return light(room(), **properties)


def floor_points():
    """Points of the floor with their light (lx) and its standard error, each received at the point."""
    walls = surface_of([f for f in box(LOW, HIGH, inward=True) if f[1][2] < 0.5] + furniture())
    ground = fine_floor()
    found = light(bodies.appended(ground, walls), Seed=77)
    count = ground.GetNumberOfPoints()
    points = vtk_to_numpy(found.surface.GetPoints().GetData())[:count]
    inside = np.all((points[:, :2] > MARGIN) & (points[:, :2] < HIGH[:2] - MARGIN), axis=1)
    for low, high in feet():
        inside &= np.any((points[:, :2] < low - MARGIN) | (points[:, :2] > high + MARGIN), axis=1)
    return points[inside], found.array()[:count][inside], found.array("StandardError")[:count][inside]


def feet():
    """Rectangles of the floor on which bodies stand."""
    low, high = TOP
    corners = [np.array([x, y]) for x in (low[0], high[0] - LEG) for y in (low[1], high[1] - LEG)]
    return [(c, c + LEG) for c in corners] + [(PILLAR[0][:2], PILLAR[1][:2])]


def interpolated(surface, points):
    """The illuminance of a map at points of its floor, linear on its triangles."""
    xyz = vtk_to_numpy(surface.GetPoints().GetData())
    cells = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    cells = cells[np.all(xyz[cells, 2] == 0.0, axis=1)]
    used, corners = np.unique(cells, return_inverse=True)
    lux = vtk_to_numpy(surface.GetPointData().GetArray("Illuminance"))[used]
    floor = Triangulation(*xyz[used, :2].T, corners.reshape(-1, 3))
    found = LinearTriInterpolator(floor, lux)(*points[:, :2].T)
    assert not np.ma.is_masked(found)
    return np.asarray(found)


def error_of(surface, reference):
    """RMS error of a map between its points, as a share of the floor's mean light.

    reference: what floor_points() returns; its noise is taken out.
    """
    points, lux, noise = reference
    squares = np.mean((interpolated(surface, points) - lux) ** 2) - np.mean(noise**2)
    return np.sqrt(max(0.0, squares)) / lux.mean()


def rows_of_table(before, after):
    """A row for each map."""
    reference = floor_points()
    names = ("Final Gathering", "with AdaptiveRefinement")
    return [
        {
            "Map": name,
            "Triangles": found.surface.GetNumberOfCells(),
            "RMS error on the floor, %": 100.0 * error_of(found.surface, reference),
            "Seconds": found.facts["All seconds"],
        }
        for name, found in zip(names, (before, after))
    ]
