# SPDX-License-Identifier: BSD-3-Clause
"""Fails unless the daylight room has the light that it ought to have. Needs pvbatch, but no screen.

The floor of the black room sees a part of the sky and nothing else, which quadrature gives: CIE's
traditional overcast sky has the luminance L_z (1 + 2 sin(altitude)) / 3 (CIE S 011, sky 16), and
open level ground gets 7 pi / 9 of L_z.
"""

import daylight_room
import numpy as np
from accuracy import point_areas
from illumination import load_plugin
from scene import CELLS, OUTDOORS, WINDOW, floor_points, light, make_room, points_of

import bodies

STRIPS = 160  # of the window, each way
SIGMAS = 5.0
SEEDS = range(1, 9)
BLUR = 0.004  # of the light: what cells blur, which no error bar holds (up to 0.3 %: GatheringAccuracy.md)
CLEAR = 0.4  # m from the wall with the window: where quadrature is exact enough


def quadrature(points):
    """Illuminance (lx) of level points inside by the sky that they see through the window."""
    zenith = OUTDOORS * 9.0 / (7.0 * np.pi)
    (y0, y1), (z0, z1) = WINDOW
    share = (np.arange(STRIPS) + 0.5) / STRIPS
    y, z = (low + (high - low) * share for low, high in ((y0, y1), (z0, z1)))
    area = (y1 - y0) * (z1 - z0) / STRIPS**2
    lux = np.empty(len(points))
    for i, point in enumerate(points):
        dx = 4.0 - point[0]
        dy, dz = np.meshgrid(y - point[1], z - point[2])
        square = dx**2 + dy**2 + dz**2
        sine = dz / np.sqrt(square)  # of the altitude; also the cosine at the floor
        solid_angle = area * dx / square**1.5
        lux[i] = np.sum(zenith * (1.0 + 2.0 * sine) / 3.0 * sine * solid_angle)
    return lux


def check_sky():
    """The black room's floor against quadrature: as exact as the filter says."""
    surface = make_room(black=True)
    found = light(surface, Method="Final Gathering")
    points, _ = bodies.points_and_normals(surface)
    inside = points[floor_points()]
    seen = inside[:, 0] < 4.0 - CLEAR
    exact = quadrature(inside[seen])
    off = found.array()[floor_points()][seen] - exact
    told = found.array("StandardError")[floor_points()][seen]
    ratio = np.sqrt(np.mean(off**2) / np.mean(told**2))
    mean, noise = off.mean() / exact.mean(), np.sqrt(np.mean(told**2) / len(off)) / exact.mean()
    print(f"black room: {100 * mean:.2f} % off in the mean, noise {100 * noise:.2f} %;"
          f" RMS error over told error {ratio:.2f}")  # fmt: skip
    assert abs(mean) < SIGMAS * noise
    assert ratio < 1.5


def mean_on_floor(surface, **properties):
    """Mean illuminance of the floor (lx) by SEEDS, and its standard error."""
    floor = floor_points()
    areas = point_areas(surface)[floor]
    maps = [light(surface, Seed=seed, **properties).array()[floor] for seed in SEEDS]
    means = np.average(maps, axis=1, weights=areas)
    return means.mean(), means.std(ddof=1) / np.sqrt(len(means))


def check_target():
    """The run ends where the room's noise, not the ground's, is what was asked for."""
    surface = make_room()
    found = daylight_room.to_target(surface)
    areas = point_areas(surface) * points_of(surface)
    told = np.sqrt(np.average(found.array("StandardError") ** 2, weights=areas))
    told /= np.average(found.array(), weights=areas)
    print(f"{found.facts['Openings']}; stopped by {found.facts['StoppedBy']} at {100 * told:.2f} %")
    assert "openings used: 1 " in found.facts["Openings"]
    assert found.facts["StoppedBy"] == "target relative error"
    assert told <= daylight_room.TARGET


def between_points(surface):
    """By how much the mean of the sky's light on the floor exceeds that of its values at the points (lx).

    Photons tell the first, the second pass tells the values at the points.
    """
    points, _ = bodies.points_and_normals(surface)
    at_points = np.average(quadrature(points[floor_points()]), weights=point_areas(surface)[floor_points()])
    share = (np.arange(2 * CELLS) + 0.5) / (2 * CELLS)
    x, y = np.meshgrid(4.0 * share, 4.0 * share - 2.0)
    return quadrature(np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1)).mean() - at_points


def check_methods():
    """The floor's mean by both methods."""
    surface = make_room()
    gathered, rays = mean_on_floor(surface, Method="Final Gathering", Photons=100_000)
    gathered += between_points(surface)
    traced, noise = mean_on_floor(surface, Photons=1_000_000)
    print(f"floor: {gathered:.2f} +- {rays:.2f} lx gathered, {traced:.2f} +- {noise:.2f} lx traced")
    assert abs(gathered - traced) < SIGMAS * np.hypot(noise, rays) + BLUR * traced


if __name__ == "__main__":
    load_plugin()
    check_sky()
    check_target()
    check_methods()
