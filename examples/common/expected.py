# SPDX-License-Identifier: BSD-3-Clause
"""Compares measured errors of the registrations with those that an example's expected.csv holds."""

import sys
from pathlib import Path

import tables

SIGMAS = 5.0  # so many standard errors may an RMS error be away from the expected one


def rows_of(results):
    """Accuracy of every registration (name -> Accuracy) as rows of expected.csv."""
    return [
        {"Registration": name, "RMS error": a.rms, "Standard error": a.rms_error}
        for name, a in results.items()
    ]


def problems(rows, wanted_rows, factor):
    """What is wrong with measured rows: a list of sentences.

    factor: at least so far must Vertex Normalised be below Facet Ratio.
    """
    found = []
    for row, wanted in zip(rows, wanted_rows, strict=True):
        name = row["Registration"]
        allowed = SIGMAS * (row["Standard error"] + wanted["Standard error"])
        off = abs(row["RMS error"] - wanted["RMS error"])
        if name != wanted["Registration"] or not off <= allowed:
            found.append(f"RMS error {row}, expected {wanted}")
    error = {row["Registration"]: row["RMS error"] for row in rows}
    if not factor * error["Vertex Normalised"] <= error["Facet Ratio"]:
        found.append(f"Vertex Normalised is not {factor} times below Facet Ratio")
    return found


def check(results, file, factor):
    """Ends the program, with status 1 if the results are not those of file (expected.csv).

    Given a path on the command line, writes the results there instead, in the same form.
    """
    rows = rows_of(results)
    if len(sys.argv) > 1:
        tables.write_csv(rows, Path(sys.argv[1]))
        return
    print(tables.markdown(rows))
    found = problems(rows, tables.read(file), factor)
    sys.exit("\n".join(found) if found else 0)
