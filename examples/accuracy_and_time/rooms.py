# SPDX-License-Identifier: BSD-3-Clause
"""Two more scenes on which the methods are compared: a room lit by a panel, and one by the sky."""

import sys

import numpy as np

from scenes import EXAMPLES, Scene, cabin, room

sys.path.append(str(EXAMPLES / "daylight_room"))

import bodies  # noqa: E402
from scene import CELLS, SIDES, SKY, make_room, points_of, rectangle  # noqa: E402
from vtk.util.numpy_support import numpy_to_vtk  # noqa: E402

BALL = {"centre": (1.5, -0.2, 1.0), "radius": 0.6, "subdivisions": 5}
BALL_REFLECTANCE = 0.5
PANEL = {
    "LampType": "Rectangle",
    "LampPosition": [2.0, 0.0, 2.95],
    "LampDirection": [0.0, 0.0, -1.0],
    "LampSize": [0.6, 0.6],
    "LuminousFlux": 3000.0,
    "ReflectanceArray": "Reflectance",
}


def panel():
    """A closed room of 4 by 4 by 3 m with a ball of 20 thousand triangles under a square panel."""
    ball = bodies.icosphere(**BALL)
    for name, value in (("Reflectance", BALL_REFLECTANCE), ("Room", 1.0)):
        array = numpy_to_vtk(np.full(ball.GetNumberOfCells(), value), deep=1)
        array.SetName(name)
        ball.GetCellData().AddArray(array)
    surface = bodies.appended(*(rectangle(*side[:4], CELLS) for side in SIDES), ball)
    return Scene("panel", "Room with a ball under a panel", surface, PANEL, None, 0, 16_000_000)


def daylight():
    """The daylight room's example; errors on the ground before it do not count."""
    surface = make_room()
    return Scene(
        "daylight",
        "Room with a window, overcast sky",
        surface,
        {"ReflectanceArray": "Reflectance"},
        None,
        0,
        16_000_000,
        luminaire=SKY,
        counted=points_of(surface),
    )


FEATURES = {
    "room": "Even light (all glows)",
    "panel": "Lamp, edges, a body (room with a ball)",
    "cabin": "Coarse facets, hidden lamps (cabin)",
    "daylight": "Daylight (room with a window)",
}  # what is typical of a scene
METHOD_SCENES = {"room": room, "panel": panel, "cabin": cabin, "daylight": daylight}
