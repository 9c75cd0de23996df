# SPDX-License-Identifier: BSD-3-Clause
"""The work plane of an office: maintained illuminance, uniformity, modelling and glare.

Run by pvbatch: work_plane.py OUTPUT_DIR. Writes a picture and a table there.
"""

import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "common")]

import tables  # noqa: E402
from illumination import load_plugin  # noqa: E402
from scene import DESK_HEIGHT, EYE_HEIGHT, Office, values  # noqa: E402

PICTURED = 0.075  # m, the spacing of the grids that are drawn


def mean(sensors, name):
    """Mean over the valid sensors of an array, and its standard error by the sensors' own."""
    told = values(sensors, "StandardError" + name.replace("Illuminance", ""))
    return float(values(sensors, name).mean()), float(np.sqrt((told**2).mean() / len(told)))


def summary(desks, eyes):
    """What a lighting designer asks for: rows of a quantity, its value and its standard error."""
    lux = values(desks, "HorizontalIlluminance")
    noise = values(desks, "StandardErrorHorizontal")
    average, error = mean(desks, "HorizontalIlluminance")
    cylindrical, cylindrical_error = mean(eyes, "CylindricalIlluminance")
    horizontal, horizontal_error = mean(eyes, "HorizontalIlluminance")
    ratio = cylindrical / horizontal
    glare = values(eyes, "UGR")
    most = np.unravel_index(glare.argmax(), glare.shape)
    found = [
        ("Maintained illuminance, lx", average, error),
        ("Minimum, lx", lux.min(), noise[lux.argmin()]),
        ("Uniformity U0", lux.min() / average, noise[lux.argmin()] / average),
        ("Cylindrical illuminance at 1.2 m, lx", cylindrical, cylindrical_error),
        (
            "Modelling index",
            ratio,
            ratio * np.hypot(cylindrical_error / cylindrical, horizontal_error / horizontal),
        ),
        ("Largest UGR at 1.2 m", glare[most], values(eyes, "StandardErrorUGR")[most]),
    ]
    return [
        {"Quantity": name, "Value": float(value), "Standard error": float(sigma)}
        for name, value, sigma in found
    ]


def measure(office):
    """The sensors at the work plane and at the eyes of people who sit, by the grid of EN 12464-1."""
    return office.sensors(Height=DESK_HEIGHT), office.sensors(Height=EYE_HEIGHT)


def main(output):
    """Reads the sensors, draws and tabulates them."""
    from figure import draw_plans  # it renders, which check.py need not

    load_plugin()
    office = Office()
    tables.write(summary(*measure(office)), output / "work_plane", "An office by its sensors")
    fine = [office.sensors(Height=height, Spacing=PICTURED) for height in (DESK_HEIGHT, EYE_HEIGHT)]
    draw_plans(output / "work_plane.png", *fine)


if __name__ == "__main__":
    main(Path(sys.argv[1]))
