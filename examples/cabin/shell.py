# SPDX-License-Identifier: BSD-3-Clause
"""The cabin's closed shell: floor, side walls with windows, bins, coves, ceiling, bulkheads. Metres."""

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

import profiles
from mesh import bent, grid, merged, mirrored, moved, oriented, welded

WINDOW_PITCH = 1.6 / 3.0  # distance of the fuselage's frames: three windows to two seat rows
BAY_SEGMENTS = 6  # along each side of a window's bay
OPENING = (0.145, 0.205)  # half width and half height of the niche at the lining
NICHE_DEPTH = 0.075
FILLET = 0.025  # radius of the niche's rounded edge
TAPER = 0.035  # by how much the pane is smaller than the opening, each side


def extruded(curve, xs):
    """The surface that a curve of the cross-section sweeps along x."""
    count, stations = len(curve.points), len(xs)
    points = np.empty((stations, count, 3))
    points[..., 0] = xs[:, None]
    points[..., 1:] = curve.points
    normals = np.zeros((stations, count, 3))
    normals[..., 1:] = curve.normals
    return grid(points, normals)


def onto_wall(flat):
    """Where a point (x, height, depth behind the wall) of an even wall lies on the curved one."""
    x, z, depth = flat.T
    y = profiles.wall_y(z)
    height = (z - profiles.WALL_Z) / profiles.WALL_B
    out = np.stack(
        [(y / profiles.WALL_A) ** 2 / profiles.WALL_A, height * np.abs(height) / profiles.WALL_B]
    )
    out /= np.linalg.norm(out, axis=0)
    return np.stack([x, y + depth * out[0], z + depth * out[1]], axis=1)


def bay_rim():
    """Points round the rim of a window's bay, relative to its centre; (n, 2), m."""
    t = np.linspace(-1.0, 1.0, BAY_SEGMENTS + 1)[:-1]
    one = np.ones_like(t)
    sides = [np.stack(s, axis=1) for s in ((t, -one), (one, t), (-t, one), (-one, -t))]
    height = profiles.WINDOW_TOP - profiles.WINDOW_BOTTOM
    return np.concatenate(sides) * [WINDOW_PITCH / 2.0, height / 2.0]


def opening(rim, inset):
    """The rounded rectangle of the niche, inset (m) from OPENING: points and normals to its centre."""
    axes = np.asarray(OPENING) - inset
    towards = rim / (np.sum(np.abs(rim / axes) ** 4, axis=1) ** 0.25)[:, None]
    normals = -np.sign(towards) * np.abs(towards / axes) ** 3 / axes
    return towards, normals / np.linalg.norm(normals, axis=1, keepdims=True)


def _rings(outlines):
    """A Mesh through rings, each given as (points (n, 2), depth, normals (n, 3))."""
    points = np.stack([np.column_stack([p, np.full(len(p), d)]) for p, d, _ in outlines])
    return grid(points, np.stack([n for _, _, n in outlines]), closed=True)


def window():
    """One window's bay on an even wall, centred: lining, niche, pane; (x, height, depth), m."""
    rim = bay_rim()
    hole, inward = opening(rim, 0.0)
    to_air = np.tile([0.0, 0.0, -1.0], (len(rim), 1))
    sideways = np.column_stack([inward, np.zeros(len(rim))])
    lining = _rings([((1.0 - t) * rim + t * hole, 0.0, to_air) for t in (0.0, 0.4, 0.75, 1.0)])
    niche = []
    steep = np.arctan2(NICHE_DEPTH - FILLET, TAPER - FILLET)
    for angle in np.linspace(0.0, steep, 4):
        inset, depth = FILLET * np.sin(angle), FILLET * (1.0 - np.cos(angle))
        normals = np.cos(angle) * to_air + np.sin(angle) * sideways
        niche.append((opening(rim, inset)[0], depth, normals))
    pane_edge = opening(rim, TAPER)[0]
    niche.append((pane_edge, NICHE_DEPTH, niche[-1][2]))
    pane = _rings([(t * pane_edge, NICHE_DEPTH, to_air) for t in (1.0, 0.55)])
    middle = _fan(0.55 * pane_edge, NICHE_DEPTH)
    return {"Side walls": lining, "Window niches": _rings(niche), "Window panes": merged([pane, middle])}


def _fan(outline, depth):
    """The disk inside an outline (n, 2) at a depth (m)."""
    count = len(outline)
    points = np.vstack([np.column_stack([outline, np.full(count, depth)]), [[0.0, 0.0, depth]]])
    normals = np.tile([0.0, 0.0, -1.0], (count + 1, 1))
    ring = np.arange(count)
    triangles = np.stack([ring, np.roll(ring, -1), np.full(count, count)], axis=1)
    return oriented(points, normals, triangles)


