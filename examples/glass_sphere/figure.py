# SPDX-License-Identifier: BSD-3-Clause
"""The picture of the caustic: the scene, the floor from above, and charts over the distance."""

import matplotlib
import numpy as np
from glass_sphere import COARSE, FINE, GLASS, ILLUMINANCE, RINGS
from glass_sphere import floor, glass, mean_and_error, triangles
from matplotlib.ticker import FixedLocator, FuncFormatter, NullFormatter
from paraview import simple

import bodies
from comparison import with_array
from exact_caustic import fresnel
from illumination import as_source
from pictures import GAP, INK, MARGIN, TITLE, Camera, Page, Scale
from pictures import captured, colour_by, new_view

WIDTH, SCENE, PLAN = 2000, (900, 520), (443, 400)  # pixels
DECADES = "Decades of lux"  # point array: log10 of the illuminance, in lx
SCALE = Scale(DECADES, 1.0, 5.0, clips=True)
FROM_THE_SIDE = Camera(position=(0.0, -0.80, 0.36), focus=(0.0, 0.0, 0.066), angle=22.0)
FROM_ABOVE = Camera(position=(0.0, 0.0, 0.8), focus=(0.0, 0.0, 0.0), up=(0.0, 1.0, 0.0), angle=4.0)
BACKGROUND = (0.16, 0.17, 0.19)
COLOURS = {COARSE: "#c05000", FINE: "#0060a8"}
GREY, FAINT = "#707070", "#e4e4e4"


def floor_with(lux):
    """The floor, with decades of its points' illuminance in lx."""
    values = np.clip(np.log10(np.maximum(lux, 1e-9)), SCALE.lowest, SCALE.highest)
    return with_array(floor(), values, DECADES)


def seen_glass(size, camera):
    """The sphere with its colours as one sees glass: it mirrors most at its edge, and the lamp."""
    surface = glass(size)
    points, normals = bodies.points_and_normals(surface)
    to_eye = np.array(camera.position) - points
    to_eye /= np.linalg.norm(to_eye, axis=1, keepdims=True)
    cosine = np.clip(np.einsum("ij,ij->i", to_eye, normals), 1e-3, 0.999999)
    mirrored = fresnel(np.arccos(cosine), np.arcsin(np.sqrt(1.0 - cosine**2) / GLASS.index))
    halfway = to_eye + (0.0, 0.0, 1.0)
    halfway /= np.linalg.norm(halfway, axis=1, keepdims=True)
    lamp = np.exp(-((1.0 - np.einsum("ij,ij->i", halfway, normals)) / 0.002))
    colours = np.empty((len(points), 4), dtype=np.uint8)
    colours[:, :3] = (225, 238, 255)
    colours[:, 3] = 255.0 * np.clip(0.07 + 0.9 * mirrored + lamp, 0.0, 1.0)
    return with_array(surface, colours, "Seen")


def show_glass(view, size, camera):
    """Shows the sphere as something to look through; returns what has to be deleted."""
    source = as_source(seen_glass(size, camera))
    display = simple.Show(source, view)
    display.BackfaceRepresentation = "Cull Backface"
    simple.ColorBy(display, ("POINTS", "Seen"))
    display.MapScalars = 0
    display.Ambient, display.Diffuse, display.Specular = 1.0, 0.0, 0.0
    return [display, source]


def photograph(lux, camera, pixels, sphere=None):
    """The floor's picture, with the sphere if its size is told: (height, width, 3), 0 to 1."""
    source = as_source(floor_with(lux))
    view = new_view(camera, pixels, BACKGROUND)
    display = simple.Show(source, view)
    display.InterpolateScalarsBeforeMapping = 1
    display.Ambient, display.Diffuse, display.Specular = 1.0, 0.0, 0.0
    colour_by(display, DECADES, SCALE)
    shown = show_glass(view, sphere, camera) if sphere else []
    return captured(view, [display, *shown, source])


def lux_bar(page, left, top, width, height):
    """The bar of the colours, in lux."""
    axes = page.place(left, top, width, height)
    axes.axis("on")
    norm = matplotlib.colors.LogNorm(10.0**SCALE.lowest, 10.0**SCALE.highest)
    colours = matplotlib.cm.ScalarMappable(norm, SCALE.colours)
    bar = page.figure.colorbar(colours, cax=axes, extend="both", extendfrac=0.02)
    bar.ax.yaxis.set_major_formatter(FuncFormatter(lambda lux, _: f"{lux:,.0f}".replace(",", " ")))
    bar.ax.minorticks_off()
    bar.set_label("Illuminance, lx (logarithmic)", color=INK, fontsize=13)
    bar.ax.tick_params(labelsize=12, colors=INK)
    bar.outline.set_visible(False)


