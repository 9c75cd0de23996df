# SPDX-License-Identifier: BSD-3-Clause
"""Economy-class seats in threes, of rounded boxes that are bent into shape. Metres.

A seat faces +x; x = 0 is where its cushion meets its back, z = 0 the floor.
"""

import numpy as np

from mesh import bent, merged, mirrored, moved, rounded_box

SEAT_PITCH = 0.80  # from row to row
AISLE = 0.50  # clear width between the armrests
PLACE = 0.49  # width of one place with one armrest
ARMREST = 0.05  # width
SEATS = 3  # on either side of the aisle
HINGE = 0.42  # height about which the back reclines
RECLINE = np.tan(np.radians(14.0))


def reclined(points):
    """The lean of a back: further behind (-x) the higher up, with a bulge that bears the loins."""
    x, y, z = points.T
    up = (z - HINGE) / 0.74
    lumbar = 0.025 * np.exp(-(((up - 0.25) / 0.22) ** 2))
    return np.stack([x - RECLINE * (z - HINGE) + lumbar, y, z], axis=1)


def cushion():
    """What one sits on: 0.5 m deep, its top at 0.45 m, crowned, softly bent down at the knees."""
    half = np.array([0.25, 0.222, 0.07])

    def crowned(points):
        x, y, z = points.T
        crown = 0.02 * (1.0 - (y / half[1]) ** 2) * (z + half[2])
        knees = 0.05 * np.clip((x - 0.05) / 0.2, 0.0, None) ** 2
        return np.stack([x, y, z + crown / (2.0 * half[2]) - knees + 0.04 * x], axis=1)

    return moved(bent(rounded_box(half, 0.055, (3, 3, 1), 2), crowned), (0.23, 0.0, 0.38))


def back():
    """The backrest with side bolsters, 0.74 m high, narrower at the top."""
    half = np.array([0.055, 0.222, 0.37])

    def shaped(points):
        x, y, z = points.T
        narrow = 1.0 - 0.03 * (1.0 + z / half[2]) ** 2
        bolsters = 0.03 * (y / half[1]) ** 2
        return np.stack([x + bolsters, y * narrow, z], axis=1)

    upright = bent(rounded_box(half, 0.05, (1, 2, 4), 2), shaped)
    return bent(moved(upright, (-0.035, 0.0, 0.78)), reclined)


def headrest():
    """The headrest, its wings bent forward."""
    half = np.array([0.04, 0.155, 0.10])

    def winged(points):
        x, y, z = points.T
        return np.stack([x + 0.05 * (np.abs(y) / half[1]) ** 2.5, y, z], axis=1)

    pad = bent(rounded_box(half, 0.036, (1, 2, 1), 2), winged)
    return bent(moved(pad, (0.015, 0.0, 1.13)), reclined)


def tray():
    """The table, folded up against the rear of the back."""
    board = rounded_box((0.014, 0.19, 0.12), 0.01, (1, 2, 1), 1)
    return bent(moved(board, (-0.098, 0.0, 0.87)), reclined)


def armrest():
    """One armrest, its top at 0.64 m."""
    return moved(rounded_box((0.2, ARMREST / 2.0, 0.03), 0.022, (2, 1, 1), 1), (0.13, 0.0, 0.61))


def frame():
    """What carries the three places, from the first armrest's middle (y = 0): pan, tube, two legs."""
    width = SEATS * PLACE
    middle = width / 2.0
    pan = moved(rounded_box((0.2, middle - 0.03, 0.02), 0.015, (1, 6, 1), 1), (0.2, middle, 0.31))
    leg = rounded_box((0.13, 0.02, 0.16), 0.015, (1, 1, 1), 1)
    legs = [moved(leg, (0.2, share * width, 0.145)) for share in (0.2, 0.75)]
    side = moved(rounded_box((0.11, 0.012, 0.15), 0.01, (1, 1, 1), 1), (0.04, 0.0, 0.45))
    return merged([pan, *legs, side])


def bench():
    """Three places to the right of the aisle: part name -> Mesh."""
    first = AISLE / 2.0 + ARMREST / 2.0
    places = [(0.0, first + (i + 0.5) * PLACE, 0.0) for i in range(SEATS)]
    backs = merged([back(), headrest(), tray()])
    arms = [moved(armrest(), (0.0, first + i * PLACE, 0.0)) for i in range(SEATS + 1)]
    return {
        "Seat cushions": merged([moved(cushion(), p) for p in places]),
        "Seat backs": merged([moved(backs, p) for p in places]),
        "Armrests and frames": merged([*arms, moved(frame(), (0.0, first, 0.0))]),
    }


def seats(rows, first_row):
    """All seats, the last row's x = 0 at first_row (m): part name -> Mesh."""
    parts = {}
    for name, mesh in bench().items():
        pair = merged([mesh, mirrored(mesh)])
        stations = first_row + SEAT_PITCH * np.arange(rows)
        parts[name] = merged([moved(pair, (x, 0.0, 0.0)) for x in stations])
    return parts
