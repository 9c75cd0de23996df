# SPDX-License-Identifier: BSD-3-Clause
"""A room with a window under an overcast sky: Final Gathering and Photon Tracing in equal time.

Run by pvbatch: daylight_room.py OUTPUT_DIR. Writes a picture and a table there.
"""

import sys
import time
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "common")]

import tables  # noqa: E402
from accuracy import point_areas  # noqa: E402
from illumination import load_plugin, smooth  # noqa: E402
from scene import OUTDOORS, floor_points, light, make_room, points_of  # noqa: E402
from vtk.util.numpy_support import vtk_to_numpy  # noqa: E402

TARGET = 0.03  # of the room's mean illuminance, in the room alone
MOST_PHOTONS = 2_000_000_000
REFERENCE = {"Method": "Final Gathering", "Photons": 4_000_000, "Seed": 1001}


def to_target(surface, **properties):
    """The map whose noise in the room, not on the bright ground, is at most TARGET."""
    return light(
        surface,
        Method="Final Gathering",
        AccuracyRegionArray="Room",
        TargetRelativeError=TARGET,
        Photons=MOST_PHOTONS,
        **properties,
    )


class Room:
    """Errors in the room against a long run."""

    def __init__(self, surface):
        self.areas = point_areas(surface) * points_of(surface)
        found = light(surface, **REFERENCE)
        self.lux, self.noise = found.array(), found.array("StandardError")

    def rms(self, values):
        """Root mean square over the room's area, in % of its mean illuminance."""
        mean = np.average(self.lux, weights=self.areas)
        return 100.0 * float(np.sqrt(max(np.average(values, weights=self.areas), 0.0)) / mean)

    def row(self, name, seconds, photons, lux):
        """A row of the table; the long run's noise is taken out."""
        floor = floor_points()
        factor = np.average(lux[floor], weights=self.areas[floor]) / OUTDOORS
        return {
            "Method": name,
            "Seconds": float(seconds),
            "Photons": int(photons),
            "Mean daylight factor of the floor, %": 100.0 * float(factor),
            "RMS error in the room, %": self.rms((lux - self.lux) ** 2 - self.noise**2),
        }


def main(output):
    """Lights the room, draws and tabulates it."""
    from figure import draw_room  # it renders, which check.py need not

    load_plugin()
    surface = make_room()
    gathered = to_target(surface)
    print("\n" + gathered.facts["Openings"])
    seconds = gathered.facts["Seconds"]
    traced = light(surface, TimeLimit=seconds, Photons=MOST_PHOTONS)
    start = time.perf_counter()
    smoothed = smooth(traced.surface)
    after = traced.facts["Seconds"] + time.perf_counter() - start
    by_smoothing = vtk_to_numpy(smoothed.GetPointData().GetArray("IlluminanceSmoothed"))
    maps = {
        "Final Gathering": (seconds, gathered.facts["PhotonsEmitted"], gathered.array()),
        "Photon Tracing": (traced.facts["Seconds"], traced.facts["PhotonsEmitted"], traced.array()),
        "Photon Tracing, smoothed": (after, traced.facts["PhotonsEmitted"], by_smoothing),
    }
    room = Room(surface)
    rows = [room.row(name, *values) for name, values in maps.items()]
    print(f"The long run's own error: {room.rms(room.noise**2):.2f} %")
    tables.write(rows, output / "daylight_room", "A room in daylight: RMS error by method")
    draw_room(output / "daylight_room.png", surface, {n: v[2] for n, v in maps.items()}, rows)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
