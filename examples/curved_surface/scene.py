# SPDX-License-Identifier: BSD-3-Clause
"""The scene: a floor, and above it a cylinder, a sphere and a torus near a lamp. Metres, z up."""

from dataclasses import dataclass

import numpy as np

import bodies
from illumination import as_source, illuminate
from paraview import servermanager, simple
from shapes import Cylinder, Sphere, Torus, illuminance, triangles_of

LAMP = np.array([0.0, 0.0, 1.75])  # it shines evenly to all sides
FLUX = 4.0 * np.pi * 1000.0  # lm: 1000 lx at a distance of 1 m
# About the lamp's foot. The torus leans towards the lamp, so that its near side shades its far one.
SHAPES = {
    "Cylinder": Cylinder(
        np.array([-0.85, 0.35, 0.60]), np.array([0.0, 0.0, 1.0]), (8, 6), (192, 48), 0.34, 0.40),
    "Sphere": Sphere(np.array([0.0, 0.90, 0.75]), np.array([0.0, 0.0, 1.0]), (16, 8), (128, 64), 0.42),
    "Torus": Torus(
        np.array([0.90, 0.35, 0.68]), np.array([-0.10, -0.55, 0.83]), (24, 8), (192, 64), 0.36, 0.144),
}  # fmt: skip
for _shape in SHAPES.values():
    _shape.axis /= np.linalg.norm(_shape.axis)
LOW, HIGH, STEP = np.array([-2.6, -0.9]), np.array([2.6, 2.9]), 0.025  # m, the floor's grid
BAND = 0.06  # m: half the width of the band about the shadows' outlines
SAMPLES = 8  # along each side of a square of the floor, where the exact light is not even
PHOTONS = 4_000_000
SEEDS = range(1, 5)
MODES = {"Facets as they are": 0, "CurvedSurface": 1}


def grid_shape():
    """The floor's points along x and y."""
    return tuple(np.rint((HIGH - LOW) / STEP).astype(int) + 1)


def floor():
    """A finely meshed floor at z = 0 as a vtkPolyData."""
    count = grid_shape()
    x, y = (low + STEP * np.arange(n) for low, n in zip(LOW, count))
    points = np.stack([*np.meshgrid(x, y, indexing="ij"), np.zeros(count)], axis=-1).reshape(-1, 3)
    index = np.arange(count[0] * count[1]).reshape(count)
    corners = index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]
    return bodies.to_surface(points, np.tile((0.0, 0.0, 1.0), (len(points), 1)), triangles_of(corners))


def coarse_bodies():
    """The coarse meshes as one vtkPolyData, in the order of SHAPES."""
    return bodies.appended(*(shape.mesh(*shape.coarse) for shape in SHAPES.values()))


def light(surface, curved, photons=PHOTONS, seed=1):
    """The direct illumination of a vtkPolyData, by the facets or by the curved surface."""
    return illuminate(
        surface,
        LampType="Point",
        LampPosition=LAMP.tolist(),
        LuminousFlux=FLUX,
        Reflectance=0.0,
        CurvedSurface=curved,
        Photons=photons,
        Seed=seed,
    )


def refined(surface, **properties):
    """What Surface Refinement makes of a vtkPolyData."""
    source = as_source(surface)
    proxy = simple.SurfaceRefinement(Input=source, **properties)
    proxy.UpdatePipeline()
    result = servermanager.Fetch(proxy)
    simple.Delete(proxy)
    simple.Delete(source)
    return result


@dataclass
class ExactFloor:
    """What the exact bodies do to the floor's points."""

    lux: np.ndarray  # mean illuminance around each point, weighted as the filter's map is
    band: np.ndarray  # whether a point is within BAND of the outline of a shadow


def around(marks, steps):
    """Points of a grid that have a mark so many points away at most, along both its sides."""
    for axis in (0, 1):
        reach = [np.roll(marks, shift, axis) for shift in range(-steps, steps + 1)]
        marks = np.logical_or.reduce(reach)
    return marks


def exact_floor(surface):
    """ExactFloor of floor(): the mean light of the triangles around each point, by barycentric weight.

    Light is sampled at the middles of small triangles, SAMPLES^2 in each of the floor's, where it is not even.
    """
    points, normals = bodies.points_and_normals(surface)
    shapes = list(SHAPES.values())
    at_points = illuminance(points, normals, LAMP, FLUX, shapes)
    dark = (at_points == 0.0).reshape(grid_shape())
    change = np.zeros_like(dark)
    change[1:] |= dark[1:] != dark[:-1]
    change[:, 1:] |= dark[:, 1:] != dark[:, :-1]
    corners = bodies.vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    near = around(change, 2).ravel()
    mixed = corners[near[corners].any(axis=1)]
    weights = small_triangles(SAMPLES)
    samples = np.einsum("kc,mcx->mkx", weights, points[mixed]).reshape(-1, 3)
    up = np.tile((0.0, 0.0, 1.0), (len(samples), 1))
    lux = illuminance(samples, up, LAMP, FLUX, shapes).reshape(len(mixed), -1)
    share = 3.0 * lux @ weights / len(weights)  # of each corner: mean by its weight
    total = np.bincount(mixed.ravel(), share.ravel(), len(points))
    number = np.bincount(mixed.ravel(), minlength=len(points))
    inside = around(change, 1).ravel() & (number > 0)
    at_points[inside] = total[inside] / number[inside]
    return ExactFloor(at_points, around(change, round(BAND / STEP)).ravel())


def small_triangles(n):
    """Barycentric coordinates (n * n, 3) of the middles of the small triangles in a divided one."""
    i, j = (a.ravel() for a in np.meshgrid(np.arange(n), np.arange(n), indexing="ij"))
    up = (i + j) < n
    down = (i + j) < n - 1
    first = np.concatenate([i[up] + 1.0 / 3.0, i[down] + 2.0 / 3.0]) / n
    second = np.concatenate([j[up] + 1.0 / 3.0, j[down] + 2.0 / 3.0]) / n
    return np.stack([first, second, 1.0 - first - second], axis=1)


def exact_bodies():
    """The exact bodies, finely meshed, with their exact illuminance in lx: name -> (vtkPolyData, lux)."""
    found = {}
    for name, shape in SHAPES.items():
        surface = shape.mesh(*shape.fine)
        points, normals = bodies.points_and_normals(surface)
        points -= shape.distance(points)[:, None] * normals  # from the precision of the file's numbers
        found[name] = surface, illuminance(points, normals, LAMP, FLUX, SHAPES.values())
    return found


def exact_caught(shape, around_it=720, along=360):
    """The flux (lm) that an exact body catches when it is alone."""
    points, normals, area = shape.elements(around_it, along)
    frame = shape.frame()
    lux = illuminance(points @ frame.T + shape.centre, normals @ frame.T, LAMP, FLUX, [shape])
    return float(np.sum(lux * area))
