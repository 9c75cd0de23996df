# SPDX-License-Identifier: BSD-3-Clause
"""Fails unless the registrations' errors are what expected.csv says. Needs pvbatch, no screen.

With an argument it writes what it measures to that file, in the form of expected.csv.
"""

import sys
from pathlib import Path

from cylinder_and_sphere import HERE, PHOTONS, SEEDS, illumination_maps, measured

import bodies
import tables
from illumination import load_plugin

SIGMAS = 5.0  # so many standard errors may the RMS error be away from the expected one
FACTOR = 5.0  # at least so far is Vertex Normalised below Facet Ratio


def problems(rows, expected):
    """What is wrong with the measured rows: a list of sentences."""
    found = []
    for row, wanted in zip(rows, expected):
        name = row["Registration"]
        allowed = SIGMAS * (row["Standard error"] + wanted["Standard error"])
        off = abs(row["RMS error"] - wanted["RMS error"])
        if name != wanted["Registration"] or not off <= allowed:
            found.append(f"{name}: RMS error {row['RMS error']:.3g}, expected {wanted}")
    error = {row["Registration"]: row["RMS error"] for row in rows}
    if not FACTOR * error["Vertex Normalised"] <= error["Facet Ratio"]:
        found.append("Vertex Normalised is not far enough below Facet Ratio")
    return found


def main():
    """Measures, prints, compares; the exit status tells."""
    load_plugin()
    surface = bodies.appended(bodies.cylinder(), bodies.sphere())
    results = measured(surface, illumination_maps(surface, PHOTONS, SEEDS))
    rows = [
        {"Registration": name, "RMS error": a.rms, "Standard error": a.rms_error}
        for name, a in results.items()
    ]
    print(tables.markdown(rows))
    if len(sys.argv) > 1:
        tables.write(rows, Path(sys.argv[1]).with_suffix(""), "Shares of the brightest point")
        return
    found = problems(rows, tables.read(HERE / "expected.csv"))
    sys.exit("\n".join(found) if found else 0)


if __name__ == "__main__":
    main()
