# SPDX-License-Identifier: BSD-3-Clause
"""The picture and the table that set the registrations against the exact illuminance."""

import numpy as np
import vtk
from vtk.util.numpy_support import numpy_to_vtk

import tables
from pictures import Camera, Panel, Row, Scale, draw

CAMERA = Camera(position=(1.0, -5.2, 1.9), focus=(0.03, 0.0, -0.03), angle=20.0)
CLOSE = Camera(position=(2.4, -4.8, -0.6), focus=(-0.1, 0.0, -0.12), angle=14.5)
GREY = (0.42, 0.44, 0.47)


def below_or(share, error):
    """A share in percent; where it is within twice its standard error, what it is below."""
    return f"< {tables.text(200.0 * error, 2)}" if share < 2.0 * error else 100.0 * share


def accuracy_rows(results):
    """Rows of the table; all numbers in percent of the brightest point."""
    return [
        {
            "Registration": name,
            "RMS error, %": below_or(a.rms, a.rms_error),
            "its standard error": 100.0 * a.rms_error,
            "Largest error, %": 100.0 * a.largest,
            "Noise, %": 100.0 * a.noise,
        }
        for name, a in results.items()
    ]


def nice_step(about):
    """A step of 1, 2 or 5 times a power of ten, at least as large as asked for."""
    power = 10.0 ** np.floor(np.log10(about))
    return float(next(power * n for n in (1.0, 2.0, 5.0, 10.0) if power * n >= about * 0.999))


def with_array(surface, values, name):
    """A copy of a vtkPolyData with a point array more."""
    copy = vtk.vtkPolyData()
    copy.ShallowCopy(surface)
    array = numpy_to_vtk(np.ascontiguousarray(values), deep=1)
    array.SetName(name)
    copy.GetPointData().AddArray(array)
    return copy


def summary(results):
    """The table in short, for the picture."""
    lines = [("", "RMS", " largest", "noise")]
    for name, a in results.items():
        lines.append((name, *(f"{100.0 * share:.3f}" for share in (a.rms, a.largest, a.noise))))
    return tuple(lines)


def compare(path, heading, surface, exact, maps, results, figures):
    """Draws the exact illuminance and every registration's (lx), and below them the errors.

    figures: what to say behind the name of every picture, such as the paper's figure.
    A second picture, whose name ends in _close, shows the same from near.
    """
    step = nice_step(exact.max() / 10.0)
    top = step * float(np.ceil(exact.max() / step))
    worst = float(max(np.abs(values - exact).max() for values in maps.values()))
    lux = Scale("Illuminance, lx", 0.0, top, line_every=step)
    error = Scale("Error, lx", -worst, worst, "RdBu_r")
    upper = [
        Panel(f"{name} ({figures[name]})", with_array(surface, values, "Lux"), "Lux")
        for name, values in {"Exact": exact, **maps}.items()
    ]
    lower = [Panel("Errors, % of the brightest point", table=summary(results))] + [
        Panel(f"Error of {name}", with_array(surface, values - exact, "Error"), "Error")
        for name, values in maps.items()
    ]
    rows = [Row(lux, upper, CAMERA, 390), Row(error, lower, CAMERA, 390)]
    draw(path, rows, heading=heading, background=GREY)
    fine = Scale("Illuminance, lx", 0.0, top, line_every=nice_step(exact.max() / 25.0))
    close = path.with_name(f"{path.stem}_close.png")
    draw(close, [Row(fine, upper, CLOSE, 480)], heading=f"{heading}, from near", background=GREY)
