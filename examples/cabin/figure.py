# SPDX-License-Identifier: BSD-3-Clause
"""The cabin's picture: the view along the aisle on a logarithmic scale, a detail on a linear one."""

import matplotlib
import numpy as np
from PIL import Image

from comparison import with_array
from pictures import BAR, GAP, INK, MARGIN, TITLE, Camera, Page, Panel, Row, Scale, draw_row

WIDTH = 1400  # pixels
ALONG_THE_AISLE = Camera(position=(0.12, 0.0, 1.5), focus=(4.0, 0.0, 1.37), angle=62.0)
BIN_AND_SEATS = Camera(position=(1.0, -0.1, 1.62), focus=(2.7, 0.95, 1.42), angle=40.0)
BESIDE_COVE = Camera(position=(1.9, 0.1, 1.80), focus=(2.5, 0.85, 2.12), angle=50.0)
DECADES = "Decades of lux"  # point array: log10 of the illuminance, in lx


class LuxPage(Page):
    """A page whose bars read lux, also where the colours follow DECADES."""

    def bar(self, left, top, width, height, scale):
        if not scale.label.startswith(DECADES):
            super().bar(left, top, width, height, scale)
            return
        axes = self.place(left, top, width, height)
        axes.axis("on")
        norm = matplotlib.colors.LogNorm(10.0**scale.lowest, 10.0**scale.highest)
        bar = self.figure.colorbar(matplotlib.cm.ScalarMappable(norm, scale.colours), cax=axes)
        ticks = (20, 50, 100, 200, 500, 1000, 2000, 4000)
        bar.set_ticks([lux for lux in ticks if norm.vmin <= lux <= norm.vmax * 1.001])
        bar.ax.yaxis.set_major_formatter("{x:.0f}")
        bar.ax.minorticks_off()
        bar.set_label("Illuminance, lx (logarithmic)", color=INK, fontsize=13)
        bar.ax.tick_params(labelsize=12, colors=INK)
        bar.outline.set_visible(False)

    def save(self, path):
        """Writes the page as a small PNG: 226 colours of the map, 30 greys for the text."""
        super().save(path)
        colours = matplotlib.colormaps["inferno"](np.linspace(0.0, 1.0, 226))[:, :3]
        greys = np.repeat(np.linspace(0.1, 1.0, 30)[:, None], 3, axis=1)
        palette = Image.new("P", (1, 1))
        palette.putpalette(np.rint(255.0 * np.vstack([colours, greys])).astype(int).ravel().tolist())
        picture = Image.open(path).convert("RGB")
        picture.quantize(palette=palette, dither=Image.Dither.NONE).save(path, optimize=True)


def panels(maps, array, titled):
    """One panel for every registration's map, coloured by a point array."""
    return [Panel(title if titled else "", surface, array) for title, surface in maps.items()]


def with_decades(found, lowest):
    """The surface of an IlluminationMap with DECADES, dark places raised to lowest (lx)."""
    return with_array(found.surface, np.log10(np.maximum(found.array(), lowest)), DECADES)


def draw_page(path, rows):
    """Draws rows of equally many panels, the heads of the first above all."""
    count = len(rows[0].panels)
    panel = (WIDTH - 2 * MARGIN - BAR - (count - 1) * GAP) // count
    page = LuxPage(WIDTH, 2 * MARGIN + GAP + sum(TITLE + row.height for row in rows))
    top = MARGIN
    for row in rows:
        draw_row(page, row, top, panel, (1.0, 1.0, 1.0))
        top += TITLE + row.height + GAP
    page.save(path)


def aisle(maps, lowest, highest, height):
    """The row that shows maps (title -> IlluminationMap) along the aisle, from lowest to highest (lx)."""
    surfaces = {title: with_decades(found, lowest) for title, found in maps.items()}
    decades = Scale(DECADES, float(np.log10(lowest)), float(np.log10(highest)))
    return Row(decades, panels(surfaces, DECADES, True), ALONG_THE_AISLE, height)


def close_up(maps, highest, camera, height):
    """A row that shows them from near, up to highest (lx)."""
    surfaces = {title: found.surface for title, found in maps.items()}
    lux = Scale("Illuminance, lx", 0.0, highest)
    return Row(lux, panels(surfaces, "Illuminance", False), camera, height)


def draw_cabin(path, maps, lowest, highest, detail):
    """Draws the maps (title -> IlluminationMap): the aisle from lowest to highest (lx), a detail (lx)."""
    rows = [aisle(maps, lowest, highest, 400), close_up(maps, detail, BIN_AND_SEATS, 330)]
    draw_page(path, rows)


def draw_methods(path, maps, lowest, highest, near_cove):
    """The same with the ceiling beside the cove as the detail."""
    rows = [aisle(maps, lowest, highest, 470), close_up(maps, near_cove, BESIDE_COVE, 400)]
    draw_page(path, rows)
