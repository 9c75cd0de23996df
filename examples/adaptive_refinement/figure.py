# SPDX-License-Identifier: BSD-3-Clause
"""The picture: the room before and after refinement, and the refined triangles."""

from paraview import simple

from illumination import as_source
from pictures import GAP, INK, MARGIN, OVERSAMPLING, TITLE, Camera, Page, Scale
from pictures import captured, colour_by, new_view, reduce_colours

WIDTH, HEIGHT, BAR = 2000, 560, 110  # pixels
LUX = Scale("Illuminance, lx", 0.0, 160.0, clips=True)
WHOLE = Camera(position=(2.3, -4.6, 4.9), focus=(2.0, 1.55, 0.45), angle=27.0)
NEAR = Camera(position=(2.9, -0.9, 2.1), focus=(2.45, 1.5, 0.25), angle=33.0)
BACKGROUND = (1.0, 1.0, 1.0)


def seen(surface, camera, lines):
    """A picture of a map from outside the room, through the backs of its walls."""
    source = as_source(surface)
    pixels = ((WIDTH - 2 * MARGIN - BAR - 2 * GAP) // 3, HEIGHT)
    view = new_view(camera, pixels, BACKGROUND)
    display = simple.Show(source, view)
    display.Representation = "Surface With Edges" if lines else "Surface"
    display.BackfaceRepresentation = "Cull Backface"
    display.InterpolateScalarsBeforeMapping = 1
    display.Ambient, display.Diffuse, display.Specular = 1.0, 0.0, 0.0
    display.EdgeColor = [0.45, 0.55, 0.75]
    display.LineWidth = 0.4 * OVERSAMPLING
    colour_by(display, "Illuminance", LUX)
    return captured(view, [display, source])


def draw_room(path, before, after):
    """Draws both maps from afar and from near."""
    panels = [
        (f"Two triangles a wall: {before.GetNumberOfCells()} triangles", before, True),
        (f"AdaptiveRefinement: {after.GetNumberOfCells()} triangles", after, False),
        ("Its triangles", after, True),
    ]
    page = Page(WIDTH, 2 * MARGIN + TITLE + 2 * HEIGHT + GAP)
    for j, (title, surface, lines) in enumerate(panels):
        for i, camera in enumerate((WHOLE, NEAR)):
            image = seen(surface, camera, lines)
            width = image.shape[1]
            left, top = MARGIN + j * (width + GAP), MARGIN + TITLE + i * (HEIGHT + GAP)
            page.place(left, top, width, HEIGHT).imshow(image, interpolation="none", aspect="auto")
        page.write(left, MARGIN, title, fontsize=15, fontweight="bold", color=INK)
    page.bar(WIDTH - MARGIN - BAR + GAP, MARGIN + TITLE, 22, 2 * HEIGHT + GAP, LUX)
    page.save(path)
    reduce_colours(path, [LUX.colours], BACKGROUND)
