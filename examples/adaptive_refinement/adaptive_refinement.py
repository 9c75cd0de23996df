# SPDX-License-Identifier: BSD-3-Clause
"""A room with two triangles a wall, before and after AdaptiveRefinement.

Run by pvbatch: adaptive_refinement.py OUTPUT_DIR. Writes a picture and a table there.
"""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "common")]

import tables  # noqa: E402
from illumination import load_plugin  # noqa: E402
from scene import room_map, rows_of_table  # noqa: E402

if __name__ == "__main__":
    from figure import draw_room

    OUTPUT = Path(sys.argv[1])
    load_plugin()
    before = room_map()
    after = room_map(AdaptiveRefinement=1)
    draw_room(OUTPUT / "adaptive_refinement.png", before.surface, after.surface)
    rows = rows_of_table(before, after)
    tables.write_csv(rows, OUTPUT / "adaptive_refinement.csv")
    print(tables.markdown(rows))
