# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of illumination maps: panels side by side, one colour scale and one bar a row.

The colours are the values and nothing else: no shading, no lights.
"""

import tempfile
from dataclasses import dataclass
from pathlib import Path

import matplotlib
import numpy as np
from paraview import simple
from PIL import Image

from illumination import as_source

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  (the backend comes first)

OVERSAMPLING = 2  # pixels rendered per pixel shown, along each side
INK = "#202020"
LINE_COLOUR = [0.0, 0.0, 0.0]
NO_VALUE = [0.62, 0.64, 0.67]  # of points whose value is no number
MARGIN, GAP, TITLE, BAR = 16, 14, 34, 110  # pixels of the page


@dataclass
class Camera:
    """Where the pictures are taken from; lengths in the data's unit."""

    position: tuple
    focus: tuple
    up: tuple = (0.0, 0.0, 1.0)
    angle: float = 30.0  # vertical field of view, degrees


@dataclass
class Scale:
    """The colours of a row of panels."""

    label: str  # what the colours mean, with its unit
    lowest: float
    highest: float
    colours: str = "inferno"  # matplotlib's name
    line_every: float = 0.0  # draws a line where the value is a multiple of this; 0: none
    clips: bool = False  # some values are beyond highest; the bar then ends in an arrow


@dataclass
class Panel:
    """One picture: a surface coloured by a point array, or, without a surface, a small table."""

    title: str
    surface: object = None  # a VTK data object
    array: str = "Illuminance"
    table: tuple = ()  # lines of text cells, the first line its heads
    culled: bool = False  # the sides from which corners run clockwise are not seen


@dataclass
class Row:
    """Panels side by side with one bar for all."""

    scale: Scale
    panels: list
    camera: Camera
    height: int  # pixels; the figure's width is shared by the panels


def new_view(camera, pixels, background):
    """A view that shows nothing but the surfaces."""
    view = simple.CreateView("RenderView")
    view.ViewSize = [OVERSAMPLING * n for n in pixels]
    view.OrientationAxesVisibility = 0
    view.CenterAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = background
    view.CameraPosition = camera.position
    view.CameraFocalPoint = camera.focus
    view.CameraViewUp = camera.up
    view.CameraViewAngle = camera.angle
    return view


def colour_by(display, array, scale):
    """Colours a representation by a point array, unlit and exactly as matplotlib would."""
    simple.ColorBy(display, ("POINTS", array))
    table = simple.GetColorTransferFunction(array)
    steps = np.linspace(0.0, 1.0, 256)
    values = scale.lowest + (scale.highest - scale.lowest) * steps
    colours = matplotlib.colormaps[scale.colours](steps)[:, :3]
    table.ColorSpace = "RGB"
    table.RGBPoints = np.column_stack([values, colours]).ravel().tolist()
    table.NanColor = NO_VALUE
    table.AutomaticRescaleRangeMode = "Never"


def show_lines(source, view, array, scale):
    """Draws thin lines of equal value; returns what has to be deleted afterwards."""
    first = np.ceil(scale.lowest / scale.line_every) * scale.line_every
    values = np.arange(first, scale.highest, scale.line_every)
    lines = simple.Contour(Input=source, ContourBy=["POINTS", array], Isosurfaces=values.tolist())
    lines.ComputeScalars = 0
    display = simple.Show(lines, view)
    display.ColorArrayName = [None, ""]
    display.AmbientColor = display.DiffuseColor = LINE_COLOUR
    display.Ambient, display.Diffuse = 1.0, 0.0
    display.LineWidth = 1.0 * OVERSAMPLING
    return [display, lines]


