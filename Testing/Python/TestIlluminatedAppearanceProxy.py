# SPDX-License-Identifier: BSD-3-Clause
"""The proxy IlluminatedAppearance, and how ParaView shows it: unlit, from the lit side only."""
import numpy as np
from paraview import servermanager, simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter
from vtkIllumination import vtkIlluminatedAppearance

import proxies

PROPERTIES = {
    "IlluminanceArray": "Illuminance",
    "ReflectanceArray": "Rho",
    "Reflectance": 0.25,
    "ExitanceArray": "None",
    "AdaptationLuminance": 30.0,
    "ExposureCompensation": -1.5,
    "HighlightCompression": 0.75,
    "WhiteLuminance": 900.0,
    "WhiteBalance": ("By Colour", 2),
    "WhiteColour": [1.0, 0.75, 0.5],
}


def test_defaults_and_help():
    proxy = IlluminatedAppearance(Input=IlluminationMap(Input=simple.Sphere()))
    proxies.check_documented(proxy, PROPERTIES)
    proxies.check_defaults(proxy, vtkIlluminatedAppearance(), PROPERTIES)


def test_each_property_reaches_the_filter():
    proxies.check_reach(IlluminatedAppearance(Input=IlluminationMap(Input=simple.Sphere())), PROPERTIES)


def test_states_bring_everything_back():
    lit = IlluminationMap(registrationName="lit", Input=simple.Sphere(), Photons=4096)
    proxy = IlluminatedAppearance(registrationName="look", Input=lit)
    proxies.set_all(proxy, PROPERTIES)
    proxies.check_python_state("look", PROPERTIES)
    proxies.pass_through_a_state()
    proxies.check_all(simple.FindSource("look"), PROPERTIES)


def picture(view):
    """What a view shows, (height, width, 3), 8 bits."""
    simple.Render(view)
    grab = vtkWindowToImageFilter()
    grab.SetInput(view.GetRenderWindow())
    grab.ReadFrontBufferOff()
    grab.Update()
    data = grab.GetOutput()
    width, height, _ = data.GetDimensions()
    return vtk_to_numpy(data.GetPointData().GetScalars()).reshape(height, width, -1)[..., :3]


def test_is_shown_unlit_and_from_the_lit_side():
    """A wall that is lit evenly has its display colour in the middle of the picture, however oblique the
    headlight is, and nothing is seen of it from behind."""
    lit = IlluminationMap(
        Input=simple.Plane(XResolution=1, YResolution=1), LampDirection=[0, 0, -1], Interreflection=0, Photons=262144
    )
    look = IlluminatedAppearance(Input=lit, HighlightCompression=0, ReflectanceArray="None")
    view = simple.CreateView("RenderView")
    view.ViewSize = [64, 64]
    view.OrientationAxesVisibility = 0
    view.UseColorPaletteForBackground = 0
    view.Background = [0.0, 0.0, 1.0]
    display = simple.Show(look, view)
    assert display.SMProxy.GetXMLName() == "IlluminatedRepresentation", display.SMProxy.GetXMLName()
    assert display.Representation == "Illuminated", display.Representation
    assert display.ColorArrayName[:] == ["POINTS", "DisplayColours"], display.ColorArrayName[:]
    colours = vtk_to_numpy(servermanager.Fetch(look).GetPointData().GetArray("DisplayColours")).astype(int)
    assert (np.ptp(colours, axis=0) <= 6).all(), colours  # noise of few photons
    view.CameraPosition = [2.0, 0.0, 0.5]  # 76 degrees from the wall's normal
    view.CameraFocalPoint = [0.0, 0.0, 0.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    middle = picture(view)[32, 32].astype(int)
    assert (abs(middle - colours.mean(axis=0)) <= 4).all(), (middle, colours)
    view.CameraPosition = [2.0, 0.0, -0.5]
    middle = picture(view)[32, 32]
    assert middle.tolist() == [0, 0, 255], middle  # the background
    # False colours are one choice away.
    display.Representation = "Surface"
    simple.ColorBy(display, ("POINTS", "Illuminance"))
    assert picture(view)[32, 32].tolist() != [0, 0, 255]


if __name__ == "__main__":
    proxies.run_tests(globals())
