# SPDX-License-Identifier: BSD-3-Clause
"""Illuminance by a spot lamp's light after one diffuse reflection from a disk, by quadrature."""

from dataclasses import dataclass

import numpy as np


@dataclass
class Disk:
    """A flat diffuse reflector; lengths in m."""

    centre: np.ndarray
    normal: np.ndarray  # unit vector, on the side that is lit
    radius: float
    reflectance: float


@dataclass
class Spot:
    """A lamp of even intensity within a cone."""

    position: np.ndarray  # m
    direction: np.ndarray  # unit vector
    half_angle: float  # degrees
    flux: float  # lm

    def properties(self):
        """Of Illumination Map, whose own lamp it is."""
        return {"LampType": "Spot", "LampPosition": self.position.tolist(), "LampDirection": self.direction.tolist(),
                "SpotHalfAngle": self.half_angle, "LuminousFlux": self.flux}


def spot_on_disk(spot, disk, rings=96, spokes=192):
    """Where equal shares of the spot's flux land on the disk: points (n, 3), flux of each (n,), lm.

    Gauss-Legendre in the cosine from the axis, even steps around it.
    """
    node, weight = np.polynomial.legendre.leggauss(rings)
    cosine_at_edge = np.cos(np.radians(spot.half_angle))
    cosine = 0.5 * (1.0 + cosine_at_edge) + 0.5 * (1.0 - cosine_at_edge) * node
    angle = 2.0 * np.pi * (np.arange(spokes) + 0.5) / spokes
    u = np.cross(spot.direction, np.eye(3)[np.argmin(np.abs(spot.direction))])
    u /= np.linalg.norm(u)
    v = np.cross(spot.direction, u)
    around = np.cos(angle)[:, None] * u + np.sin(angle)[:, None] * v
    sine = np.sqrt(1.0 - cosine**2)
    rays = cosine[:, None, None] * spot.direction + sine[:, None, None] * around
    rays = rays.reshape(-1, 3)
    distance = (disk.centre - spot.position) @ disk.normal / (rays @ disk.normal)
    landed = spot.position + distance[:, None] * rays
    reach = np.linalg.norm(landed - disk.centre, axis=1).max()
    assert (distance > 0.0).all() and reach < disk.radius, f"the cone reaches to {reach:.3f} m"
    return landed, np.repeat(0.5 * weight * spot.flux / spokes, spokes)


def illuminance(points, normals, disk, light):
    """Illuminance (lx) of points with normals by what the disk reflects of light on it.

    light: points on the disk and the flux (lm) that arrives at each. What is behind the horizon of
    a point's own normal is cut off; nothing else may stand in the way.
    """
    landed, flux = light
    result = np.empty(len(points))
    for i, (point, normal) in enumerate(zip(points, normals)):
        ray = landed - point
        square = np.einsum("ij,ij->i", ray, ray)
        at_point = np.maximum(ray @ normal, 0.0)
        at_disk = np.maximum(-ray @ disk.normal, 0.0)
        result[i] = np.sum(flux * at_point * at_disk / square**2)
    return disk.reflectance / np.pi * result
