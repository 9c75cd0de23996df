# SPDX-License-Identifier: BSD-3-Clause
"""The luminaire's proxy: defaults, documentation, choices, and a lamp that arrives as it is set."""
import os

import numpy as np
import proxies
from paraview import servermanager, simple
from vtk.util.numpy_support import vtk_to_numpy
from vtkIllumination import vtkLuminaireSource

NOT_DEFAULT = {
    "Type": ("Spot", 3),
    "LuminaireName": "over the desk",
    "Position": [1.0, 2.0, 3.0],
    "Direction": [0.0, 1.0, 0.0],
    "Size": [2.0, 3.0],
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
    "LightColour": [1.0, 0.8, 0.6],
    "GlyphSize": 0.3,
}


def test_each_property_is_documented_and_reaches_the_source():
    proxy = Luminaire()
    proxies.check_documented(proxy, NOT_DEFAULT)
    proxies.check_reach(proxy, NOT_DEFAULT)


def test_defaults_of_proxy_and_class_agree():
    proxies.check_defaults(Luminaire(), vtkLuminaireSource(), NOT_DEFAULT)


def test_choices_are_those_of_the_class():
    types = list(Luminaire().GetProperty("Type").Available)
    names = [text.upper().replace(" ", "_") for text in types]
    assert [getattr(vtkLuminaireSource, name) for name in names] == list(range(vtkLuminaireSource.NUMBER_OF_TYPES)), types
    skies = list(Luminaire().GetProperty("SkyType").Available)
    assert [int(text.split()[0]) for text in skies] == list(range(1, 17)), skies


# The properties behind each of a lamp's field arrays.
PROPERTIES_OF = {
    "LuminaireDirection": {"Direction"},
    "LuminaireSize": {"Size"},
    "LuminousFlux": {"LuminousFlux"},
    "LuminaireIlluminance": {"Illuminance"},
    "SpotHalfAngle": {"SpotHalfAngle"},
    "SpotExponent": {"SpotExponent"},
    "SkyLuminance": {"Illuminance"},
    "SkyType": {"SkyType"},
    "SunDirection": {"SunAltitude", "SunAzimuth"},
    "LuminaireRotation": {"Rotation"},
    "PhotometricType": {"FileName"},
}


def shown(proxy, name, number):
    """Whether the panel shows a property of the lamp for the type of this number."""
    hints = proxy.GetProperty(name).SMProperty.GetHints()
    decorator = hints and hints.FindNestedElementByName("PropertyWidgetDecorator")
    if not decorator:
        return True
    assert decorator.GetAttribute("property") == "Type", name
    types = decorator.GetAttribute("values") or decorator.GetAttribute("value")
    return str(number) in types.split()


def test_the_panel_shows_what_a_type_uses():
    folder = os.path.dirname(os.path.abspath(__file__))
    proxy = Luminaire(FileName=os.path.join(folder, "..", "Data", "photometry", "isotropic.ies"))
    ours = set().union(*PROPERTIES_OF.values())
    for number, text in enumerate(proxy.GetProperty("Type").Available):
        proxy.Type = text
        proxy.UpdatePipeline()
        fields = servermanager.Fetch(proxy).GetFieldData()
        assert fields.HasArray("LuminaireType"), text
        used = set().union(*(names for array, names in PROPERTIES_OF.items() if fields.HasArray(array)))
        assert {name for name in ours if shown(proxy, name, number)} == used, (text, used)


def test_the_lamp_arrives_as_it_is_set():
    proxy = Luminaire(Type="Disk", Position=(1, 2, 3), Size=(0.5, 1), LuminousFlux=800)
    proxy.UpdatePipeline()
    lamp = servermanager.Fetch(proxy)
    fields = lamp.GetFieldData()
    assert fields.GetAbstractArray("LuminaireType").GetValue(0) == "Disk"
    assert fields.GetArray("LuminairePosition").GetTuple3(0) == (1, 2, 3)
    assert fields.GetArray("LuminousFlux").GetTuple1(0) == 800
    assert abs(lamp.GetBounds()[1] - 1.5) < 0.01, lamp.GetBounds()


def test_dimming_traces_nothing():
    room = simple.Sphere(ThetaResolution=24, PhiResolution=24)
    inside = simple.ReverseSense(Input=room, ReverseCells=1, ReverseNormals=1)
    near, far = (Luminaire(Type="Point", LuminaireName=name, Position=(x, 0, 0)) for name, x in (("Near", 0.3), ("Far", -0.2)))
    lit = IlluminationMap(Input=inside, Luminaires=[near, far], LampContributions=1, Photons=20000)

    def found():
        lit.UpdatePipeline()
        data = servermanager.Fetch(lit)
        points, fields = data.GetPointData(), data.GetFieldData()
        names = ("Illuminance", "Illuminance_Near", "Illuminance_Far", "StandardError_Near")
        return ([vtk_to_numpy(points.GetArray(name)) for name in names], fields.GetArray("Seconds").GetTuple1(0),
                [fields.GetAbstractArray("Notes").GetValue(i) for i in range(fields.GetAbstractArray("Notes").GetNumberOfValues())])

    (before, near_before, far_before, error), seconds, notes = found()
    assert not any("relit" in note for note in notes), notes
    near.Dimming, far.LuminousFlux = 0.25, 3000
    (after, near_after, _, error_after), seconds_after, notes = found()
    assert seconds_after == seconds and any("relit" in note for note in notes), notes
    assert np.allclose(after, 0.25 * near_before + 3 * far_before, rtol=1e-12)
    assert np.allclose(near_after, 0.25 * near_before, rtol=1e-12) and np.allclose(error_after, 0.25 * error, rtol=1e-12)
    near.Dimming, far.LuminousFlux = 1, 1000
    (back, *_), seconds_after, _ = found()
    assert seconds_after == seconds and np.array_equal(back, before)


