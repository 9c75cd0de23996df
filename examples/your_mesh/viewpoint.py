# SPDX-License-Identifier: BSD-3-Clause
"""Where to stand, and where the light comes from, when the user does not say. Lengths as the mesh's."""

import numpy as np

from pictures import Camera

# The axis that points up -> unit vectors to the right, to the front (towards the viewer) and up.
FRAMES = {
    "x": np.array([[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]]),
    "y": np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]]),
    "z": np.array([[1.0, 0.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0]]),
}
VIEW_FROM = np.array([0.45, 1.0, 0.45])  # right, front, up
LIGHT_FROM = np.array([-0.5, 0.7, 1.0])


def light_direction(up):
    """In which parallel light travels: from above, from the front, from the left."""
    return -LIGHT_FROM @ FRAMES[up] / np.linalg.norm(LIGHT_FROM)


def down(up):
    """The unit vector that points down."""
    return -FRAMES[up][2]


def camera_for(points, up, angle, aspect, position=None, focus=None):
    """A camera that has all points in view; position and focus as wished, if not None.

    angle: vertical field of view, degrees; aspect: width over height of the picture.
    """
    middle = 0.5 * (points.min(axis=0) + points.max(axis=0))
    target = middle if focus is None else np.asarray(focus)
    if position is None:
        back = VIEW_FROM @ FRAMES[up] / np.linalg.norm(VIEW_FROM)
        right = np.cross(FRAMES[up][2], back)
        right /= np.linalg.norm(right)
        sideways, above = right, np.cross(back, right)
        tangent = np.tan(np.radians(angle / 2.0)) * 0.94  # leaves a margin
        relative = points - target
        near = relative @ back
        reach = np.maximum(
            np.abs(relative @ sideways) / (tangent * aspect), np.abs(relative @ above) / tangent
        )
        position = target + (near + reach).max() * back
    return Camera(tuple(position), tuple(target), tuple(FRAMES[up][2]), angle)
