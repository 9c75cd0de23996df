# SPDX-License-Identifier: BSD-3-Clause
"""The cabin in the evening: materials, dimmed coves, reading lights from a photometric file.

Run by pvbatch: cabin_materials.py OUTPUT_DIR. Writes cabin_materials.png and two tables there.
"""

import sys
from pathlib import Path

import numpy as np
from vtk.util.numpy_support import vtk_to_numpy

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "common"), str(HERE.parent / "cabin")]

import tables  # noqa: E402
from accuracy import point_areas  # noqa: E402
from comparison import with_array  # noqa: E402
from illumination import load_plugin, smooth, texts  # noqa: E402
from lighting import (  # noqa: E402
    COVES,
    EVENING,
    LAMPS,
    LATE,
    READING_SEATS,
    contribution,
    differ,
    dimmed,
    light,
    reading_light_flux,
)
from picture import draw_evening  # noqa: E402
from scene import make_scene, places  # noqa: E402

PHOTONS = 16_000_000
LATE_PHOTONS = 4_000_000


def means(surface, lux):
    """Illuminance (lx) of each place, weighted by area."""
    areas = point_areas(surface)
    return {
        f"{name}, lx": float(np.average(lux[own], weights=areas[own]))
        for name, own in places(surface).items()
    }


def lamp_rows(found):
    """What each lamp emits and what arrives of it, directly and after reflections."""
    each = reading_light_flux()
    flux = {COVES: found.facts["EmittedFlux"] - each * len(READING_SEATS)}
    flux.update(dict.fromkeys(READING_SEATS, each))
    rows = [
        {"Lamp": lamp, "Flux, lm": flux[lamp], **means(found.surface, found.array(contribution(lamp)))}
        for lamp in LAMPS
    ]
    rows.append({"Lamp": "All", "Flux, lm": found.facts["EmittedFlux"]})
    rows[-1].update(means(found.surface, found.array()))
    return rows


def dimming_rows(found, fresh):
    """The late cabin, by dimming the evening's map and by a run of its own."""
    return [
        {"Map": "Evening", **means(found.surface, found.array())},
        {"Map": "Late, by Calculator", **means(found.surface, dimmed(found, LATE))},
        {"Map": "Late, traced", **means(fresh.surface, fresh.array())},
    ]


def smoothed_colours(found):
    """Red, green and blue illuminance (lx), each smoothed as a map of its own."""
    channels = []
    for values, errors in zip(found.array("IlluminanceRGB").T.astype(float), found.array("StandardErrorRGB").T):
        channel = with_array(found.surface, values, "Channel")
        channel = with_array(channel, errors, "ChannelError")
        channel = smooth(channel, IlluminanceArray="Channel", StandardErrorArray="ChannelError")
        channels.append(vtk_to_numpy(channel.GetPointData().GetArray("ChannelSmoothed")))
    return np.stack(channels, axis=1)


def main(output):
    """Lights the cabin, tabulates each lamp's part, dims it, draws it."""
    load_plugin()
    scene = make_scene()
    found = light(scene, EVENING, Photons=PHOTONS)
    escaped = found.facts["PhotonsEscaped"] / found.facts["PhotonsEmitted"]
    print(f"{found.facts['Seconds']:.1f} s; {100.0 * escaped:.2f} % of the photons left by the windows")
    print("\n".join(["Effects:", *texts(found.surface, "Effects")]))
    tables.write(lamp_rows(found), output / "cabin_materials", "Cabin in the evening: the lamps")
    fresh = light(scene, LATE, Photons=LATE_PHOTONS, Seed=2)
    tables.write(dimming_rows(found, fresh), output / "cabin_materials_late", "Dimmed")
    print(f"The late maps differ by {differ(found, fresh, LATE):.3f} standard errors (RMS)")
    lux = smooth(found.surface).GetPointData().GetArray("IlluminanceSmoothed")
    draw_evening(
        output / "cabin_materials.png", found.surface, smoothed_colours(found), vtk_to_numpy(lux)
    )


if __name__ == "__main__":
    main(Path(sys.argv[1]))
