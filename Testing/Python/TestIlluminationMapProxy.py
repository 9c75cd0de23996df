# SPDX-License-Identifier: BSD-3-Clause
"""The proxy is an ordinary one: properties reach the filter, domains offer what makes sense, and
saved states bring it back as it was."""
import proxies
from paraview import servermanager, simple
from vtkIllumination import vtkIlluminationMap  # what GetClientSideObject returns

NOT_DEFAULT = {
    "LampType": ("Disk", 5),
    "LampPosition": [1.5, 2.5, 3.5],
    "LampDirection": [1.0, 0.0, -1.0],
    "LampSize": [0.5, 0.25],
    "SpotHalfAngle": 45.0,
    "SpotExponent": 2.0,
    "LuminousFlux": 250.0,
    "ParallelIlluminance": 300.0,
    "ExitanceArray": "Grey",
    "Reflectance": 0.25,
    "ReflectanceArray": "Colour",
    "UseMaterialArrays": (0, False),
    "SpecularReflectance": 0.1,
    "GlossyReflectance": 0.15,
    "Roughness": 0.4,
    "DiffuseTransmittance": 0.05,
    "ClearTransmittance": 0.2,
    "RefractiveIndex": 1.6,
    "SolidBody": (1, True),
    "Interreflection": (0, False),
    "SpecularReflection": (0, False),
    "GlossyReflection": (0, False),
    "DiffuseTransmission": (0, False),
    "ClearTransmission": (0, False),
    "Refraction": (0, False),
    "Colour": (0, False),
    "LampContributions": (1, True),
    "CurvedSurface": (1, True),
    "RegisterBackSide": (1, True),
    "GroupMeans": (0, False),
    "MaximumPhotons": 1000,
    "PhotonPaths": 100,
    "MetresPerUnit": 0.001,
    "FeatureAngle": 60.0,
    "Photons": 5000000000.0,
    "Method": ("Final Gathering", 1),
    "GatherRays": 512,
    "AdaptiveRefinement": (1, True),
    "RefinementTolerance": 0.1,
    "MaximumCells": 5000,
    "TargetRelativeError": 0.02,
    "AccuracyRegionArray": "Grey",
    "CountFacetError": (1, True),
    "TimeLimit": 60.0,
    "Seed": 7,
    "Registration": ("Facet Ratio", 1),
    "Sampling": ("Random", 0),
    "WeightBound": 8.0,
    "MaximumPathLength": 100,
    "NumberOfThreads": 1,
    "MemoryLimit": 2.5,
    "Progressive": (0, False),
}


def surface_with_cell_arrays():
    source = simple.ProgrammableSource(OutputDataSetType="vtkPolyData")
    source.Script = """
import numpy
from vtkmodules.vtkFiltersSources import vtkSphereSource
sphere = vtkSphereSource()
sphere.Update()
output.ShallowCopy(sphere.GetOutput())
cells = output.GetNumberOfCells()
output.CellData.append(numpy.full(cells, 0.25), "Grey")
output.CellData.append(numpy.full((cells, 2), 0.25), "Two")
output.CellData.append(numpy.full((cells, 3), 0.25), "Colour")
"""
    source.UpdatePipeline()
    return source


def changed_proxy():
    proxy = IlluminationMap(registrationName="lit", Input=surface_with_cell_arrays())
    proxies.set_all(proxy, NOT_DEFAULT)
    return proxy


def test_each_property_is_documented_and_reaches_the_filter():
    proxy = IlluminationMap(Input=surface_with_cell_arrays())
    proxies.check_documented(proxy, [*NOT_DEFAULT, "AccuracyRegionBlocks", "Pause"])
    proxies.check_reach(proxy, NOT_DEFAULT)


def test_region_blocks_reach_the_filter_and_none_is_the_default():
    both = simple.GroupDatasets(Input=[simple.Plane(), simple.Sphere()])
    proxy = IlluminationMap(Input=both, AccuracyRegionBlocks=[2])
    proxy.UpdateVTKObjects()
    assert proxy.GetClientSideObject().HasAccuracyRegionBlock(2)
    proxy.AccuracyRegionBlocks = []
    proxy.UpdateVTKObjects()
    assert proxy.GetClientSideObject().GetNumberOfAccuracyRegionBlocks() == 0


def test_defaults_of_proxy_and_class_agree():
    proxy = IlluminationMap(Input=surface_with_cell_arrays())
    proxies.check_defaults(proxy, vtkIlluminationMap(), NOT_DEFAULT)


def test_array_lists_offer_cell_arrays_of_the_right_shape_and_none():
    proxy = IlluminationMap(Input=surface_with_cell_arrays())
    assert proxy.ReflectanceArray == proxy.ExitanceArray == "None"
    assert list(proxy.GetProperty("ReflectanceArray").Available) == ["None", "Colour", "Grey"]
    assert list(proxy.GetProperty("ExitanceArray").Available) == ["None", "Colour", "Grey"]
    assert proxy.AccuracyRegionArray == "None"
    assert list(proxy.GetProperty("AccuracyRegionArray").Available) == ["None", "Grey"]


