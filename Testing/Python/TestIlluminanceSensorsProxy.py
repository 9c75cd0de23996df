# SPDX-License-Identifier: BSD-3-Clause
"""Illuminance Sensors' proxy: defaults, documentation, state files, its inputs."""
import proxies
from paraview import servermanager, simple
from vtkIllumination import vtkIlluminanceSensors

NOT_DEFAULT = {
    "Layout": ("Points", 2),
    "GridBounds": [0.0, 1.0, 2.0, 3.0, 4.0, 5.0],
    "Height": 1.2,
    "Margin": 0.25,
    "Spacing": 0.4,
    "Up": [0.0, 1.0, 0.0],
    "Azimuth": 45.0,
    "Photons": 5000000000,
    "GatherRays": 256,
    "Seed": 7,
    "NumberOfThreads": 1,
}


def sensors_at_a_sphere(**properties):
    lit = IlluminationMap(Input=simple.Sphere(), Photons=2048)
    lit.UpdatePipeline()
    return IlluminanceSensors(Input=lit, **properties)


def test_each_property_is_documented_and_reaches_the_filter():
    proxy = sensors_at_a_sphere()
    proxies.check_documented(proxy, NOT_DEFAULT)
    proxies.check_reach(proxy, NOT_DEFAULT)


def test_defaults_of_proxy_and_class_agree():
    proxies.check_defaults(sensors_at_a_sphere(), vtkIlluminanceSensors(), NOT_DEFAULT)


def test_properties_pass_through_a_state():
    proxy = sensors_at_a_sphere()
    proxies.set_all(proxy, NOT_DEFAULT)
    simple.RenameSource("Sensors1", proxy)
    proxies.pass_through_a_state()
    loaded = simple.FindSource("Sensors1")
    loaded.UpdateVTKObjects()
    proxies.check_all(loaded, NOT_DEFAULT)


def test_it_reads_points_with_a_luminaire():
    lamp = Luminaire(Type="Point", Position=[0, 0, 2], LuminousFlux=1000)
    lit = IlluminationMap(Input=simple.Sphere(), Luminaires=[lamp], Photons=2048)
    line = simple.Line(Point1=[0, 0, 1], Point2=[1, 0, 1], Resolution=4)
    proxy = IlluminanceSensors(
        Input=lit, Luminaires=[lamp], Sensors=line, Layout="Points", Photons=2048)
    proxy.UpdatePipeline()
    output = servermanager.Fetch(proxy)
    arrays = output.GetPointData()
    assert output.GetNumberOfPoints() == 5
    assert arrays.GetArray("Valid").GetRange() == (1.0, 1.0)
    lux = arrays.GetArray("HorizontalIlluminance")
    assert lux.GetValue(0) > 1000 / 12.566371 - 0.01 > 0
    vertical = arrays.GetArray("VerticalIlluminance")
    assert vertical.GetNumberOfComponents() == 4
    assert vertical.GetComponentName(1) == "towards 90 deg"


if __name__ == "__main__":
    proxies.run_tests(globals())