def captured(view, shown):
    """The picture that a view shows, each pixel the mean of those rendered for it: (height, width, 3),
    0 to 1. Deletes what it shows, each given before what it depends on, and then the view.
    """
    with tempfile.TemporaryDirectory() as folder:
        file = str(Path(folder) / "view.png")
        simple.SaveScreenshot(file, view, ImageResolution=view.ViewSize)
        image = pyplot.imread(file)[..., :3]
    for proxy in [*shown, view]:
        simple.Delete(proxy)
    rows, columns = (n // OVERSAMPLING for n in image.shape[:2])
    return image.reshape(rows, OVERSAMPLING, columns, OVERSAMPLING, 3).mean(axis=(1, 3))


def snapshot(surface, array, scale, camera, pixels, background, culled=False):
    """The picture of a surface as an array of (height, width, 3), 0 to 1.

    scale: None for an array that holds colours, 8 bits each. culled: see Panel.
    """
    source = as_source(surface)
    view = new_view(camera, pixels, background)
    display = simple.Show(source, view)
    display.Ambient, display.Diffuse, display.Specular = 1.0, 0.0, 0.0
    display.BackfaceRepresentation = "Cull Backface" if culled else "Follow Frontface"
    shown = [display]
    if scale is None:
        simple.ColorBy(display, ("POINTS", array))
        display.MapScalars = 0
    else:
        display.InterpolateScalarsBeforeMapping = 1
        colour_by(display, array, scale)
        shown += show_lines(source, view, array, scale) if scale.line_every else []
    return captured(view, [*shown, source])


def appearance(path, source, camera, pixels, background=(0.0, 0.0, 0.0)):
    """Writes a picture of how an Illuminated Appearance looks as a PNG. pixels: width and height."""
    view = new_view(camera, pixels, background)
    image = captured(view, [simple.Show(source, view)])
    path.parent.mkdir(parents=True, exist_ok=True)
    Image.fromarray(np.rint(255.0 * image).astype(np.uint8)).save(path, optimize=True)


class Page:
    """A page that is measured in pixels from its top left corner."""

    def __init__(self, width, height):
        self.size = np.array([width, height])
        self.figure = pyplot.figure(figsize=self.size / 100.0, dpi=100, facecolor="white")

    def place(self, left, top, width, height):
        """Axes for a part of the page, without frame and ticks."""
        bottom = self.size[1] - top - height
        axes = self.figure.add_axes(np.array([left, bottom, width, height]) / np.tile(self.size, 2))
        axes.axis("off")
        return axes

    def write(self, left, top, text, **style):
        """Text whose top left corner is given, unless the style says otherwise."""
        place = np.array([left, self.size[1] - top]) / self.size
        style = {"color": INK, "verticalalignment": "top", **style}
        self.figure.text(*place, text, **style)

    def table(self, left, top, width, lines):
        """Lines of cells: the first column starts at the left, the others end at even steps."""
        step = 0.55 * width / (len(lines[0]) - 1)
        for i, cells in enumerate(lines):
            style = {"fontsize": 14, "color": "#707070" if i == 0 else INK}
            self.write(left, top + 32 * i, cells[0], **style)
            for j, cell in enumerate(cells[1:]):
                right = left + 0.45 * width + (j + 1) * step
                self.write(right, top + 32 * i, cell, horizontalalignment="right", **style)

    def bar(self, left, top, width, height, scale):
        """The bar of a row's colours."""
        axes = self.place(left, top, width, height)
        axes.axis("on")
        norm = matplotlib.colors.Normalize(scale.lowest, scale.highest)
        colours = matplotlib.cm.ScalarMappable(norm, scale.colours)
        extend = "max" if scale.clips else "neither"
        bar = self.figure.colorbar(colours, cax=axes, extend=extend, extendfrac=0.03)
        lines = f"  (a line every {scale.line_every:g})" if scale.line_every else ""
        bar.set_label(scale.label + lines, color=INK, fontsize=13)
        bar.ax.tick_params(labelsize=12, colors=INK)
        bar.outline.set_visible(False)

    def save(self, path):
        """Writes the page as a PNG."""
        path.parent.mkdir(parents=True, exist_ok=True)
        self.figure.savefig(path)
        pyplot.close(self.figure)
        print(f"Picture: {path}", flush=True)


def reduce_colours(path, colours, background):
    """Makes a PNG small: keeps the colours of maps (matplotlib's names), greys and a background.

    background: one colour, or some (n, 3).
    """
    others = np.atleast_2d(background)
    steps = min(216, 220 - len(others)) // len(colours)
    palette = [matplotlib.colormaps[name](np.linspace(0.0, 1.0, steps))[:, :3] for name in colours]
    palette += [np.repeat(np.linspace(0.0, 1.0, 36)[:, None], 3, axis=1), others]
    table = Image.new("P", (1, 1))
    table.putpalette(np.rint(255.0 * np.vstack(palette)).astype(int).ravel().tolist())
    picture = Image.open(path).convert("RGB")
    picture.quantize(palette=table, dither=Image.Dither.NONE).save(path, optimize=True)


def draw_row(page, row, top, width, background):
    """One row of panels at a height of the page."""
    for i, panel in enumerate(row.panels):
        left = MARGIN + i * (width + GAP)
        page.write(left, top, panel.title, fontsize=15, fontweight="bold")
        if panel.surface is None:
            page.table(left, top + TITLE, width, panel.table)
            continue
        pixels = (width, row.height)
        image = snapshot(
            panel.surface, panel.array, row.scale, row.camera, pixels, background, panel.culled)  # fmt: skip
        page.place(left, top + TITLE, *pixels).imshow(image, interpolation="none", aspect="auto")
    left = MARGIN + len(row.panels) * (width + GAP)
    page.bar(left, top + TITLE, 22, row.height, row.scale)


def draw(path, rows, width=2000, heading="", background=(1.0, 1.0, 1.0)):
    """Draws rows of equally many panels, with a heading, into a PNG that is width pixels wide."""
    head = 46 if heading else 0
    height = head + 2 * MARGIN + sum(TITLE + row.height for row in rows) + GAP * (len(rows) - 1)
    page = Page(width, height)
    page.write(MARGIN, MARGIN, heading, fontsize=19, fontweight="bold")
    count = len(rows[0].panels)
    panel = (width - 2 * MARGIN - BAR - (count - 1) * GAP) // count
    top = MARGIN + head
    for row in rows:
        draw_row(page, row, top, panel, background)
        top += TITLE + row.height + GAP
    page.save(path)
    reduce_colours(path, sorted({row.scale.colours for row in rows}), background)
