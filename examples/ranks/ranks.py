# SPDX-License-Identifier: BSD-3-Clause
"""Lights the room of light.py without MPI and on 2 and 3 ranks, and writes the maps' numbers as a table.

ranks.py OUTPUT_DIR: run by python3, since a pvbatch that has started MPI can't start mpiexec. Without
mpiexec there is one row.
"""

import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent / "common")]
import tables  # noqa: E402

# More ranks than cores, and as root, as in containers: the same for Open MPI 4 and 5.
MPI = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1",
       "OMPI_MCA_rmaps_base_oversubscribe": "1", "OMPI_MCA_hwloc_base_binding_policy": "none",
       "PRTE_MCA_rmaps_default_mapping_policy": ":oversubscribe", "PRTE_MCA_hwloc_default_binding_policy": "none"}


def on_ranks(ranks, photons=100000):
    """The numbers of the map on so many ranks; 0 is without MPI."""
    command = ["pvbatch", str(HERE / "light.py"), str(photons)]
    if ranks:
        command = ["mpiexec", "-n", str(ranks), command[0], "--mpi", *command[1:]]
    # The streams are apart, since mpiexec may put a message into the middle of a line.
    run = subprocess.run(command, env={**os.environ, **MPI}, text=True, capture_output=True, timeout=300)
    lines = [line for line in run.stdout.splitlines() if line.startswith("MAP ")]
    assert run.returncode == 0 and len(lines) == 1, run.stdout + run.stderr
    return json.loads(lines[0][len("MAP "):])


def maps():
    """A row for each number of ranks."""
    return [on_ranks(ranks) for ranks in ((0, 2, 3) if shutil.which("mpiexec") else (0,))]


if __name__ == "__main__":
    tables.write(maps(), Path(sys.argv[1]) / "ranks", "A room lit on one and on several ranks")
