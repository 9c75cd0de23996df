# SPDX-License-Identifier: BSD-3-Clause
"""Fails unless photon map and illumination maps are of the same photons. Needs pvbatch, but no screen.

- On a sphere whose triangles have points of their own the flux of the photons on each triangle is
  that of the Flat map.
- The photons, registered here by the paper's formulas, give the maps Flat and Facet Ratio.
- Compensation takes most of the facets' error away, from the photons' density as from the map.
"""

import numpy as np
from photon_map import DENSITIES, MAPS, PHOTONS, SEEDS, estimates, measured

import bodies
from accuracy import point_areas
from density import Hits
from illumination import load_plugin
from scene import array, coarse_sphere, corners, lit, points, whole_scene

ROUNDING = 1e-6  # of maps in single precision, of the brightest point
GAIN = 2.5  # RMS errors without compensation over those with it, at least
SIGMAS = 2.0  # standard errors by which the errors that are compared may be off


def torn(surface):
    """The surface with three points of its own for each triangle."""
    ids = corners(surface).ravel()
    places, normals = bodies.points_and_normals(surface)
    return bodies.to_surface(places[ids], normals[ids], np.arange(len(ids)).reshape(-1, 3))


def check_facets():
    """Flux on each triangle."""
    sphere = torn(coarse_sphere())
    run = lit(whole_scene(sphere), PHOTONS, Registration="Flat")
    flux = array(run.surface, "Illuminance")[: sphere.GetNumberOfPoints()] * point_areas(sphere)
    of_map = flux.reshape(-1, 3).sum(axis=1)
    hits = Hits(run.photons, sphere)
    of_photons = np.bincount(hits.cells, hits.flux, len(of_map))
    off = np.abs(of_photons - of_map).max() / of_map.max()
    print(f"flux by triangle: {len(hits.flux)} hits, {of_map.sum():.3f} lm, {off:.1e} off at most")
    assert of_map.sum() > 0.0 and off < ROUNDING


def check_registration(sphere):
    """The paper's formulas (1) and (3), here and in the filter."""
    for name, registration in zip(MAPS, ("Flat", "Facet Ratio"), strict=True):
        run = lit(whole_scene(sphere), PHOTONS, Registration=registration)
        of_filter = array(run.surface, "Illuminance")[: sphere.GetNumberOfPoints()]
        off = np.abs(estimates(sphere, run)[name] - of_filter).max() / of_filter.max()
        print(f"{name} by the photon map: {off:.1e} off at most")
        assert of_filter.max() > 0.0 and off < ROUNDING


def check_compensation(sphere):
    """Errors against the exact illuminance, each at its less favourable end."""
    runs = [lit(whole_scene(sphere), PHOTONS, Seed=seed) for seed in SEEDS]
    results = measured(sphere, [estimates(sphere, run) for run in runs])
    for plain, compensated in (MAPS, DENSITIES):
        without, with_it = results[plain], results[compensated]
        print(f"RMS errors, {plain}: {without.rms:.4f}, {compensated}: {with_it.rms:.4f}")
        # Where rms_error is more than rms it is the square's standard error, under the root.
        most = np.hypot(with_it.rms, np.sqrt(SIGMAS) * with_it.rms_error)
        if with_it.rms > with_it.rms_error:
            most = with_it.rms + SIGMAS * with_it.rms_error
        assert without.rms - SIGMAS * without.rms_error > GAIN * most, (without, with_it)


if __name__ == "__main__":
    load_plugin()
    check_facets()
    check_registration(coarse_sphere())
    check_compensation(coarse_sphere())