def test_none_means_no_array():
    proxy = IlluminationMap(Input=surface_with_cell_arrays(), Photons=1000)
    proxy.UpdatePipeline()
    assert proxy.PointData.GetArray("Illuminance") is not None


def lit_by(*luminaires):
    """The filter's output for a sphere under some luminaires, each kept apart."""
    proxy = IlluminationMap(registrationName="by lamps", Input=simple.Sphere(), Photons=20000,
                            Luminaires=list(luminaires), LampContributions=1)
    proxy.UpdatePipeline()
    return proxy, servermanager.Fetch(proxy).GetPointData()


def test_luminaires_replace_the_own_lamp_and_survive_a_state():
    sun = Luminaire(registrationName="Sun", LuminaireName="Sun", Type="Parallel")
    spot = Luminaire(registrationName="Spot", LuminaireName="Spot", Type="Spot", Position=[0, 0, 2])
    proxy, both = lit_by(sun, spot)
    assert both.GetArray("Illuminance_Sun") and both.GetArray("Illuminance_Spot")
    for point in range(both.GetNumberOfTuples()):
        parts = [both.GetArray("Illuminance_" + name).GetValue(point) for name in ("Sun", "Spot")]
        total = both.GetArray("Illuminance").GetValue(point)
        assert abs(sum(parts) - total) <= 1e-9 * total, (point, parts, total)
    proxies.pass_through_a_state()
    again = simple.FindSource("by lamps")
    assert len(again.Luminaires) == 2
    again.Luminaires = []
    again.UpdatePipeline()
    assert servermanager.Fetch(again).GetPointData().GetArray("Illuminance_Lamp")


def test_final_gathering_has_its_arrays_and_its_columns():
    proxy = IlluminationMap(Input=surface_with_cell_arrays(), Photons=20000, Method="Final Gathering",
                            GatherRays=64, AccuracyRegionArray="Grey")
    proxy.UpdatePipeline()
    assert proxy.PointData.GetArray("IlluminanceCaustic") is not None
    assert proxy.PointData.GetArray("PhotonHits") is None
    row = servermanager.Fetch(proxy, idx=1).GetRowData()
    assert row.GetArray("GatherRays").GetValue(0) == 64
    # The region is the whole surface.
    assert row.GetArray("RegionRelativeError").GetValue(0) == row.GetArray("RelativeError").GetValue(0)


def test_photons_are_whole_numbers_up_to_1e10():
    proxy = IlluminationMap(Input=surface_with_cell_arrays(), TimeLimit=1e-6)
    proxy.UpdateVTKObjects()
    errors = []
    proxy.GetClientSideObject().AddObserver("ErrorEvent", lambda *_: errors.append(proxy.Photons))
    for photons in (1, 1e6, 2**31, 10**10):
        proxy.Photons = photons
        proxy.UpdatePipeline()
        assert proxy.GetClientSideObject().GetPhotons() == photons
        assert proxy.PointData.GetArray("Illuminance") is not None, photons
    assert not errors, errors
    for number, photons in enumerate((1.5, float("nan"), float("inf"), 0, -1, 10**10 + 1, 1e300), 1):
        proxy.Photons = photons
        proxy.UpdatePipeline()
        assert len(errors) == number, (photons, errors)
        assert proxy.PointData.GetArray("Illuminance") is None, photons


def accepted(source, port="Input"):
    """Whether ParaView's menu offers the filter for this source."""
    source.UpdatePipeline()
    manager = servermanager.ProxyManager().SMProxyManager
    input_property = manager.NewProxy("filters", "IlluminationMap").GetProperty(port)
    input_property.AddUncheckedInputConnection(source.SMProxy, 0)
    return bool(input_property.IsInDomains())


def test_menu_offers_the_filter_for_surfaces_alone_or_in_blocks():
    sphere, volume = simple.Sphere(), simple.Wavelet()
    assert accepted(sphere)
    assert not accepted(volume)
    assert accepted(simple.GroupDatasets(Input=[sphere, simple.Plane()]))
    assert accepted(simple.GroupDatasets(Input=[sphere, volume]))
    for kind in ("vtkPartitionedDataSet", "vtkPartitionedDataSetCollection"):
        blocks = simple.ProgrammableSource(OutputDataSetType=kind)
        index = "0" if kind == "vtkPartitionedDataSet" else "0, 0"
        blocks.Script = f"""
from vtkmodules.vtkFiltersSources import vtkSphereSource
sphere = vtkSphereSource()
sphere.Update()
output.SetPartition({index}, sphere.GetOutput())
"""
        assert accepted(blocks), kind


def test_menu_offers_lamps_and_groups_of_them_as_luminaires():
    lamps = [Luminaire(Type="Point"), Luminaire(Type="Spot")]
    assert accepted(lamps[0], "Luminaires")
    assert accepted(simple.GroupDatasets(Input=lamps), "Luminaires")
    assert not accepted(simple.Wavelet(), "Luminaires")


def test_state_brings_everything_back():
    changed_proxy()
    proxies.pass_through_a_state()
    proxies.check_all(simple.FindSource("lit"), NOT_DEFAULT)


def test_python_state_says_what_was_set():
    changed_proxy()
    proxies.check_python_state("lit", NOT_DEFAULT)


if __name__ == "__main__":
    proxies.run_tests(globals())
