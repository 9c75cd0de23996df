# SPDX-License-Identifier: BSD-3-Clause
"""The smoothing's proxy: defaults, documentation, arrays it offers, a chain that is set up by default."""
import os

from paraview import servermanager, simple
from vtkIllumination import vtkIlluminationMapSmoothing

# A property's value in ParaView -> the filter's, where they differ.
NOT_DEFAULT = {
    "Method": ("Diffusion", 1),
    "IlluminanceArray": "IlluminanceDirect",
    "StandardErrorArray": "None",
    "Strength": 2.0,
    "Width": 8.0,
    "FeatureAngle": 60.0,
    "NumberOfThreads": 1,
}


def smoothed_sphere():
    lit = IlluminationMap(Input=simple.Sphere(), Photons=10000, GroupMeans=1)
    lit.UpdatePipeline()
    return IlluminationMapSmoothing(Input=lit)


def test_each_property_is_documented_and_reaches_the_filter():
    proxy = smoothed_sphere()
    assert sorted(NOT_DEFAULT) == sorted(set(proxy.ListProperties()) - {"Input"})
    for name, value in NOT_DEFAULT.items():
        shown, expected = value if isinstance(value, tuple) else (value, value)
        assert len(proxy.GetProperty(name).SMProperty.GetDocumentation().GetDescription()) > 40
        setattr(proxy, name, shown)
        proxy.UpdateVTKObjects()
        assert getattr(proxy.GetClientSideObject(), "Get" + name)() == expected, name


def test_defaults_of_proxy_and_class_agree():
    proxy = smoothed_sphere()
    proxy.UpdateVTKObjects()
    for name in NOT_DEFAULT:
        by_proxy = getattr(proxy.GetClientSideObject(), "Get" + name)()
        assert by_proxy == getattr(vtkIlluminationMapSmoothing(), "Get" + name)(), name


def test_array_lists_offer_point_arrays_of_one_component():
    proxy = smoothed_sphere()
    offered = list(proxy.GetProperty("IlluminanceArray").Available)
    assert "Illuminance" in offered and "IlluminanceIndirect" in offered, offered
    assert "Normals" not in offered and "IlluminanceDirectGroups" not in offered, offered
    assert "None" in list(proxy.GetProperty("StandardErrorArray").Available)


def test_it_runs_as_it_is_set_up():
    proxy = smoothed_sphere()
    proxy.UpdatePipeline()
    smoothed = servermanager.Fetch(proxy)
    assert smoothed.GetPointData().GetArray("IlluminanceDirectSmoothed") is not None
    assert "four groups" in smoothed.GetFieldData().GetAbstractArray("SmoothingNotes").GetValue(0)


if __name__ == "__main__":
    for test_name, test in list(globals().items()):
        if test_name.startswith("test_"):
            print(test_name, flush=True)
            simple.ResetSession()
            simple.LoadPlugin(os.environ["ILLUMINATION_PLUGIN"], ns=globals())
            test()
