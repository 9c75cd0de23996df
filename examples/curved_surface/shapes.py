# SPDX-License-Identifier: BSD-3-Clause
"""Cylinder, sphere and torus: as coarse meshes, as fine ones, and exactly. Metres, z up."""

from dataclasses import dataclass

import numpy as np

import bodies

NEAR = 1e-6  # m: a ray this close to a body meets it
STEPS = 400  # of a ray at most


@dataclass
class Body:
    """A round body with an axis of symmetry."""

    centre: np.ndarray  # m
    axis: np.ndarray  # unit
    coarse: tuple  # facets around the axis and along its profile
    fine: tuple  # the same for pictures of the exact body

    def frame(self):
        """Two unit vectors across the axis and the axis itself, as columns."""
        across = np.cross(self.axis, (0.31, 0.95, 0.11))
        across /= np.linalg.norm(across)
        return np.stack([across, np.cross(self.axis, across), self.axis], axis=1)

    def profile_distance(self, points):
        """Distance from the axis and height along it of points (n, 3), each (n,)."""
        local = (points - self.centre) @ self.frame()
        return np.hypot(local[:, 0], local[:, 1]), local[:, 2]

    def mesh(self, around, along):
        """A vtkPolyData with the exact normals at its points."""
        points, normals, triangles = self.local_mesh(around, along)
        frame = self.frame()
        return bodies.to_surface(points @ frame.T + self.centre, normals @ frame.T, triangles)


def turned(radius, height, out, up, around, closed):
    """Points, normals and corners of quadrilaterals of a profile (each (m,)) that is turned about z.

    closed: whether the profile's end joins its beginning.
    """
    angle = 2.0 * np.pi * np.arange(around) / around
    cosine, sine = np.cos(angle)[:, None], np.sin(angle)[:, None]
    points = np.stack([cosine * radius, sine * radius, 0.0 * sine + height], axis=-1)
    normals = np.stack([cosine * out, sine * out, 0.0 * sine + up], axis=-1)
    index = np.arange(points.shape[0] * points.shape[1]).reshape(points.shape[:2])
    index = np.concatenate([index, index[:1]])
    if closed:
        index = np.concatenate([index, index[:, :1]], axis=1)
    a, b, c, d = index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]
    return points.reshape(-1, 3), normals.reshape(-1, 3), (a, b, c, d)


def triangles_of(corners):
    """The two triangles of every quadrilateral, counterclockwise from outside."""
    a, b, c, d = (side.ravel() for side in corners)
    return np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])


@dataclass
class Sphere(Body):
    """Its poles are single points."""

    radius: float

    def distance(self, points):
        """To the surface, negative inside."""
        return np.linalg.norm(points - self.centre, axis=1) - self.radius

    def local_mesh(self, around, along):
        """Points, normals and triangles about the origin."""
        angle = np.pi * np.arange(1, along) / along - 0.5 * np.pi
        out, up = np.cos(angle), np.sin(angle)
        points, normals, corners = turned(out, up, out, up, around, closed=False)
        south = len(points)
        first = np.arange(around) * (along - 1)
        following, last = np.roll(first, -1), along - 2
        caps = [
            np.stack([np.full(around, south), following, first], axis=1),
            np.stack([np.full(around, south + 1), first + last, following + last], axis=1),
        ]
        poles = [(0.0, 0.0, -1.0), (0.0, 0.0, 1.0)]
        points, normals = (np.concatenate([values, poles]) for values in (points, normals))
        return self.radius * points, normals, np.concatenate([triangles_of(corners), *caps])

    def elements(self, around, along):
        """Points, normals and areas for integrals over the exact surface."""
        height = (2.0 * np.arange(along) + 1.0) / along - 1.0
        out = np.sqrt(1.0 - height**2)
        points, normals, _ = turned(out, height, out, height, around, closed=False)
        area = np.full(len(points), 4.0 * np.pi * self.radius**2 / len(points))
        return self.radius * points, normals, area


