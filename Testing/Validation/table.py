# SPDX-License-Identifier: BSD-3-Clause
"""Writes how far the validation's cases are from what is exact into the table of Testing/README.md.

Usage: table.py RESULTS README, the folder of the tests' XML files and the page. Fails if a case of
CIE 171:2006 has left no result.
"""

import re
import sys
from pathlib import Path

sys.path[:0] = [str(Path(__file__).resolve().parents[1])]

from test_tables import finished_tests, put_table  # noqa: E402

WANTED = ("5.2", "5.3", "5.4", "5.8", "5.9", "5.10", "5.12", "5.13")
HEAD = ("case", "quantities", "exact (the first), lx or lm", "measured", "largest deviation, %",
        "its standard errors", "largest standard error, %", "million photons")


def in_order(row):
    """Sorts 5.9 before 5.10 and sky 2 before sky 10; cases without a number come last."""
    numbers = [float(n) if "." not in n else int(n.split(".")[1]) for n in re.findall(r"[\d.]+", row[0])]
    return (not row[0][0].isdigit(), numbers, row[0])


def main(folder, page):
    """Puts the table between its marks."""
    rows = []
    for _, _, said in finished_tests(folder):
        # A test that has several cases numbers their properties. Other tests have properties of theirs.
        for key in said:
            if numbered := re.fullmatch(r"case(\d+)", key):
                of = numbered[1]
                names = ("case", "quantities", "exact", "measured", "deviation", "ratio", "standardError", "photons")
                rows.append([said[name + of] for name in names])
    missing = [case for case in WANTED if not any(row[0].startswith(case + " ") for row in rows)]
    if missing:
        sys.exit(f"no results in {folder} of the cases {', '.join(missing)}")
    put_table(page, "the validation writes", [dict(zip(HEAD, row)) for row in sorted(rows, key=in_order)])


if __name__ == "__main__":
    main(Path(sys.argv[1]), Path(sys.argv[2]))
