# SPDX-License-Identifier: BSD-3-Clause
"""The pictures: the scene by facets, by the curved surface and exactly; and what filters make of meshes."""

from convergence import distances
from PIL import Image
from paraview import simple
from scene import SHAPES, refined

import bodies
from comparison import with_array
from illumination import as_source, through
from pictures import GAP, MARGIN, OVERSAMPLING, TITLE, Camera, Page, Panel, Row, Scale, draw
from pictures import captured, new_view

SHOWN_TURN = 3.0  # degrees: MaximumTurn of the bodies in the pictures
LUX = Scale("Illuminance, lx", 0.0, 700.0, clips=True)
FLOOR_LUX = Scale("Illuminance, lx", 0.0, 350.0)
GREY = (0.42, 0.44, 0.47)
WHOLE = Camera(position=(0.25, -4.3, 5.6), focus=(0.0, 0.85, 0.12), angle=25.0)
TORUS = Camera(position=(0.15, -1.6, 1.9), focus=(0.95, 0.45, 0.62), angle=22.0)
ABOVE = Camera(position=(0.0, 1.0, 9.0), focus=(0.0, 1.0, 0.0), up=(0.0, 1.0, 0.0), angle=21.5)


def draw_lit(path, found, ground, exact, exact_shapes, results):
    """Draws every mode's map (name -> Lit) and the exact one, from afar and from near."""
    flat, curved = found.values()
    rounder = refined(curved.surface, MaximumTurn=SHOWN_TURN)
    of_exact = [(ground, exact.lux), *exact_shapes.values()]
    truth = bodies.appended(*(with_array(s, lux, "Illuminance") for s, lux in of_exact))
    percent = [f"{100.0 * a.rms:.2g} %" for a in results.values()]
    panels = [
        Panel(f"CurvedSurface off: {percent[0]} off at outlines of shadows", flat.surface),
        Panel(f"CurvedSurface on: {percent[1]} off", rounder),
        Panel("Exact bodies, exact light", truth),
    ]
    names = ("The torus: silhouette and terminator", "", "")
    near = [Panel(name, panel.surface) for name, panel in zip(names, panels)]
    names = ("The floor from above: outlines of the shadows", "", "")
    maps = [lit.lux.mean(axis=0)[: len(exact.lux)] for lit in found.values()] + [exact.lux]
    above = [Panel(name, with_array(ground, lux, "Illuminance")) for name, lux in zip(names, maps)]
    rows = [Row(LUX, panels, WHOLE, 420), Row(LUX, near, TORUS, 420), Row(FLOOR_LUX, above, ABOVE, 420)]
    heading = "Cylinder of 8 sides, sphere of 16 × 8 and torus of 24 × 8 facets, and a lamp in their midst"
    draw(path, rows, heading=heading, background=GREY)


def photograph(surface, camera, pixels):
    """A picture of a shaded surface with its edges: (height, width, 3), 0 to 1."""
    source = as_source(surface)
    view = new_view(camera, pixels, (1.0, 1.0, 1.0))
    display = simple.Show(source, view)
    display.Representation = "Surface With Edges"
    display.ColorArrayName = [None, ""]
    display.SelectNormalArray = "None"
    display.Interpolation = "Flat"
    display.AmbientColor = display.DiffuseColor = [0.93, 0.80, 0.55]
    display.EdgeColor = [0.20, 0.22, 0.30]
    display.LineWidth = 0.6 * OVERSAMPLING
    display.Specular = 0.0
    return captured(view, [display, source])


FILTERS = {
    "Input": lambda surface: surface,
    "Subdivide (ParaView)": lambda s: through(simple.Subdivide, s, NumberofSubdivisions=2),
    "Loop Subdivision (ParaView)": lambda s: through(simple.LoopSubdivision, s, NumberofSubdivisions=2),
    "Surface Refinement, 12 degrees": lambda s: refined(s, MaximumTurn=12.0),
}


def draw_refinement(path):
    """Draws what each filter makes of the cylinder and the sphere; returns the rows of a table."""
    width, size, line = 2000, 420, 26
    page = Page(width, 2 * MARGIN + 2 * (TITLE + size + 2 * line) + GAP)
    step = (width - 2 * MARGIN) // len(FILTERS)
    rows = []
    for i, name in enumerate(("Sphere", "Cylinder")):
        shape = SHAPES[name]
        centre = shape.centre
        eye, focus = centre + (0.55, -1.75, 1.25), centre - (0.0, 0.0, 0.02)
        camera = Camera(tuple(eye), tuple(focus), angle=29.0)
        for j, (label, run) in enumerate(FILTERS.items()):
            surface = run(shape.mesh(*shape.coarse))
            mean, largest = (100.0 * d / shape.radius for d in distances(surface, shape))
            count = surface.GetNumberOfCells()
            left, top = MARGIN + j * step, MARGIN + i * (TITLE + size + 2 * line + GAP)
            page.write(left, top, label if i == 0 else "", fontsize=15, fontweight="bold")
            pixels = (step - GAP, size)
            image = photograph(surface, camera, pixels)
            page.place(left, top + TITLE, *pixels).imshow(image, interpolation="none", aspect="auto")
            text = f"{count} triangles\nup to {largest:.2g} % of the radius off the exact surface"
            page.write(left, top + TITLE + size, text, fontsize=13)
            rows.append({"Body": name, "Filter": label, "Triangles": count,
                         "Largest distance, % of the radius": largest, "Mean distance, %": mean})  # fmt: skip
    page.save(path)
    picture = Image.open(path).convert("RGB")
    picture.quantize(96, dither=Image.Dither.NONE).save(path, optimize=True)
    return rows
