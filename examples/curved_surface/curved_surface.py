# SPDX-License-Identifier: BSD-3-Clause
"""Coarse bodies near a lamp: traced as facets, traced on the curved surface, and exactly.

Run by pvbatch: curved_surface.py OUTPUT_DIR. Writes three pictures and four tables there.
"""

import sys
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "common")]

import bodies  # noqa: E402
import tables  # noqa: E402
from accuracy import accuracy, point_areas  # noqa: E402
from convergence import CHART, turns_rows  # noqa: E402
from illumination import load_plugin, texts  # noqa: E402
from scene import (  # noqa: E402
    MODES, PHOTONS, SEEDS, SHAPES, coarse_bodies, exact_bodies, exact_caught, exact_floor, floor, light,
)  # fmt: skip

PHOTONS_ALONE = 1_000_000  # for a body without the rest


@dataclass
class Lit:
    """The whole scene in one mode, by independent runs."""

    surface: object  # vtkPolyData, the first run's
    lux: np.ndarray  # one row a run
    seconds: float  # of one run, with the preparations
    effects: list  # what the filter says of them

    def curved_line(self):
        """What the filter says of the curved surface."""
        return next(line for line in self.effects if line.startswith("curved surface"))


def traced_triangles(line, triangles):
    """How many triangles were traced, by the Effects line of the curved surface."""
    words = line.replace(",", " ").split()
    if "parts" not in words:
        return triangles
    whole = int(words[words.index("of") + 1]) - int(words[words.index("of") - 1])
    return whole + int(words[words.index("parts") - 1])


def lit_scene(photons=PHOTONS, seeds=SEEDS):
    """The scene by every mode: name -> Lit. The floor's points come first."""
    surface = bodies.appended(floor(), coarse_bodies())
    found = {}
    for name, curved in MODES.items():
        start = time.perf_counter()
        runs = [light(surface, curved, photons, seed) for seed in seeds]
        seconds = (time.perf_counter() - start) / len(runs)
        lux = np.array([run.array() for run in runs], dtype=float)
        found[name] = Lit(runs[0].surface, lux, seconds, texts(runs[0].surface, "Effects"))
    return found


def floor_accuracy(found, ground, exact):
    """Accuracy of the floor's map about the outlines of the shadows: mode -> Accuracy.

    Shares of the floor's brightest point.
    """
    areas = point_areas(ground) * exact.band
    return {
        name: accuracy(lit.lux[:, : len(exact.lux)], exact.lux, areas) for name, lit in found.items()
    }


def largest_in_band(lit, exact):
    """Largest error at a point of the band, a share of the floor's brightest point."""
    off = np.abs(lit.lux[:, : len(exact.lux)].mean(axis=0) - exact.lux)
    return float(off[exact.band].max() / exact.lux.max())


@dataclass
class Caught:
    """The flux on a body alone, against the exact body's."""

    off: float  # how much more it catches, as a share
    error: float  # standard error of off


def caught(photons=PHOTONS_ALONE, seeds=SEEDS):
    """The flux on every body alone: body -> mode -> Caught."""
    found = {}
    for name, shape in SHAPES.items():
        mesh, exact = shape.mesh(*shape.coarse), exact_caught(shape)
        found[name] = {}
        for mode, curved in MODES.items():
            runs = [light(mesh, curved, photons, seed).facts["FluxOnFronts"] for seed in seeds]
            error = np.std(runs, ddof=1) / np.sqrt(len(runs)) / exact
            found[name][mode] = Caught(float(np.mean(runs) / exact - 1.0), float(error))
    return found


def scene_rows(found, results, exact, fluxes):
    """The table: a row for each mode."""
    rows = []
    for mode, lit in found.items():
        row = {
            "Traced": mode,
            "RMS error, %": 100.0 * results[mode].rms,
            "Largest error, %": 100.0 * largest_in_band(lit, exact),
        }
        for body, of in fluxes.items():
            row[f"Light caught, {body.lower()}, %"] = 100.0 * of[mode].off
        row["Triangles traced"] = traced_triangles(lit.curved_line(), lit.surface.GetNumberOfCells())
        row["Seconds"] = lit.seconds
        rows.append(row)
    return rows


def main(output):
    """Draws the pictures and writes the tables into a folder."""
    from chart import draw_convergence  # they render, which check.py need not
    from figure import draw_lit, draw_refinement

    load_plugin()
    ground = floor()
    exact, found, fluxes = exact_floor(ground), lit_scene(), caught()
    results = floor_accuracy(found, ground, exact)
    heading = "Floor within 60 mm of the shadows' outlines, and light on each body alone, against the exact"
    tables.write(scene_rows(found, results, exact, fluxes), output / "curved_surface", heading)
    print("\n".join(lit.curved_line() for lit in found.values()), flush=True)
    draw_lit(output / "curved_surface.png", found, ground, exact, exact_bodies(), results)
    rows = draw_refinement(output / "refinement.png")
    tables.write(rows, output / "refinement", "Triangles, and how far they are from the exact surface")
    coarse, finer = turns_rows(), turns_rows(times=2)
    tables.write(coarse, output / "convergence", CHART)
    tables.write(finer, output / "convergence_finer", f"{CHART}, input with twice the facets along every edge")
    draw_convergence(output / "convergence.png", coarse, finer)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