@dataclass
class Torus(Body):
    """A ring of round cross-section."""

    radius: float  # of the circle in the middle of the tube
    tube: float  # radius of the tube

    def distance(self, points):
        """To the surface, negative inside."""
        out, up = self.profile_distance(points)
        return np.hypot(out - self.radius, up) - self.tube

    def ring(self, around, along, shift):
        """What turned() makes, and distances from the axis."""
        angle = 2.0 * np.pi * (np.arange(along) + shift) / along
        out, up = np.cos(angle), np.sin(angle)
        radius = self.radius + self.tube * out
        return turned(radius, self.tube * up, out, up, around, closed=True), radius

    def local_mesh(self, around, along):
        """Points, normals and triangles about the origin."""
        (points, normals, corners), _ = self.ring(around, along, 0.0)
        return points, normals, triangles_of(corners)

    def elements(self, around, along):
        """Points, normals and areas for integrals over the exact surface."""
        (points, normals, _), radius = self.ring(around, along, 0.5)
        area = (2.0 * np.pi) ** 2 * self.tube * np.tile(radius, around) / len(points)
        return points, normals, area


@dataclass
class Cylinder(Body):
    """Its ends are flat and have points of their own."""

    radius: float
    half: float  # height

    def distance(self, points):
        """To the surface, negative inside."""
        out, up = self.profile_distance(points)
        out, up = out - self.radius, np.abs(up) - self.half
        outside = np.hypot(np.maximum(out, 0.0), np.maximum(up, 0.0))
        return outside + np.minimum(np.maximum(out, up), 0.0)

    def side(self, around, heights):
        """What turned() makes of the side."""
        one = np.ones(len(heights))
        return turned(self.radius * one, heights, one, 0.0 * one, around, closed=False)

    def local_mesh(self, around, along):
        """Points, normals and triangles about the origin."""
        points, normals, corners = self.side(around, self.half * np.linspace(-1.0, 1.0, along + 1))
        triangles = triangles_of(corners)
        for sign in (1.0, -1.0):
            across = np.array([self.radius, 0.0, 0.0])
            end = bodies.disk((0.0, 0.0, sign * self.half), (0.0, 0.0, sign), across, around, 3)
            more = bodies.vtk_to_numpy(end.GetPolys().GetConnectivityArray()).reshape(-1, 3)
            triangles = np.concatenate([triangles, len(points) + more])
            of_end = bodies.points_and_normals(end)
            points, normals = (np.concatenate(p) for p in zip((points, normals), of_end))
        return points, normals, triangles

    def elements(self, around, along):
        """Points, normals and areas for integrals over the exact surface."""
        middle = (np.arange(along) + 0.5) / along
        points, normals, _ = self.side(around, self.half * (2.0 * middle - 1.0))
        parts = [(points, normals, 4.0 * np.pi * self.radius * self.half)]
        radius, one = self.radius * np.sqrt(middle), np.ones(along)
        for sign in (1.0, -1.0):
            height, up = sign * self.half * one, sign * one
            points, normals, _ = turned(radius, height, 0.0 * one, up, around, closed=False)
            parts.append((points, normals, np.pi * self.radius**2))
        area = np.concatenate([np.full(len(p), total / len(p)) for p, _, total in parts])
        return *(np.concatenate([part[i] for part in parts]) for i in (0, 1)), area


def unshaded(starts, lamp, shapes):
    """Whether light of a point-like lamp gets to points (n, 3) past bodies: (n,), by sphere tracing."""
    way = lamp - starts
    length = np.linalg.norm(way, axis=1)
    way = way / length[:, None]
    free = np.ones(len(starts), dtype=bool)
    done = np.zeros(len(starts))
    active = np.arange(len(starts))
    for _ in range(STEPS):
        at = starts[active] + done[active, None] * way[active]
        step = np.min([shape.distance(at) for shape in shapes], axis=0)
        free[active[step < NEAR]] = False
        done[active] += step
        active = active[(step >= NEAR) & (done[active] < length[active])]
        if len(active) == 0:
            break
    return free


def illuminance(points, normals, lamp, flux, shapes):
    """Exact illuminance (lx) at points (n, 3) with unit normals, by a lamp of so many lm."""
    way = lamp - points
    length = np.linalg.norm(way, axis=1)
    cosine = np.einsum("ij,ij->i", way, normals) / length
    lit = np.flatnonzero(cosine > 0.0)
    free = unshaded(points[lit] + 10.0 * NEAR * normals[lit], lamp, shapes)
    values = np.zeros(len(points))
    values[lit] = free * flux / (4.0 * np.pi) * cosine[lit] / length[lit] ** 2
    return values
