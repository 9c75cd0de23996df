# SPDX-License-Identifier: BSD-3-Clause
"""The cabin by Final Gathering and by Photon Tracing in equal time.

Run by pvbatch: cabin_methods.py OUTPUT_DIR. Writes cabin_methods.png and a table there.
"""

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "common")]

import tables  # noqa: E402
from cabin_geometry import make_cabin  # noqa: E402
from figure import draw_methods  # noqa: E402
from illumination import illuminate, load_plugin  # noqa: E402

GATHERED_PHOTONS = 2_500_000  # about 6 s on two free cores
MOST_PHOTONS = 10_000_000_000
CABIN = {"LampType": "Emitting Facets", "ExitanceArray": "Exitance", "ReflectanceArray": "Reflectance"}
SHOWN = (30.0, 4000.0)  # lx, logarithmic, along the aisle
NEAR_COVE = 6000.0  # lx, linear from 0, of the ceiling


def both_maps(cabin):
    """Method -> IlluminationMap; Photon Tracing has the time that Final Gathering took."""
    gathered = illuminate(cabin, Method="Final Gathering", Photons=GATHERED_PHOTONS, **CABIN)
    seconds = gathered.facts["Seconds"]
    traced = illuminate(cabin, TimeLimit=seconds, Photons=MOST_PHOTONS, **CABIN)
    return {"Photon Tracing": traced, "Final Gathering": gathered}


def main(output):
    """Lights the cabin by both methods, draws and tabulates."""
    load_plugin()
    maps = both_maps(make_cabin())
    rows = [
        {
            "Method": method,
            "Seconds": found.facts["Seconds"],
            "Photons": int(found.facts["PhotonsEmitted"]),
        }
        for method, found in maps.items()
    ]
    tables.write(rows, output / "cabin_methods", "Cabin: both methods in equal time")
    titled = {f"{name}, {row['Seconds']:.1f} s": maps[name] for name, row in zip(maps, rows)}
    draw_methods(output / "cabin_methods.png", titled, *SHOWN, NEAR_COVE)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
