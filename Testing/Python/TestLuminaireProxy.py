# SPDX-License-Identifier: BSD-3-Clause
"""The luminaire's proxy: defaults, documentation, choices, and a lamp that arrives as it is set."""
import os

from paraview import servermanager, simple
from vtkIllumination import vtkLuminaireSource

# A property's value in ParaView -> the source's, where they differ.
NOT_DEFAULT = {
    "Type": ("Spot", 3),
    "LuminaireName": "over the desk",
    "Position": (1.0, 2.0, 3.0),
    "Direction": (0.0, 1.0, 0.0),
    "Size": (2.0, 3.0),
    "Rotation": 90.0,
    "SpotHalfAngle": 60.0,
    "SpotExponent": 2.0,
    "LuminousFlux": 500.0,
    "Illuminance": 5000.0,
    "SkyType": ("16 Traditional overcast sky", 16),
    "SunAltitude": 30.0,
    "SunAzimuth": 90.0,
    "FileName": "lamp.ies",
    "Dimming": 0.5,
    "LightColour": (1.0, 0.8, 0.6),
    "GlyphSize": 0.3,
}


def test_each_property_is_documented_and_reaches_the_source():
    proxy = Luminaire()
    assert sorted(NOT_DEFAULT) == sorted(proxy.ListProperties())
    for name, value in NOT_DEFAULT.items():
        shown, expected = value if name in ("Type", "SkyType") else (value, value)
        assert len(proxy.GetProperty(name).SMProperty.GetDocumentation().GetDescription()) > 40
        setattr(proxy, name, shown)
        proxy.UpdateVTKObjects()
        assert getattr(proxy.GetClientSideObject(), "Get" + name)() == expected, name


def test_defaults_of_proxy_and_class_agree():
    proxy = Luminaire()
    proxy.UpdateVTKObjects()
    for name in NOT_DEFAULT:
        by_proxy = getattr(proxy.GetClientSideObject(), "Get" + name)()
        assert by_proxy == getattr(vtkLuminaireSource(), "Get" + name)(), name


def test_choices_are_those_of_the_class():
    types = list(Luminaire().GetProperty("Type").Available)
    names = [text.upper().replace(" ", "_") for text in types]
    assert [getattr(vtkLuminaireSource, name) for name in names] == list(range(11)), types
    skies = list(Luminaire().GetProperty("SkyType").Available)
    assert [int(text.split()[0]) for text in skies] == list(range(1, 17)), skies


def test_the_lamp_arrives_as_it_is_set():
    proxy = Luminaire(Type="Disk", Position=(1, 2, 3), Size=(0.5, 1), LuminousFlux=800)
    proxy.UpdatePipeline()
    lamp = servermanager.Fetch(proxy)
    fields = lamp.GetFieldData()
    assert fields.GetAbstractArray("LuminaireType").GetValue(0) == "Disk"
    assert fields.GetArray("LuminairePosition").GetTuple3(0) == (1, 2, 3)
    assert fields.GetArray("LuminousFlux").GetTuple1(0) == 800
    assert abs(lamp.GetBounds()[1] - 1.5) < 0.01, lamp.GetBounds()


if __name__ == "__main__":
    for test_name, test in list(globals().items()):
        if test_name.startswith("test_"):
            print(test_name, flush=True)
            simple.ResetSession()
            simple.LoadPlugin(os.environ["ILLUMINATION_PLUGIN"], ns=globals())
            test()
