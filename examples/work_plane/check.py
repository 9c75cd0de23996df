# SPDX-License-Identifier: BSD-3-Clause
"""Fails unless the office's sensors measure what they ought to. Needs pvbatch, but no screen.

In the black office all light comes straight from the luminaires: intensity over squared distance.
In the office the numbers are those of expected.csv, up to the noise of both. Given a path, writes
the numbers there instead.
"""

import sys
from pathlib import Path

import numpy as np
import work_plane
from illumination import load_plugin
from scene import DESK_HEIGHT, FILE, MAINTENANCE, PLACES, Office, values

import bodies
import tables

SIGMAS = 5.0
ROUNDING = 1e-4  # of single precision; recessed luminaires stand clear of the ceiling by 2^-16 of its place


def intensities():
    """Vertical angles, degrees, and candela of the file."""
    lines = Path(FILE).read_text().splitlines()
    numbers = " ".join(lines[lines.index("TILT=NONE") + 1 :]).split()
    count = int(numbers[3])
    angles = np.array(numbers[13 : 13 + count], dtype=float)
    return angles, np.array(numbers[14 + count :], dtype=float)


def direct_light(points):
    """Horizontal and cylindrical illuminance by the luminaires alone, lx."""
    angles, candela = intensities()
    horizontal, cylindrical = np.zeros(len(points)), np.zeros(len(points))
    for place in PLACES:
        way = np.array(place) - points
        square = np.einsum("ij,ij->i", way, way)
        cosine = way[:, 2] / np.sqrt(square)
        across = MAINTENANCE * np.interp(np.degrees(np.arccos(cosine)), angles, candela) / square
        horizontal += across * cosine
        cylindrical += across * np.sqrt(1.0 - cosine**2) / np.pi
    return horizontal, cylindrical


def check_black_office():
    """Each sensor against the closed form; the error bars are zero."""
    sensors = Office(black=True).sensors(Height=DESK_HEIGHT, Photons=2048)
    points, _ = bodies.points_and_normals(sensors)
    assert len(points) == 54  # 6.2 m within the margin: p = 0.72 m, so 9 by 6
    for name, exact in zip(
        ("HorizontalIlluminance", "CylindricalIlluminance"), direct_light(points), strict=True
    ):
        off = np.abs(values(sensors, name) / exact - 1.0).max()
        print(f"black office, {name}: {off:.1e} off at most")
        assert off < ROUNDING, (name, off)
    assert not values(sensors, "StandardErrorHorizontal").any()


def check_office():
    """The numbers of the table."""
    rows = work_plane.summary(*work_plane.measure(Office()))
    if len(sys.argv) > 1:
        tables.write_csv(rows, Path(sys.argv[1]))
        return
    print(tables.markdown(rows))
    for row, wanted in zip(rows, tables.read(Path(__file__).parent / "expected.csv"), strict=True):
        assert row["Quantity"] == wanted["Quantity"]
        allowed = SIGMAS * np.hypot(row["Standard error"], wanted["Standard error"])
        assert abs(row["Value"] - wanted["Value"]) <= allowed, (row, wanted)


if __name__ == "__main__":
    load_plugin()
    check_black_office()
    check_office()
