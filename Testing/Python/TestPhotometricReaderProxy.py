# SPDX-License-Identifier: BSD-3-Clause
"""The photometric reader's proxy: found by a file's extension, documented, errors are not fatal."""
import os

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
    proxy = PhotometricReader(FileName=data_file("isotropic.ies"), Size=3.0)
    proxy.UpdateVTKObjects()
    assert sorted(proxy.ListProperties()) == ["FileName", "Size"]
    for name in proxy.ListProperties():
        assert len(proxy.GetProperty(name).SMProperty.GetDocumentation().GetDescription()) > 40
    assert proxy.GetClientSideObject().GetFileName() == data_file("isotropic.ies")
    assert proxy.GetClientSideObject().GetSize() == 3.0


def test_defaults_of_proxy_and_class_agree():
    proxy = PhotometricReader()
    proxy.UpdateVTKObjects()
    assert proxy.GetClientSideObject().GetSize() == vtkPhotometricReader().GetSize()
    assert not proxy.GetClientSideObject().GetFileName()


if __name__ == "__main__":
    for test_name, test in list(globals().items()):
        if test_name.startswith("test_"):
            print(test_name, flush=True)
            simple.ResetSession()
            simple.LoadPlugin(os.environ["ILLUMINATION_PLUGIN"], ns=globals())
            test()
