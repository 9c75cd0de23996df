# SPDX-License-Identifier: BSD-3-Clause
"""A room with a window, the ground before it and an overcast sky. Metres, z up."""

import numpy as np
from paraview import servermanager, simple
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import bodies
from illumination import IlluminationMap, as_source, facts_of, texts

CELLS = 24  # along each edge of the room
WINDOW = ((-2.0 / 3.0, 2.0 / 3.0), (0.75, 2.25))  # y and z in the wall x = 4
OUTDOORS = 10_000.0  # lx, of the sky on open level ground
SKY = {"Type": "CIE Sky", "SkyType": "16 Traditional overcast sky", "Illuminance": OUTDOORS}
GROUND = 0.2  # reflectance
# Corner, two edges whose cross product looks at the light, and reflectance. The floor is first.
SIDES = (
    ((0, -2, 0), (4, 0, 0), (0, 4, 0), 0.3),
    ((0, -2, 0), (0, 4, 0), (0, 0, 3), 0.6),
    ((0, -2, 0), (0, 0, 3), (4, 0, 0), 0.6),
    ((0, 2, 0), (4, 0, 0), (0, 0, 3), 0.6),
    ((4, -2, 0), (0, 0, 3), (0, 4, 0), 0.6),
    ((0, -2, 3), (0, 4, 0), (4, 0, 0), 0.8),
)
WALL_WITH_WINDOW = 4


def in_window(points):
    """Which points of the wall x = 4 lie in the window."""
    (y0, y1), (z0, z1) = WINDOW
    _, y, z = points.T
    return (y0 < y) & (y < y1) & (z0 < z) & (z < z1)


def rectangle(corner, u, v, reflectance, cells, in_room=True, window=False):
    """Squares of two triangles with the cell arrays Reflectance and Room (1 in it, 0 outdoors)."""
    corner, u, v = (np.array(a, dtype=float) for a in (corner, u, v))
    i, j = np.meshgrid(*2 * [np.arange(cells + 1) / cells], indexing="ij")
    points = corner + i.ravel()[:, None] * u + j.ravel()[:, None] * v
    a = (np.arange(cells)[:, None] * (cells + 1) + np.arange(cells)).ravel()
    b = a + cells + 1
    triangles = np.concatenate([np.stack(t, axis=1) for t in ((a, b, b + 1), (a, b + 1, a + 1))])
    normal = np.cross(u, v) / np.linalg.norm(np.cross(u, v))
    if window:
        triangles = triangles[~in_window(points[triangles].mean(axis=1))]
    used, renamed = np.unique(triangles, return_inverse=True)
    renamed = renamed.reshape(-1, 3)
    surface = bodies.to_surface(points[used], np.tile(normal, (len(used), 1)), renamed)
    for name, value in (("Reflectance", reflectance), ("Room", float(in_room))):
        array = numpy_to_vtk(np.full(len(renamed), value), deep=1)
        array.SetName(name)
        surface.GetCellData().AddArray(array)
    return surface


def make_room(black=False):
    """The room and 40 by 40 m of ground before it as one vtkPolyData; black: nothing reflects."""
    share = 0.0 if black else 1.0
    sides = [
        rectangle(c, u, v, share * rho, CELLS, window=i == WALL_WITH_WINDOW)
        for i, (c, u, v, rho) in enumerate(SIDES)
    ]
    ground = rectangle((4, -20, 0), (40, 0, 0), (0, 40, 0), share * GROUND, 40, in_room=False)
    return bodies.appended(*sides, ground)


def points_of(surface):
    """Which points are the room's."""
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    room = vtk_to_numpy(surface.GetCellData().GetArray("Room"))
    belongs = np.zeros(surface.GetNumberOfPoints(), dtype=bool)
    belongs[corners[room == 1.0]] = True
    return belongs


def floor_points():
    """Which points are the floor's: the first ones."""
    return slice(0, (CELLS + 1) ** 2)


def light(surface, **properties):
    """The map of the room, and what the filter says of openings."""
    source, lamp = as_source(surface), simple.Luminaire(**SKY)
    proxy = simple.IlluminationMap(
        Input=source, Luminaires=[lamp], ReflectanceArray="Reflectance", **properties
    )
    proxy.UpdatePipeline()
    result = servermanager.Fetch(proxy)
    for one in (proxy, lamp, source):
        simple.Delete(one)
    if result.GetPointData().GetArray("Illuminance") is None:
        raise RuntimeError("IlluminationMap has failed; its message is above")
    found = IlluminationMap(result, facts_of(result))
    found.facts["Openings"] = "\n".join(line for line in texts(result, "Notes") if "opening" in line)
    return found
