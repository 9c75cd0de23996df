# SPDX-License-Identifier: BSD-3-Clause
"""The statistics' proxy: defaults, documentation, arrays it offers, a table that follows from a map."""
import proxies
from paraview import servermanager, simple
from vtkIllumination import vtkIlluminanceStatistics

NOT_DEFAULT = {
    "IlluminanceArray": "IlluminanceDirect",
    "StandardErrorArray": "None",
    "PartArray": "DiffuseReflectance",
    "Target": 300.0,
    "Unit": ("Foot-candles", 1),
    "MaintenanceFactor": 0.8,
    "MetresPerUnit": 0.001,
    "ReflectanceArray": "DiffuseReflectance",
    "Reflectance": 0.7,
    "ValidArray": "None",
}


def statistics_of_a_sphere():
    painted = SurfaceMaterial(Input=simple.Sphere())
    lit = IlluminationMap(Input=painted, Photons=10000, GroupMeans=1)
    lit.UpdatePipeline()
    return IlluminanceStatistics(Input=lit)


def column(proxy, name):
    proxy.UpdatePipeline()
    table = servermanager.Fetch(proxy)
    array = table.GetRowData().GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def test_each_property_is_documented_and_reaches_the_filter():
    proxy = statistics_of_a_sphere()
    proxies.check_documented(proxy, NOT_DEFAULT)
    proxies.check_reach(proxy, NOT_DEFAULT)


def test_defaults_of_proxy_and_class_agree():
    proxies.check_defaults(statistics_of_a_sphere(), vtkIlluminanceStatistics(), NOT_DEFAULT)


def test_array_lists_offer_what_can_be_summarised():
    proxy = statistics_of_a_sphere()
    offered = list(proxy.GetProperty("IlluminanceArray").Available)
    assert "Illuminance" in offered and "Normals" not in offered, offered
    assert "DiffuseReflectance" in list(proxy.GetProperty("ReflectanceArray").Available)
    assert "None" in list(proxy.GetProperty("PartArray").Available)


def test_units_and_maintenance():
    proxy = statistics_of_a_sphere()
    (mean,), (unit,) = column(proxy, "Mean"), column(proxy, "Unit")
    assert unit == "lx" and mean > 0.0
    proxy.Unit, proxy.MaintenanceFactor = "Foot-candles", 0.8
    (in_fc,), (unit,) = column(proxy, "Mean"), column(proxy, "Unit")
    assert unit == "fc" and abs(in_fc * 10.7639 / (0.8 * mean) - 1.0) < 1e-5, (in_fc, mean)


def test_a_state_keeps_the_properties():
    proxy = statistics_of_a_sphere()
    proxy.Target, proxy.Unit = 300.0, "Foot-candles"
    proxies.pass_through_a_state()
    loaded = simple.FindSource("IlluminanceStatistics1")
    assert loaded.Target == 300.0 and loaded.Unit == "Foot-candles"
    assert len(column(loaded, "Mean")) == 1


if __name__ == "__main__":
    proxies.run_tests(globals())
