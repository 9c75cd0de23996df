# SPDX-License-Identifier: BSD-3-Clause
"""A coarse cylinder and sphere under parallel light, by each registration and exactly.

Figures 2 to 4 of the paper, and our own registration. Run by pvbatch: cylinder_and_sphere.py
OUTPUT_DIR. Writes two pictures and a table there.
"""

import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "common"))

import bodies  # noqa: E402
import tables  # noqa: E402
from accuracy import accuracy, point_areas  # noqa: E402
from illumination import REGISTRATIONS, illuminance_of_seeds, load_plugin  # noqa: E402

DIRECTION = np.array([0.40, 0.70, -0.60])  # in which the light travels: neither body shades the other
DIRECTION /= np.linalg.norm(DIRECTION)
ILLUMINANCE = 1000.0  # lx, where the light arrives at a right angle
FIGURES = {  # of the paper
    "Exact": "Phong shading, Fig. 3",
    "Flat": "Fig. 2",
    "Facet Ratio": "Fig. 4",
    "Vertex Normalised": "ours",
}
PHOTONS = 4_000_000
SEEDS = range(1, 9)


def scene():
    """Both bodies as one vtkPolyData."""
    return bodies.appended(bodies.cylinder(), bodies.sphere())


def exact_illuminance(surface):
    """E = E0 max(n . l, 0) with the exact normals (lx): what Phong shading shows."""
    _, normals = bodies.points_and_normals(surface)
    return ILLUMINANCE * np.maximum(-normals @ DIRECTION, 0.0)


def illumination_maps(surface, photons=PHOTONS, seeds=SEEDS):
    """Illuminance (lx) by every registration: name -> array, one row a seed."""
    return {
        registration: illuminance_of_seeds(
            surface,
            seeds,
            LampType="Parallel",
            LampDirection=DIRECTION.tolist(),
            ParallelIlluminance=ILLUMINANCE,
            Reflectance=0.0,
            Photons=photons,
            Registration=registration,
        )
        for registration in REGISTRATIONS
    }


def measured(surface, maps):
    """Accuracy of every registration's maps: name -> Accuracy."""
    exact, areas = exact_illuminance(surface), point_areas(surface)
    return {name: accuracy(values, exact, areas) for name, values in maps.items()}


def main(output):
    """Draws the pictures and writes the table into a folder."""
    from comparison import accuracy_rows, compare  # it renders, which check.py need not

    load_plugin()
    surface = scene()
    maps = illumination_maps(surface)
    results = measured(surface, maps)
    heading = "Cylinder and sphere under parallel light of 1000 lx"
    tables.write(accuracy_rows(results), output / "cylinder_and_sphere", heading)
    means = {name: values.mean(axis=0) for name, values in maps.items()}
    exact = exact_illuminance(surface)
    compare(output / "cylinder_and_sphere.png", heading, surface, exact, means, results, FIGURES)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
