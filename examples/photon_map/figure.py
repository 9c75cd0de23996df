# SPDX-License-Identifier: BSD-3-Clause
"""The picture: photons and their paths, and the illuminance that they tell of."""

import numpy as np
from paraview import simple
from scene import CENTRE, TO_SPHERE, exact_illuminance, whole_scene

import tables
from comparison import GREY, accuracy_rows, with_array
from illumination import as_source
from pictures import BAR, GAP, MARGIN, TITLE, Camera, Page, Panel, Row, Scale
from pictures import captured, draw_row, new_view, reduce_colours

WIDTH, HEADING, SCENE_HEIGHT, PANEL_HEIGHT = 2000, 46, 620, 400  # pixels
FROM_THE_SIDE = Camera(position=(0.2, -5.0, 1.1), focus=(-0.50, 0.0, -0.37), angle=22.5)
LIT_SIDE = Camera(CENTRE - 4.4 * (TO_SPHERE + (-0.3, 0.7, 0.0)), CENTRE, angle=12.6)
LUX, ERROR = Scale("Illuminance, lx", 0.0, 600.0), Scale("Error, lx", -100.0, 100.0, "RdBu_r")
DARK, BODY = (0.10, 0.11, 0.13), [0.19, 0.20, 0.22]
DIRECT, SCATTERED = (1.0, 0.67, 0.24), (0.35, 0.75, 1.0)
CHANGE = 0.02  # scatterings, along a path: where its colour changes


def show(source, view, **properties):
    """Shows a source without light or shadow; returns what has to be deleted."""
    display = simple.Show(source, view)
    display.Ambient, display.Diffuse, display.Specular = 1.0, 0.0, 0.0
    for name, value in properties.items():
        setattr(display, name, value)
    return [display, source]


def show_by_scatterings(data, view, **properties):
    """Shows photons or their paths in two colours; returns what has to be deleted."""
    shown = show(as_source(data), view, **properties)
    simple.ColorBy(shown[0], ("POINTS", "Scatterings"))
    shown[0].InterpolateScalarsBeforeMapping = 1
    table = simple.GetColorTransferFunction("Scatterings")
    steps = [(0.0, DIRECT), (CHANGE, DIRECT), (2.0 * CHANGE, SCATTERED), (1.0, SCATTERED)]
    table.ColorSpace = "RGB"
    table.RGBPoints = [number for value, colour in steps for number in (value, *colour)]
    table.AutomaticRescaleRangeMode = "Never"
    return shown


def photograph(surface, run, pixels):
    """The photons and paths of a run: (height, width, 3), 0 to 1."""
    view = new_view(FROM_THE_SIDE, pixels, DARK)
    body = as_source(surface)
    shown = show(body, view, ColorArrayName=[None, ""], AmbientColor=BODY, DiffuseColor=BODY)
    shown += show_by_scatterings(run.photons, view, PointSize=2.0, Opacity=0.3)
    shown += show_by_scatterings(run.paths, view, LineWidth=1.5, Opacity=0.5)
    return captured(view, shown)


def rows(sphere, found, exact):
    """Panels of what each way gives and of its errors, in lx."""
    lux = [Panel(name, with_array(sphere, v, "Lux"), "Lux") for name, v in found.items()]
    off = [
        Panel(f"{name}: error", with_array(sphere, v - exact, "Error"), "Error")
        for name, v in found.items()
    ]
    return [Row(LUX, lux, LIT_SIDE, PANEL_HEIGHT), Row(ERROR, off, LIT_SIDE, PANEL_HEIGHT)]


EXPLANATION = """A map registers each photon on the corners of its triangle.
The density at a point is the flux of its 200 nearest photons
over the area of the disk that holds them. Both show the flat
facets, until each photon counts with the ratio of its cosines
to the smooth normal and to the facet's."""


def table_of(results):
    """The errors as lines of text."""
    lines = [("", "RMS", "largest", "noise")]
    for row in accuracy_rows(results):
        cells = (row[f"{name}, %"] for name in ("RMS error", "Largest error", "Noise"))
        lines.append((row["Registration"], *(tables.text(cell, 2) for cell in cells)))
    return tuple(lines)


def draw_legend(page, left, top, results):
    """What the colours of photons mean, and the table of errors."""
    for i, (colour, text) in enumerate(
        ((DIRECT, "from the lamp, not yet scattered"), (SCATTERED, "scattered once, by the disk"))
    ):
        page.write(left, top + 34 * i, "\u25cf", fontsize=19, color=colour)
        page.write(left + 30, top + 2 + 34 * i, text, fontsize=15)
    page.write(left, top + 100, EXPLANATION, fontsize=14, linespacing=1.5)
    page.write(left, top + 330, "Errors, % of the brightest point", fontsize=15, fontweight="bold")
    page.table(left, top + 370, 560, table_of(results))


def draw_photon_map(path, sphere, run, found, results):
    """Draws everything into a PNG. found: illuminance (lx) by run's photons; results: of all runs."""
    wide = [*rows(sphere, found, exact_illuminance(sphere))]
    height = HEADING + 2 * MARGIN + SCENE_HEIGHT + 2 * (GAP + TITLE + PANEL_HEIGHT)
    page = Page(WIDTH, height)
    heading = "A lamp lights a disk, and the disk a coarse sphere: photons, some of their paths, and their map"
    page.write(MARGIN, MARGIN, heading, fontsize=19, fontweight="bold")
    top, scene = MARGIN + HEADING, (1340, SCENE_HEIGHT)
    image = photograph(whole_scene(sphere), run, scene)
    page.place(MARGIN, top, *scene).imshow(image, interpolation="none", aspect="auto")
    draw_legend(page, MARGIN + scene[0] + 40, top + 40, results)
    panel = (WIDTH - 2 * MARGIN - BAR - 3 * GAP) // 4
    top += SCENE_HEIGHT + GAP
    for row in wide:
        draw_row(page, row, top, panel, GREY)
        top += TITLE + PANEL_HEIGHT + GAP
    page.save(path)
    blends = np.linspace(0.0, 1.0, 15)[:, None]
    of_photons = [DARK + blends * (np.array(colour) - DARK) for colour in (DIRECT, SCATTERED)]
    reduce_colours(path, [LUX.colours, ERROR.colours], np.vstack([*of_photons, GREY]))
