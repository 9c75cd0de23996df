# SPDX-License-Identifier: BSD-3-Clause
"""The smoothing's proxy: defaults, documentation, arrays it offers, a chain that is set up by default."""
import proxies
from paraview import servermanager, simple
from vtkIllumination import vtkIlluminationMapSmoothing

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
    proxies.check_documented(proxy, NOT_DEFAULT)
    proxies.check_reach(proxy, NOT_DEFAULT)


def test_defaults_of_proxy_and_class_agree():
    proxies.check_defaults(smoothed_sphere(), vtkIlluminationMapSmoothing(), NOT_DEFAULT)


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
    proxies.run_tests(globals())
