# SPDX-License-Identifier: BSD-3-Clause
"""Makes one of the two example states. Run by pvbatch: make_states.py room|garden OUTPUT_DIR.

All sources are ParaView's own, so that the states need no files.
"""

import os
import sys
from pathlib import Path

from paraview import simple


def named(create, name, **properties):
    return create(registrationName=name, **properties)


def show(source, view, array):
    """Shows a map by its values alone, unlit, with its colour bar in lx."""
    display = simple.Show(source, view)
    simple.ColorBy(display, ("POINTS", array))
    display.Ambient, display.Diffuse = 1.0, 0.0
    bar = simple.GetScalarBar(simple.GetColorTransferFunction(array), view)
    bar.Title, bar.ComponentTitle = "Illuminance (lx)", ""
    bar.TitleFontSize, bar.LabelFontSize = 14, 12
    display.SetScalarBarVisibility(view, True)
    return display


def box(name, lengths, centre):
    x, y, z = lengths
    return named(simple.Box, name, XLength=x, YLength=y, ZLength=z, Center=centre)


def room():
    """A room of 4 x 3 x 2.5 m with a table under a luminaire, in false colours and as it looks."""
    shell = named(simple.GenerateSurfaceNormals, "Normals inward", FlipNormals=1,
                  Input=box("Walls", (4, 3, 2.5), (0, 0, 1.25)))
    walls = named(simple.SurfaceMaterial, "White walls", Input=shell, Preset="White Paint")
    table = named(simple.SurfaceMaterial, "Grey table", Input=box("Table", (1.6, 0.8, 0.05), (0, 0, 0.72)),
                  Preset="Mid Grey")
    scene = named(simple.GroupDatasets, "Scene", Input=[walls, table])
    fine = named(simple.SurfaceRefinement, "Fine enough for photons", Input=scene, MaximumEdgeLength=0.12)
    lamp = named(simple.Luminaire, "Luminaire", LuminaireName="Pendant", Type="Rectangle", Position=[0, 0, 2.0],
                 Size=[1.2, 0.2], LuminousFlux=4000)
    lit = named(simple.IlluminationMap, "Illumination Map", Input=fine, Luminaires=[lamp])
    smooth = named(simple.IlluminationMapSmoothing, "Smoothing", Input=lit)
    look = named(simple.IlluminatedAppearance, "As it looks", Input=smooth, ExposureCompensation=1)

    false_colours = simple.CreateView("RenderView")
    seen = simple.CreateView("RenderView")
    layout = simple.CreateLayout("Room")
    layout.AssignView(0, false_colours)
    layout.SplitHorizontal(0, 0.5)
    layout.AssignView(2, seen)
    simple.SetActiveView(false_colours)
    # The wall in front is seen through from behind.
    show(smooth, false_colours, "IlluminanceSmoothed").BackfaceRepresentation = "Cull Backface"
    simple.Show(lamp, false_colours)
    simple.Show(look, seen)
    for view in (false_colours, seen):
        view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = (5.5, -5.0, 3.2), (0, 0, 1.1), (0, 0, 1)
    simple.AddCameraLink(false_colours, seen, "Both views")


def garden():
    """A ball and boxes on open ground under sun and sky, with isolux lines."""
    ground = named(simple.Plane, "Ground", Origin=[-4, -4, 0], Point1=[4, -4, 0], Point2=[-4, 4, 0],
                   XResolution=160, YResolution=160)
    ball = named(simple.Sphere, "Ball", Center=[-1.0, 0.3, 1.0], Radius=1.0, ThetaResolution=96, PhiResolution=64)
    block = named(simple.SurfaceRefinement, "Block", MaximumEdgeLength=0.08, Input=box("Box", (1, 1, 1.6), (1.4, -0.6, 0.8)))
    scene = named(simple.GroupDatasets, "Scene", Input=[ground, ball, block])
    sky = named(simple.Luminaire, "Sky", LuminaireName="Sky", Type="CIE Sky", Illuminance=15000, SunAltitude=35,
                SkyType="12 CIE standard clear sky, low luminance turbidity", Position=[-3, 3, 0], GlyphSize=0.6)
    sun = named(simple.Luminaire, "Sun", LuminaireName="Sun", Type="Parallel", Illuminance=70000,
                Direction=[0.0, 0.819, -0.574], Position=[3, -3, 2], GlyphSize=1.0)
    lit = named(simple.IlluminationMap, "Illumination Map", Input=scene, Luminaires=[sky, sun], LampContributions=1,
                Reflectance=0.3, Method="Final Gathering", Photons=500000)
    lines = named(simple.Contour, "Isolux lines", Input=lit, ContourBy=["POINTS", "Illuminance"],
                  Isosurfaces=[5000, 10000, 20000, 40000])
    view = simple.CreateView("RenderView")
    layout = simple.CreateLayout("Sun and sky")
    layout.AssignView(0, view)
    simple.SetActiveView(view)
    show(lit, view, "Illuminance")
    display = simple.Show(lines, view)
    simple.ColorBy(display, None)
    display.AmbientColor = display.DiffuseColor = (0.1, 0.1, 0.1)
    display.LineWidth = 2
    for lamp in (sky, sun):
        simple.Show(lamp, view)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = (2.5, -10, 6), (0, 0, 0.4), (0, 0, 1)


def main(name, folder):
    simple.LoadPlugin(os.environ["ILLUMINATION_PLUGIN"], ns=vars(simple))
    {"room": room, "garden": garden}[name]()
    simple.RenderAllViews()
    simple.SaveState(str(folder / f"{name}.pvsm"))
    picture = str(folder / f"{name}.png")
    simple.SaveScreenshot(picture, simple.GetLayout(), ImageResolution=[1400, 700], SeparatorWidth=1)


if __name__ == "__main__":
    main(sys.argv[1], Path(sys.argv[2]))
