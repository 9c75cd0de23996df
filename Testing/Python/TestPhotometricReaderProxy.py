# SPDX-License-Identifier: BSD-3-Clause
"""The photometric reader's proxy: found by a file's extension, documented, errors are not fatal."""
import os

import proxies
from paraview import servermanager, simple
from vtkIllumination import vtkPhotometricReader

DATA = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "Data", "photometry")


def data_file(name):
    return os.path.join(DATA, name)


def test_files_are_opened_by_their_extension():
    for name in ("lambertian.ies", "lateral.ldt"):
        proxy = simple.OpenDataFile(data_file(name))
        assert proxy.GetXMLName() == "PhotometricReader", name
        proxy.UpdatePipeline()
        solid = servermanager.Fetch(proxy)
        assert solid.GetPointData().GetArray("LuminousIntensity") is not None
        assert solid.GetFieldData().GetArray("LuminaireFlux").GetValue(0) > 1000.0


def test_each_property_is_documented_and_reaches_the_reader():
    proxy = PhotometricReader()
    proxies.check_documented(proxy, ["FileName", "Size"])
    proxies.check_reach(proxy, {"FileName": data_file("isotropic.ies"), "Size": 3.0})


def test_defaults_of_proxy_and_class_agree():
    proxy = PhotometricReader()
    proxy.UpdateVTKObjects()
    assert proxy.GetClientSideObject().GetSize() == vtkPhotometricReader().GetSize()
    assert not proxy.GetClientSideObject().GetFileName()


def test_its_output_is_a_lamp():
    floor = simple.Plane(XResolution=4, YResolution=4)
    maps = []
    above = simple.Transform(Input=PhotometricReader(FileName=data_file("lateral.ldt")))
    above.Transform.Translate = [0, 0, 0.5]
    by_name = Luminaire(Type="Photometric File", FileName=data_file("lateral.ldt"), Position=[0, 0, 0.5])
    for lamp in (above, by_name):
        proxy = IlluminationMap(Input=floor, Luminaires=[lamp], Photons=20000)
        proxy.UpdatePipeline()
        maps.append(servermanager.Fetch(proxy).GetPointData().GetArray("Illuminance"))
    brightest = maps[0].GetRange()[1]
    assert brightest > 0
    for i in range(maps[0].GetNumberOfTuples()):
        assert abs(maps[0].GetValue(i) - maps[1].GetValue(i)) <= 1e-6 * brightest, i


if __name__ == "__main__":
    proxies.run_tests(globals())
