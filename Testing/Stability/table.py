# SPDX-License-Identifier: BSD-3-Clause
"""Writes what the stability tests measured into the table of Testing/README.md.

Usage: table.py RESULTS README, the folder of the tests' XML files and the page. Fails if a case has left
no result.
"""

import re
import sys
from pathlib import Path

sys.path[:0] = [str(Path(__file__).resolve().parents[1])]

from test_tables import finished_tests, put_table  # noqa: E402

CASES = {
    1: "Grazing light", 2: "Normals", 3: "Triangles", 4: "Scale and place", 5: "Closed shapes",
    6: "Long paths", 7: "Lamps in odd places", 8: "Sums", 9: "Threads and order", 10: "Bad input",
    11: "Fuzz", 12: "Memory", 13: "Photometric files", 14: "Ranks", 15: "Ends of a process",
}
OPTIONAL = {14}  # not without mpiexec
SUITES = {  # those whose names do not tell the case
    "FilterNormals": 2, "FilterShapes": 3, "FilterDegenerate": 3, "FilterGhosts": 3,
    "FilterSheets": 3, "FilterPlace": 4, "FilterInput": 10,
    "FilterLife": 10, "FilterDeletion": 10, "FilterSettings": 10, "Fuzz": 11, "FilterFuzz": 11,
    "FilterMemory": 12, "FilterMemoryOfKinds": 12, "FilterWiring": 7, "LampPlace": 7,
    "FilterMissingLight": 7, "LargeSite": 4,
    "FilterSharedPlaces": 3, "FilterOverlaps": 3, "PhotometricVariants": 13,
    "PhotometricRobustness": 13, "SeveralRanks": 14, "ProcessEnd": 15,
}


def case_of(suite):
    """The number of the case that a test suite belongs to; none for other suites."""
    suite = suite.split("/")[-1]
    numbered = re.match(r"Case(\d+)", suite)
    return int(numbered.group(1)) if numbered else SUITES.get(suite)


def words(name):
    """A test's name as words: LightAlongAPlane -> Light along a plane."""
    spaced = re.sub(r"(?<=[a-z])(?=[A-Z0-9])|(?<=[0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", " ", name)
    return spaced[0] + spaced[1:].lower()


def results(folder):
    """(case, test) -> (what it protects against, [what was measured, one text for each way])."""
    found = {}
    for suite, test, said in finished_tests(folder):
        case = case_of(suite)
        if case is None:
            continue
        protects, measured = said.get("protects", ""), said.get("measured", "passes")
        entry = found.setdefault((case, words(test.split("/")[0])), (protects, []))
        if measured not in entry[1]:
            entry[1].append(measured)
    return found


def main(folder, page):
    """Puts the table between its marks."""
    found = results(folder)
    missing = [CASES[case] for case in CASES if case not in OPTIONAL and not any(key[0] == case for key in found)]
    if missing:
        sys.exit(f"no results in {folder} of: {', '.join(missing)}")
    put_table(page, "the tests write", [
        {"case": f"{case} {CASES[case]}", "test": name, "protects against": protects,
         "measured": "; ".join(sorted(measured))}
        for (case, name), (protects, measured) in sorted(found.items())])


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
