# SPDX-License-Identifier: BSD-3-Clause
"""Fails unless the room has the same map on 2 and 3 ranks as without MPI.

The least and the largest illuminance and the error are the same numbers, bit for bit. The flux is a
sum that ParaView adds up rank by rank, so it may differ by rounding. Run by python3; needs pvbatch and mpiexec,
but no screen.
"""

import math

from ranks import maps

ROUNDING = 1e-12  # of a sum of some thousand numbers in double precision

alone, *shared = maps()
for row in shared:
    assert row["Ranks"] > 1, row
    for name in ("Cells", "Least, lx", "Most, lx", "Error, %"):
        assert row[name] == alone[name], (name, row, alone)
    assert math.isclose(row["Flux, lm"], alone["Flux, lm"], rel_tol=ROUNDING), (row, alone)
print([alone, *shared])
