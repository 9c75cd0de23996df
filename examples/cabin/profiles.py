# SPDX-License-Identifier: BSD-3-Clause
"""The cabin's cross-section, right half (y > 0), as curves of points (y, z) and normals. Metres.

Every curve is smooth; where two of them meet there is an edge. The normals point into the air.
"""

from dataclasses import dataclass

import numpy as np

# Side wall: |y / WALL_A|^3 + |(z - WALL_Z) / WALL_B|^3 = 1
WALL_A, WALL_B, WALL_Z = 1.80, 1.60, 0.95
WINDOW_BOTTOM, WINDOW_TOP = 0.77, 1.35  # the bays of the side wall that hold the windows
BIN_UNDERSIDE = 1.58
BIN_ROUND_Y, BIN_ROUND_Z = 1.14, 1.90  # centre of the ellipse that rounds the bin
BIN_FACE = 0.68
BIN_TOP = 1.97
LIP = 0.02  # radius of the lip that hides the lamp
SHELF = 1.92
LAMP_INNER, LAMP_OUTER, LAMP_TOP = 0.93, 0.98, 1.97
CEILING_HALF_WIDTH, CEILING_RISE = 1.02, 0.33
STEP_RATIO = 3.0  # of wide to narrow steps along curves


@dataclass
class Curve:
    """Part of the cross-section."""

    points: np.ndarray  # (n, 2): y and z, m
    normals: np.ndarray  # (n, 2), unit vectors into the air


def line(start, end, normal, segments):
    """A straight part from start to end (y, z)."""
    t = np.linspace(0.0, 1.0, segments + 1)[:, None]
    points = (1.0 - t) * np.asarray(start) + t * np.asarray(end)
    normal = np.asarray(normal, dtype=float) / np.hypot(*normal)
    return Curve(points, np.tile(normal, (segments + 1, 1)))


def uneven(first, last, segments):
    """Values from first to last in steps that alternate between narrow and wide.

    So tessellated CAD surfaces come: where a narrow facet meets a wide one, their common points
    see the light of the wide one, unless registration knows about the curve.
    """
    steps = np.where(np.arange(segments) % 2 == 0, 1.0, STEP_RATIO)
    return first + (last - first) * np.concatenate([[0.0], np.cumsum(steps)]) / steps.sum()


def ellipse(centre, axes, degrees, segments, inward):
    """An arc of an ellipse; degrees: the first and the last angle, from +y towards +z."""
    angle = np.radians(uneven(*degrees, segments))
    circle = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    normals = circle / np.asarray(axes)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    return Curve(np.asarray(centre) + circle * axes, -normals if inward else normals)


def joined(*curves):
    """One smooth curve of several that touch end to end with the same normal there."""
    tail = curves[1:]
    return Curve(
        np.concatenate([curves[0].points] + [c.points[1:] for c in tail]),
        np.concatenate([curves[0].normals] + [c.normals[1:] for c in tail]),
    )


def wall_y(z):
    """Distance of the side wall from the aisle's centre plane (m) at height z (m)."""
    return WALL_A * np.cbrt(1.0 - np.abs((z - WALL_Z) / WALL_B) ** 3)


def wall(bottom, top, segments):
    """The side wall from one height to another (m)."""
    z = np.linspace(bottom, top, segments + 1)
    y = wall_y(z)
    height = (z - WALL_Z) / WALL_B
    normals = -np.stack([(y / WALL_A) ** 2 / WALL_A, height * np.abs(height) / WALL_B], axis=1)
    return Curve(np.stack([y, z], axis=1), normals / np.linalg.norm(normals, axis=1, keepdims=True))


def floor():
    """The whole floor, from wall to wall."""
    edge = wall_y(0.0)
    return line((edge, 0.0), (-edge, 0.0), (0.0, 1.0), 30)


def overhead_bin():
    """Underside, rounded front and lip of the overhead bin, from the wall to the cove's shelf."""
    inside = BIN_FACE + 2.0 * LIP
    axes = (BIN_ROUND_Y - BIN_FACE, BIN_ROUND_Z - BIN_UNDERSIDE)
    under = line((wall_y(BIN_UNDERSIDE), BIN_UNDERSIDE), (BIN_ROUND_Y, BIN_UNDERSIDE), (0, -1), 7)
    front = ellipse((BIN_ROUND_Y, BIN_ROUND_Z), axes, (270.0, 180.0), 11, inward=False)
    face = line((BIN_FACE, BIN_ROUND_Z), (BIN_FACE, BIN_TOP), (-1, 0), 2)
    lip = ellipse((BIN_FACE + LIP, BIN_TOP), (LIP, LIP), (180.0, 0.0), 4, inward=False)
    back = line((inside, BIN_TOP), (inside, SHELF), (1, 0), 2)
    return joined(under, front, face, lip, back)


def shelf():
    """Top of the bin behind the lip."""
    return line((BIN_FACE + 2.0 * LIP, SHELF), (LAMP_INNER, SHELF), (0, 1), 3)


def lamp():
    """The luminous strip: it shines up and inward at the ceiling, the lip hides it from below."""
    return line((LAMP_INNER, SHELF), (LAMP_OUTER, LAMP_TOP), (-1, 1), 1)


def ledge():
    """From the lamp to where the ceiling starts."""
    return line((LAMP_OUTER, LAMP_TOP), (CEILING_HALF_WIDTH, LAMP_TOP), (0, 1), 1)


def ceiling():
    """The whole curved ceiling, from cove to cove."""
    axes = (CEILING_HALF_WIDTH, CEILING_RISE)
    return ellipse((0.0, LAMP_TOP), axes, (0.0, 180.0), 17, inward=True)