def window_row(windows):
    """All windows of the right side: part name -> Mesh."""
    middle = (profiles.WINDOW_BOTTOM + profiles.WINDOW_TOP) / 2.0
    parts = {}
    for name, mesh in window().items():
        bays = [moved(mesh, ((i + 0.5) * WINDOW_PITCH, middle, 0.0)) for i in range(windows)]
        parts[name] = bent(merged(bays), onto_wall)
    return parts


def outline():
    """The whole cross-section as one closed polygon (n, 2), floor first, counterclockwise."""
    right = [
        profiles.wall(0.0, profiles.WINDOW_BOTTOM, 8),
        profiles.wall(profiles.WINDOW_BOTTOM, profiles.WINDOW_TOP, BAY_SEGMENTS),
        profiles.wall(profiles.WINDOW_TOP, profiles.BIN_UNDERSIDE, 3),
        profiles.overhead_bin(),
        profiles.shelf(),
        profiles.lamp(),
        profiles.ledge(),
    ]
    half = np.concatenate([c.points[:-1] for c in right])
    ceiling = profiles.ceiling().points
    floor = profiles.floor().points[1:-1][::-1]
    return np.concatenate([half, ceiling, half[::-1] * [-1.0, 1.0], floor])


def inside_polygon(points, polygon):
    """Which points (n, 2) lie inside a closed polygon (m, 2): an odd number of edges to their right."""
    x, y = points[:, None].transpose(2, 0, 1)
    (x0, y0), (x1, y1) = polygon.T, np.roll(polygon, -1, axis=0).T
    spans = (y0 > y) != (y1 > y)
    with np.errstate(divide="ignore", invalid="ignore"):
        right = x < x0 + (y - y0) / (y1 - y0) * (x1 - x0)
    return np.count_nonzero(spans & right, axis=1) % 2 == 1


def bulkhead(x, facing, spacing=0.08):
    """The wall that closes the cabin at x (m); its normal is (facing, 0, 0); cells of spacing (m).

    Triangulates the rim with a lattice inside and outside of it, then keeps the inside. No point lies
    in the circle that has an edge of the rim for its diameter, so every such edge is an edge of a
    Delaunay triangle: no gap at the rim.
    """
    rim = outline()
    following = np.roll(rim, -1, axis=0)
    reach = np.maximum(0.55 * np.linalg.norm(following - rim, axis=1), 0.5 * spacing)
    y, z = np.meshgrid(np.arange(-2.2, 2.2, spacing), np.arange(-0.4, 2.8, spacing))
    lattice = np.stack([y.ravel(), z.ravel()], axis=1)
    gap = np.linalg.norm(lattice[:, None] - 0.5 * (rim + following), axis=2)
    points = np.vstack([rim, lattice[(gap > reach).all(axis=1)]])
    flat = vtk.vtkPolyData()
    flat.SetPoints(vtk.vtkPoints())
    flat.GetPoints().SetData(numpy_to_vtk(np.column_stack([points, np.zeros(len(points))]), deep=1))
    fill = vtk.vtkDelaunay2D()
    fill.SetInputData(flat)
    fill.Update()
    triangles = vtk_to_numpy(fill.GetOutput().GetPolys().GetConnectivityArray()).reshape(-1, 3)
    triangles = triangles[inside_polygon(points[triangles].mean(axis=1), rim)]
    used, triangles = np.unique(triangles, return_inverse=True)
    points = np.column_stack([np.full(len(used), x), points[used]])
    normals = np.tile([float(facing), 0.0, 0.0], (len(points), 1))
    return oriented(points, normals, triangles.reshape(-1, 3))


def shell(windows):
    """The closed shell, windows bays long: part name -> Mesh. Light gets in at "Cove lamps" only."""
    xs = np.linspace(0.0, windows * WINDOW_PITCH, windows * BAY_SEGMENTS + 1)
    right = {
        "Overhead bins": extruded(profiles.overhead_bin(), xs),
        "Coves": merged([extruded(profiles.shelf(), xs), extruded(profiles.ledge(), xs)]),
        "Cove lamps": extruded(profiles.lamp(), xs),
        **window_row(windows),
    }
    lower = extruded(profiles.wall(0.0, profiles.WINDOW_BOTTOM, 8), xs)
    upper = extruded(profiles.wall(profiles.WINDOW_TOP, profiles.BIN_UNDERSIDE, 3), xs)
    right["Side walls"] = welded(merged([lower, right["Side walls"], upper]))
    parts = {name: merged([mesh, mirrored(mesh)]) for name, mesh in right.items()}
    parts["Floor"] = extruded(profiles.floor(), xs)
    parts["Ceiling"] = extruded(profiles.ceiling(), xs)
    parts["Bulkheads"] = merged([bulkhead(xs[0], 1.0), bulkhead(xs[-1], -1.0)])
    return parts
