# SPDX-License-Identifier: BSD-3-Clause
"""The evening's picture: how diffuse surfaces look, and beside it the illuminance in lux."""

import matplotlib
import numpy as np
from PIL import Image
from vtk.util.numpy_support import vtk_to_numpy

from comparison import with_array
from pictures import BAR, GAP, INK, MARGIN, TITLE, Camera, Page, Scale, snapshot

WIDTH = 1400  # pixels
EXPOSURE = 0.15  # per cd/m^2
LUX = (0.5, 500.0)  # shown, logarithmic
VIEWS = (  # camera and height in pixels
    (Camera(position=(4.74, -0.32, 1.46), focus=(2.6, 0.5, 1.1), angle=64.0), 440),
    (Camera(position=(4.73, 0.28, 1.2), focus=(3.72, 1.13, 1.09), angle=60.0), 440),
)


def at_points(surface, name):
    """A cell array at the points of its cells, for parts that share none with others."""
    corners = vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)
    values = vtk_to_numpy(surface.GetCellData().GetArray(name))
    out = np.zeros((surface.GetNumberOfPoints(), *values.shape[1:]))
    out[corners] = values[:, None]
    return out


def looks(surface, illuminance):
    """The surface with a point array Looks: 8 bits of sRGB for red, green and blue illuminance (lx).

    The luminance of a Lambertian surface is reflectance times illuminance over pi; one exposure
    for all, bright places run softly into white.
    """
    luminance = at_points(surface, "DiffuseReflectance") * illuminance / np.pi
    linear = 1.0 - np.exp(-EXPOSURE * luminance)
    curve = 1.055 * np.maximum(linear, 0.0031308) ** (1.0 / 2.4) - 0.055  # sRGB, IEC 61966-2-1
    encoded = np.where(linear <= 0.0031308, 12.92 * linear, curve)
    return with_array(surface, np.rint(255.0 * encoded).astype(np.uint8), "Looks")


class EveningPage(Page):
    """A page whose bar reads lux where the colours follow their logarithm."""

    def bar(self, left, top, width, height, scale):
        axes = self.place(left, top, width, height)
        axes.axis("on")
        norm = matplotlib.colors.LogNorm(*LUX)
        bar = self.figure.colorbar(matplotlib.cm.ScalarMappable(norm, scale.colours), cax=axes)
        bar.set_ticks([0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500])
        bar.ax.yaxis.set_major_formatter("{x:g}")
        bar.ax.minorticks_off()
        bar.set_label(scale.label, color=INK, fontsize=13)
        bar.ax.tick_params(labelsize=12, colors=INK)
        bar.outline.set_visible(False)


def draw_evening(path, surface, illuminance, lux):
    """Draws both views of a surface with materials; illuminance: red, green and blue; lux: both in lx."""
    scale = Scale("Illuminance, lx (logarithmic)", *np.log10(LUX).tolist())
    columns = (
        ("As diffuse surfaces look: reflectance × illuminance", looks(surface, illuminance), "Looks", None),
        ("Illuminance", with_array(surface, np.log10(np.maximum(lux, LUX[0])), "Decades"), "Decades", scale),
    )  # fmt: skip
    width = (WIDTH - 2 * MARGIN - BAR - GAP) // 2
    page = EveningPage(WIDTH, 2 * MARGIN + TITLE + sum(height + GAP for _, height in VIEWS) - GAP)
    for i, (title, data, array, colours) in enumerate(columns):
        left, top = MARGIN + i * (width + GAP), MARGIN + TITLE
        page.write(left, MARGIN, title, fontsize=15, fontweight="bold")
        for camera, height in VIEWS:
            image = snapshot(data, array, colours, camera, (width, height), (0.0, 0.0, 0.0))
            page.place(left, top, width, height).imshow(image, interpolation="none", aspect="auto")
            top += height + GAP
    page.bar(MARGIN + 2 * (width + GAP), MARGIN + TITLE, 22, top - GAP - MARGIN - TITLE, scale)
    page.save(path)
    Image.open(path).convert("RGB").save(path, optimize=True)
