# SPDX-License-Identifier: BSD-3-Clause
"""A coarse cylinder and sphere in nothing but the light that a disk reflects, by each registration.

Figures 5 and 6 of the paper, our own registration, and the exact illuminance by quadrature. Run by
pvbatch: reflecting_disk.py OUTPUT_DIR. Writes two pictures and a table there.
"""

import sys
from pathlib import Path

import numpy as np
from vtk.util.numpy_support import numpy_to_vtk

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent / "common"))

import bodies  # noqa: E402
import tables  # noqa: E402
from accuracy import accuracy, point_areas  # noqa: E402
from illumination import REGISTRATIONS, illuminance_of_seeds, load_plugin  # noqa: E402
from light_from_disk import Disk, Spot, illuminance, spot_on_disk  # noqa: E402

TO_BODIES = np.array([0.16, 0.80, -0.60])
TO_BODIES /= np.linalg.norm(TO_BODIES)
DISK = Disk(centre=-4.0 * TO_BODIES, normal=TO_BODIES, radius=1.4, reflectance=0.8)
# The lamp hangs between disk and bodies and shines at the disk only; a lamp casts no shadow.
SPOT = Spot(position=-2.0 * TO_BODIES, direction=-TO_BODIES, half_angle=34.0, flux=20000.0)
FIGURES = {  # of the paper
    "Exact": "by quadrature",
    "Flat": "Fig. 5",
    "Facet Ratio": "Fig. 6",
    "Vertex Normalised": "ours",
}
PHOTONS = 10_000_000
SEEDS = range(1, 5)


def scene():
    """Bodies that reflect nothing, and the same with the disk after them; cell array Reflectance."""
    black = bodies.appended(bodies.cylinder(), bodies.sphere())
    across = np.cross(DISK.normal, (0.0, 0.0, 1.0))
    across /= np.linalg.norm(across) / DISK.radius
    whole = bodies.appended(black, bodies.disk(DISK.centre, DISK.normal, across, 96, 8))
    reflectance = np.zeros(whole.GetNumberOfCells())
    reflectance[black.GetNumberOfCells() :] = DISK.reflectance
    array = numpy_to_vtk(reflectance, deep=1)
    array.SetName("Reflectance")
    whole.GetCellData().AddArray(array)
    return black, whole


def illumination_maps(whole, points, photons=PHOTONS, seeds=SEEDS):
    """Indirect illuminance (lx) of the first points: registration -> array, one row a seed."""
    return {
        registration: illuminance_of_seeds(
            whole,
            seeds,
            "IlluminanceIndirect",
            ReflectanceArray="Reflectance",
            Photons=photons,
            Registration=registration,
            **SPOT.properties(),
        )[:, :points]
        for registration in REGISTRATIONS
    }


def measured(black, maps):
    """The exact illuminance of the bodies (lx), and how far the maps are from it: name -> Accuracy."""
    exact = illuminance(*bodies.points_and_normals(black), DISK, spot_on_disk(SPOT, DISK))
    areas = point_areas(black)
    return exact, {name: accuracy(values, exact, areas) for name, values in maps.items()}


def main(output):
    """Draws the pictures and writes the table into a folder."""
    from comparison import accuracy_rows, compare  # it renders

    load_plugin()
    black, whole = scene()
    maps = illumination_maps(whole, black.GetNumberOfPoints())
    exact, results = measured(black, maps)
    heading = "Cylinder and sphere in light that a disk reflects"
    tables.write(accuracy_rows(results), output / "reflecting_disk", heading)
    means = {name: values.mean(axis=0) for name, values in maps.items()}
    compare(output / "reflecting_disk.png", heading, black, exact, means, results, FIGURES)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
