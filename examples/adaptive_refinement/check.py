# SPDX-License-Identifier: BSD-3-Clause
"""Fails unless the refined map is right between its points, too.

The light at points of a fine floor, each received there, is compared with what a map of two
triangles and a refined one show by linear interpolation. Needs pvbatch, but no screen.
"""

import adaptive_refinement  # noqa: F401  (where modules are)
from illumination import load_plugin
from scene import error_of, floor_points, room_map

TOLERANCE = 0.05  # RefinementTolerance's default

if __name__ == "__main__":
    load_plugin()
    reference = floor_points()
    before = error_of(room_map().surface, reference)
    after = error_of(room_map(AdaptiveRefinement=1).surface, reference)
    print(f"RMS error on the floor: {100.0 * before:.1f} %, refined {100.0 * after:.2f} %")
    assert after < TOLERANCE < before