def test_choices_are_set_by_number_too():
    proxy = Luminaire(Type=9, SkyType=12)
    proxy.UpdateVTKObjects()
    assert proxy.Type == "CIE Sky" and proxy.GetClientSideObject().GetSkyType() == 12
    for name, choices in (("Type", range(vtkLuminaireSource.NUMBER_OF_TYPES)), ("SkyType", range(1, 17))):
        for number in choices:
            setattr(proxy, name, number)
            proxy.UpdateVTKObjects()
            assert getattr(proxy.GetClientSideObject(), "Get" + name)() == number, (name, number)


def lit_by(lamps, **properties):
    """The arrays of a floor under these lamps, and the errors."""
    floor = simple.Plane(XResolution=4, YResolution=4)
    proxy = IlluminationMap(Input=floor, Luminaires=lamps, LampContributions=1, Photons=20000, **properties)
    proxy.UpdateVTKObjects()
    errors = []
    proxy.GetClientSideObject().AddObserver("ErrorEvent", lambda *_: errors.append(1))
    proxy.UpdatePipeline()
    output = servermanager.Fetch(proxy)
    assert output.IsA("vtkPolyData"), output.GetClassName()
    return output.GetPointData(), errors


def same(a, b):
    """Whether maps agree to 1e-6 of their brightest point: moving a lamp costs rounding."""
    brightest = max(a.GetValue(i) for i in range(a.GetNumberOfTuples()))
    return brightest > 0 and all(
        abs(a.GetValue(i) - b.GetValue(i)) <= 1e-6 * brightest for i in range(a.GetNumberOfTuples()))


def test_transform_moves_the_lamp():
    here = Luminaire(Type="Rectangle", Position=[0.2, 0, 0.5], Size=[0.4, 0.1])
    there = Luminaire(Type="Rectangle", Position=[0, 0, 0], Size=[0.2, 0.05])
    moved = simple.Transform(Input=there)
    moved.Transform.Translate = [0.2, 0, 0.5]
    moved.Transform.Scale = [2, 2, 2]
    expected, _ = lit_by([here])
    found, errors = lit_by([moved])
    assert not errors and same(expected.GetArray("Illuminance"), found.GetArray("Illuminance"))
    not_moved = simple.Transform(Input=here)
    found, _ = lit_by([not_moved])
    for i in range(25):  # to the last bit
        assert expected.GetArray("Illuminance").GetValue(i) == found.GetArray("Illuminance").GetValue(i)
    moved.Transform.Scale = [2, 2, 1]
    found, errors = lit_by([moved])
    assert len(errors) == 1 and not found.HasArray("Illuminance")


def test_every_block_of_a_group_is_a_lamp():
    lamps = [Luminaire(Type="Point", LuminaireName=name, Position=[x, 0, 0.5])
             for name, x in (("A", -0.3), ("B", 0.3))]
    expected, _ = lit_by(lamps)
    group = simple.GroupDatasets(Input=lamps)
    for wired in ([group], [simple.GroupDatasets(Input=[group])],
                  [simple.Clean(Input=group)], [simple.Transform(Input=group)]):
        found, errors = lit_by(wired)
        for name in ("Illuminance", "Illuminance_A", "Illuminance_B"):
            assert not errors and same(expected.GetArray(name), found.GetArray(name)), name


def test_what_loses_lamps_is_refused():
    lamp, other = Luminaire(Type="Point", Position=[0, 0, 1]), Luminaire(Type="Disk")
    passed = simple.PassArrays(Input=lamp)
    passed.PointDataArrays = []
    for broken in (simple.AppendGeometry(Input=[lamp, other]), simple.AppendGeometry(Input=[lamp, lamp]),
                   simple.AppendGeometry(Input=[lamp, simple.Plane()]),
                   simple.AppendGeometry(Input=[simple.Plane(), lamp]),
                   simple.MergeBlocks(Input=simple.GroupDatasets(Input=[lamp, other])), passed):
        found, errors = lit_by([broken])
        assert len(errors) == 1 and not found.HasArray("Illuminance"), broken.GetXMLName()


if __name__ == "__main__":
    proxies.run_tests(globals())
