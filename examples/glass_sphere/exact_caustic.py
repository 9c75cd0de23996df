# SPDX-License-Identifier: BSD-3-Clause
"""Illuminance below a smooth glass sphere in parallel light from above, by following rays on paper.

A ray that arrives at the angle a to the normal, a' inside, meets the sphere again after every
further pi - 2 a' about the centre, and leaves each time at the angle a: Descartes' rays of the
rainbow. Lengths in m.
"""

from dataclasses import dataclass

import numpy as np

RAYS = 200_000  # of equal flux, that meet the sphere
NEGLIGIBLE = 1e-6  # share of the sphere's flux that is left inside when the rays end


@dataclass
class Sphere:
    """A clear body whose centre is so high above the floor."""

    radius: float
    height: float
    index: float  # refractive


@dataclass
class Rings:
    """A floor's vertices: its centre, and regular polygons around it of as many sides each."""

    radii: np.ndarray  # of the vertices; the first is 0
    sides: int

    def areas(self):
        """Of every ring, in m2: a third of the area of all triangles around its vertices."""
        middle = self.radii * np.cos(np.pi / self.sides)  # of the sides
        width = np.diff(middle)
        inner, outer = middle[:-1], middle[1:]
        round_it = 2.0 * self.sides * np.tan(np.pi / self.sides)  # perimeter over middle
        areas = np.zeros(len(middle))
        areas[:-1] += round_it * width * (inner / 2.0 + width / 6.0)
        areas[1:] += round_it * width * (outer / 2.0 - width / 6.0)
        return areas

    def collect(self, reach, flux):
        """Flux that each ring registers of light that lands so far (reach) from the axis, evenly.

        Barycentric coordinates share it out: linearly in the distance, as sides are parallel.
        """
        middle = self.radii * np.cos(np.pi / self.sides)
        reach = reach * np.sinc(1.0 / self.sides)  # mean of reach * cosine along half a side
        lands = reach < middle[-1]
        reach, flux = reach[lands], flux[lands]
        ring = np.searchsorted(middle, reach, side="right") - 1
        beyond = (reach - middle[ring]) / np.diff(middle)[ring]
        count = len(middle)
        return np.bincount(ring, flux * (1.0 - beyond), count) + np.bincount(
            ring + 1, flux * beyond, count
        )


def fresnel(arriving, refracted):
    """Reflectance for unpolarised light (Born and Wolf, "Principles of Optics", 1.5.2)."""
    s = np.sin(arriving - refracted) / np.sin(arriving + refracted)
    p = np.tan(arriving - refracted) / np.tan(arriving + refracted)
    return 0.5 * (s**2 + p**2)


def landings(sphere, rays=RAYS):
    """What the sphere sends to the floor: distances from the axis (m) and shares of the flux that
    meets the sphere. One pair for light reflected outside, then one for each number of ways inside.

    Light that leaves upwards never lands.
    """
    square = (np.arange(rays) + 0.5) / rays  # of the offset from the axis in radii: equal areas
    arriving = np.arcsin(np.sqrt(square))
    refracted = np.arcsin(np.sqrt(square) / sphere.index)  # Snell's law
    reflected = fresnel(arriving, refracted)
    about = arriving  # where it leaves: angle about the centre, from the top
    leaving, inside = reflected / rays, (1.0 - reflected) / rays
    while True:
        direction = about + arriving  # angle from straight up
        lands = np.cos(direction) < -1e-9
        fall = sphere.height + sphere.radius * np.cos(about[lands])
        reach = sphere.radius * np.sin(about[lands]) - fall * np.tan(direction[lands])
        yield np.abs(reach), leaving[lands]
        if inside.sum() < NEGLIGIBLE:
            return
        about = about + np.pi - 2.0 * refracted
        leaving, inside = inside * (1.0 - reflected), inside * reflected


def ring_fluxes(sphere, rings, illuminance, rays=RAYS):
    """What each ring of a floor registers, in lm, if the light alone would give so many lx."""
    met = illuminance * np.pi * sphere.radius**2
    shadow = sphere.radius * np.sqrt((np.arange(rays) + 0.5) / rays)
    fluxes = illuminance * rings.areas() - rings.collect(shadow, np.full(rays, met / rays))
    for reach, share in landings(sphere, rays):
        fluxes += rings.collect(reach, met * share)
    return fluxes
