# SPDX-License-Identifier: BSD-3-Clause
"""The caustic of a glass sphere in parallel light, beside that of the exact smooth sphere.

Run by pvbatch: glass_sphere.py OUTPUT_DIR. Writes a picture and a table there.
"""

import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from paraview import servermanager, simple
from vtk.util.numpy_support import vtk_to_numpy

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "common")]

import bodies  # noqa: E402
import tables  # noqa: E402
from exact_caustic import Rings, Sphere, ring_fluxes  # noqa: E402
from illumination import as_source, facts_of, load_plugin  # noqa: E402

GLASS = Sphere(radius=0.1, height=0.115, index=1.5)
ILLUMINANCE = 1000.0  # lx, where the light arrives at a right angle
# Fine where the caustic is, then wider and wider.
RINGS = Rings(np.concatenate([0.0005 * np.arange(30), np.geomspace(0.015, 0.2, 61)]), sides=180)
COARSE, FINE = 6, 7  # subdivisions of an icosahedron: 82 and 328 thousand triangles
PHOTONS = 2**19  # each run
SEEDS = range(1, 17)
SHOWN = (0.0005, 0.001, 0.002, 0.005, 0.009, 0.0095, 0.01, 0.02, 0.05, 0.1, 0.2)  # m, in the table


@dataclass
class Caustic:
    """The floor's map by independent runs."""

    lux: np.ndarray  # of the floor's points: one row a run
    facts: list  # of each run: its field data of one value each

    def fluxes(self):
        """What each ring registers, in lm: one row a run."""
        around = self.lux[:, 1:].reshape(len(self.lux), -1, RINGS.sides).mean(axis=2)
        return RINGS.areas() * np.column_stack([self.lux[:, 0], around])

    def encircled(self):
        """What each ring and all within it register, in lm: one row a run."""
        return np.cumsum(self.fluxes(), axis=1)


def triangles(subdivisions):
    """How many triangles that many subdivisions give, as text."""
    return f"{20 * 4**subdivisions / 1000:.0f} thousand triangles"


def glass(subdivisions):
    """The sphere, divided so often."""
    return bodies.icosphere((0.0, 0.0, GLASS.height), GLASS.radius, subdivisions)


def floor():
    """A disk, its rings of vertices where RINGS says."""
    radius, count = RINGS.radii[-1], len(RINGS.radii) - 1
    surface = bodies.disk(np.zeros(3), (0.0, 0.0, 1.0), (radius, 0.0, 0.0), RINGS.sides, count)
    points = vtk_to_numpy(surface.GetPoints().GetData())
    evenly = radius * np.arange(1, count + 1) / count
    points[1:] *= np.repeat(RINGS.radii[1:] / evenly, RINGS.sides)[:, None]
    return surface


def scene(subdivisions):
    """The pipeline: the sphere and the floor as blocks, each with its material, and the lamp."""
    group = simple.GroupDatasets(Input=[as_source(glass(subdivisions)), as_source(floor())])
    black = {"Preset": "Custom", "DiffuseReflectance": [0.0, 0.0, 0.0]}
    clear = {"ClearTransmittance": [1.0] * 3, "RefractiveIndex": GLASS.index, "SolidBody": 1}
    sphere = simple.SurfaceMaterial(Input=group, Blocks=[1], **black, **clear)
    both = simple.SurfaceMaterial(Input=sphere, Blocks=[2], **black)
    lamp = simple.Luminaire(Type="Parallel", Direction=[0, 0, -1], Illuminance=ILLUMINANCE)
    return simple.IlluminationMap(Input=both, Luminaires=[lamp])


def caustic(subdivisions, photons=PHOTONS, seeds=SEEDS):
    """The floor's map under a sphere of so many triangles, by independent runs."""
    proxy = scene(subdivisions)
    proxy.Photons = photons
    lux, facts = [], []
    for seed in seeds:
        proxy.Seed = seed
        proxy.UpdatePipeline()
        blocks = servermanager.Fetch(proxy)
        lux.append(vtk_to_numpy(blocks.GetBlock(1).GetPointData().GetArray("Illuminance")).copy())
        facts.append(facts_of(blocks))
    return Caustic(np.array(lux, dtype=float), facts)


def mean_and_error(runs):
    """Mean of independent runs (one row each), and its standard error."""
    return runs.mean(axis=0), runs.std(axis=0, ddof=1) / np.sqrt(len(runs))


def table_rows(exact, caustics):
    """Encircled flux at some distances: exact, and how far caustics (by size) are off."""
    of_all = {size: mean_and_error(found.encircled()) for size, found in caustics.items()}
    rows = []
    for distance in SHOWN:
        k = np.abs(RINGS.radii - distance).argmin()
        flux = np.cumsum(exact)[k]
        row = {"Within, mm": 1000.0 * float(RINGS.radii[k]), "Exact flux, lm": float(flux)}
        for size, (mean, _) in of_all.items():
            row[f"{triangles(size)}, off, %"] = float(100.0 * (mean[k] / flux - 1.0))
        row["Standard error, %"] = float(100.0 * of_all[FINE][1][k] / flux)
        rows.append(row)
    return rows


def main(output):
    """Draws the picture and writes the table into a folder."""
    from figure import draw_caustic  # it renders, which check.py need not

    load_plugin()
    exact = ring_fluxes(GLASS, RINGS, ILLUMINANCE)
    caustics = {size: caustic(size) for size in (COARSE, FINE)}
    heading = "The caustic of a glass sphere: flux on the floor within a distance from the axis"
    tables.write(table_rows(exact, caustics), output / "glass_sphere", heading)
    draw_caustic(output / "glass_sphere.png", exact, caustics)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
