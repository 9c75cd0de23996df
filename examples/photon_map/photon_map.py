# SPDX-License-Identifier: BSD-3-Clause
"""A photon map beside the illumination maps of the same photons.

A coarse sphere in nothing but the light that a disk reflects. The density of the photons on it gives
the illuminance of its points, without compensation for its flat facets and with it. Run by pvbatch:
photon_map.py OUTPUT_DIR. Writes a picture and a table there.
"""

import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), *(str(HERE.parent / name) for name in ("common", "reflecting_disk"))]

import tables  # noqa: E402
from accuracy import accuracy, point_areas  # noqa: E402
from density import Hits, density  # noqa: E402
from illumination import load_plugin  # noqa: E402
from scene import coarse_sphere, exact_illuminance, lit, points, whole_scene  # noqa: E402

PHOTONS = 409_600  # a run; about one of nine hits the sphere
PATHS = 300
SEEDS = range(1, 9)
NEAREST, WITHIN = 200, 0.1  # photons; m
MAPS = ("Flat map", "Facet Ratio map")
DENSITIES = ("Photon density", "Compensated density")


def estimates(sphere, run):
    """Illuminance (lx) of the sphere's points by one run's photons in four ways: name -> array."""
    hits = Hits(run.photons, sphere)
    factors = [np.ones(len(hits.flux)), hits.compensation()]
    count, areas = sphere.GetNumberOfPoints(), point_areas(sphere)
    found = {
        name: hits.registered(count, factor) / areas
        for name, factor in zip(MAPS, factors)
    }
    by_density = density(points(sphere), hits, NEAREST, WITHIN, factors)
    found.update(zip(DENSITIES, by_density))
    return found


def measured(sphere, by_run):
    """Accuracy of each way: name -> Accuracy. by_run: what estimates() gives for each run."""
    exact, areas = exact_illuminance(sphere), point_areas(sphere)
    return {
        name: accuracy(np.array([found[name] for found in by_run]), exact, areas)
        for name in by_run[0]
    }


def main(output):
    """Draws the picture and writes the table into a folder."""
    from comparison import accuracy_rows  # it renders, which check.py need not
    from figure import draw_photon_map

    load_plugin()
    sphere = coarse_sphere()
    runs = [lit(whole_scene(sphere), PHOTONS, PATHS, Seed=seed) for seed in SEEDS]
    by_run = [estimates(sphere, run) for run in runs]
    results = measured(sphere, by_run)
    rows = [{"Illuminance by": row.pop("Registration"), **row} for row in accuracy_rows(results)]
    tables.write(rows, output / "photon_map", "A coarse sphere by the same photons in four ways")
    draw_photon_map(output / "photon_map.png", sphere, runs[0], by_run[0], results)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
