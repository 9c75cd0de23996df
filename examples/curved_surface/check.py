# SPDX-License-Identifier: BSD-3-Clause
"""Fails unless CurvedSurface and Surface Refinement come as near the exact bodies as they should.

Errors must be those of expected.csv but for noise, and with CurvedSurface a tenth of those without.
A triangle on a sphere whose edges turn by the angle a at most is within R (1 - cos(a / sqrt(3))) of
it, as its circumscribed circle spans at most a / sqrt(3) to each side. What the curved patches are
off, taken from the finest refinement, comes on top. Needs pvbatch, but no screen.

check.py OUTPUT.csv writes what it measures instead.
"""

import sys
from pathlib import Path

import numpy as np
from curved_surface import HERE, caught, floor_accuracy, lit_scene

import tables
from convergence import TURNS, distances, input_mesh
from illumination import load_plugin
from scene import FLUX, LAMP, MODES, SHAPES, exact_caught, exact_floor, floor, refined

SIGMAS = 5.0  # so many standard errors may a value be away from the expected one
FACTOR = 10.0  # at least so much nearer is the curved surface
QUADRATURE = 2e-5  # relative error of exact_caught: by elements twice as long


def measured():
    """Rows of expected.csv: errors as shares, with their standard errors."""
    ground = floor()
    results = floor_accuracy(lit_scene(), ground, exact_floor(ground))
    rows = [("Floor, RMS", mode, a.rms, a.rms_error) for mode, a in results.items()]
    for body, fluxes in caught().items():
        rows += [(f"{body}, light caught", mode, f.off, f.error) for mode, f in fluxes.items()]
    return [dict(zip(("What", "Traced", "Error", "Standard error"), row)) for row in rows]


def check_errors(rows, wanted_rows):
    """All errors against the expected ones, and the curved surface's against the facets'."""
    for row, wanted in zip(rows, wanted_rows, strict=True):
        assert (row["What"], row["Traced"]) == (wanted["What"], wanted["Traced"]), (row, wanted)
        allowed = SIGMAS * (row["Standard error"] + wanted["Standard error"])
        assert abs(row["Error"] - wanted["Error"]) <= allowed, (row, wanted)
    flat, curved = ([row for row in rows if row["Traced"] == mode] for mode in MODES)
    for before, after in zip(flat, curved, strict=True):
        assert FACTOR * abs(after["Error"]) <= abs(before["Error"]), (before, after)


def check_exact():
    """The exact sphere's light: the lamp sees it under a cone."""
    sphere = SHAPES["Sphere"]
    sine = sphere.radius / np.linalg.norm(sphere.centre - LAMP)
    cone = 0.5 * FLUX * (1.0 - np.sqrt(1.0 - sine**2))
    assert abs(exact_caught(sphere) / cone - 1.0) <= QUADRATURE, (exact_caught(sphere), cone)
    for shape in SHAPES.values():
        halved = exact_caught(shape, 360, 180) / exact_caught(shape) - 1.0
        assert abs(halved) <= QUADRATURE, halved


def check_distances():
    """A refined sphere's largest distance from the exact one, in radii, against the bound."""
    sphere = SHAPES["Sphere"]
    mesh = input_mesh(sphere, 2)

    def largest(turn):
        return distances(refined(mesh, MaximumTurn=turn), sphere)[1] / sphere.radius

    own = largest(TURNS[-1])
    for turn in TURNS[:-1]:
        bound = 1.0 - np.cos(np.radians(turn) / np.sqrt(3.0)) + own
        found = largest(turn)
        print(f"turn of {turn:g} degrees: {100.0 * found:.4f} % of the radius, at most {100.0 * bound:.4f}")
        assert found <= bound


if __name__ == "__main__":
    load_plugin()
    errors = measured()
    if len(sys.argv) > 1:
        tables.write_csv(errors, Path(sys.argv[1]))
    else:
        print(tables.markdown(errors))
        check_exact()
        check_errors(errors, tables.read(HERE / "expected.csv"))
        check_distances()