def chart(page, box, label, last=False):
    """Axes over the distance from the axis, in mm, logarithmic."""
    axes = page.place(*box)
    axes.axis("on")
    axes.set_xscale("log")
    axes.set_xlim(0.4, 1000.0 * RINGS.radii[-1])
    axes.set_ylabel(label, color=INK, fontsize=13)
    axes.grid(True, which="major", color=FAINT, linewidth=0.7)
    axes.set_axisbelow(True)
    axes.xaxis.set_major_locator(FixedLocator([0.5, 1, 2, 5, 10, 20, 50, 100, 200]))
    axes.xaxis.set_minor_formatter(NullFormatter())
    axes.xaxis.set_major_formatter(FuncFormatter(lambda mm, _: f"{mm:g}"))
    axes.tick_params(colors=INK, labelsize=12, labelbottom=last)
    if last:
        axes.set_xlabel("Distance from the axis, mm", color=INK, fontsize=13)
    for side in ("top", "right"):
        axes.spines[side].set_visible(False)
    return axes


def dots(axes, size, values, errors):
    """Traced values of all rings but the centre, with 5 standard errors to either side."""
    axes.errorbar(
        1000.0 * RINGS.radii[1:], values[1:], 5.0 * errors[1:], linestyle="", marker="o",
        markersize=3.4, elinewidth=1.1, color=COLOURS[size], label=triangles(size),
    )  # fmt: skip


def draw_charts(page, left, exact, caustics):
    """Illuminance, encircled flux and the latter's deviations."""
    width, heights, tops = WIDTH - MARGIN - left, (430, 205, 205), (MARGIN + 46 + TITLE, 552, 783)
    distance = 1000.0 * RINGS.radii[1:]
    lux = chart(page, (left, tops[0], width, heights[0]), "Mean illuminance of a ring, lx")
    lux.set_yscale("log")
    lux.set_ylim(3.0, 1e6)
    line = {"color": INK, "linewidth": 1.2, "label": "exact, smooth sphere"}
    lux.plot(distance, (exact / RINGS.areas())[1:], **line)
    flux = chart(page, (left, tops[1], width, heights[1]), "Flux within, lm")
    flux.plot(distance, np.cumsum(exact)[1:], **line)
    flux.set_ylim(0.0, 50.0)
    off = chart(page, (left, tops[2], width, heights[2]), "Flux within: off, %", last=True)
    off.axhline(0.0, color=INK, linewidth=1.2)
    off.set_ylim(-5.0, 3.0)
    for size, found in caustics.items():
        within, error = mean_and_error(found.encircled())
        wanted = np.cumsum(exact)
        dots(off, size, 100.0 * (within / wanted - 1.0), 100.0 * error / wanted)
        if size == FINE:
            mean, ring_error = mean_and_error(found.fluxes() / RINGS.areas())
            dots(lux, size, mean, ring_error)
            dots(flux, size, within, error)
    lux.legend(fontsize=13, frameon=False, loc="upper right")
    off.legend(fontsize=13, frameon=False, loc="lower right")


def exact_lux(exact):
    """The exact illuminance of the floor's points, in lx."""
    by_ring = exact / RINGS.areas()
    return np.append(by_ring[0], np.repeat(by_ring[1:], RINGS.sides))


def draw_caustic(path, exact, caustics):
    """Draws everything into a PNG; caustics: size of the sphere's mesh -> Caustic."""
    page = Page(WIDTH, 46 + 2 * MARGIN + 2 * TITLE + SCENE[1] + GAP + PLAN[1])
    light = f"parallel light of {ILLUMINANCE:.0f} lx"
    heading = f"Glass sphere, refractive index {GLASS.index}, in {light}"
    page.write(MARGIN, MARGIN, heading, fontsize=19, fontweight="bold")
    traced = caustics[FINE].lux.mean(axis=0)
    top = MARGIN + 46
    page.write(MARGIN, top, "The light on the floor", fontsize=15, fontweight="bold")
    image = photograph(traced, FROM_THE_SIDE, SCENE, FINE)
    page.place(MARGIN, top + TITLE, *SCENE).imshow(image, interpolation="none", aspect="auto")
    below = top + TITLE + SCENE[1] + GAP
    plans = {"From above, 62 × 56 mm: traced": traced, "Exact": exact_lux(exact)}
    for i, (title, lux) in enumerate(plans.items()):
        left = MARGIN + i * (PLAN[0] + GAP)
        page.write(left, below, title, fontsize=15, fontweight="bold")
        image = photograph(lux, FROM_ABOVE, PLAN)
        page.place(left, below + TITLE, *PLAN).imshow(image, interpolation="none", aspect="auto")
    right = MARGIN + SCENE[0] + GAP
    lux_bar(page, right, top + TITLE, 22, below + PLAN[1] - top)
    draw_charts(page, right + 210, exact, caustics)
    title = "Against the distance from the axis"
    page.write(right + 210, top, title, fontsize=15, fontweight="bold")
    page.save(path)
