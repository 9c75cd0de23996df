# SPDX-License-Identifier: BSD-3-Clause
"""The material's proxy: defaults, documentation, what it offers, blocks, saved states."""
import proxies
from paraview import servermanager, simple
from vtkIllumination import vtkSurfaceMaterial

NOT_DEFAULT = {
    "Preset": ("Clear Glass", 10),
    "DiffuseReflectance": [0.125, 0.25, 0.375],
    "SpecularReflectance": [0.25, 0.0, 0.125],
    "GlossyReflectance": [0.0, 0.25, 0.125],
    "Roughness": 0.5,
    "DiffuseTransmittance": [0.125, 0.0, 0.0],
    "ClearTransmittance": [0.0, 0.0, 0.25],
    "RefractiveIndex": 1.75,
    "SolidBody": (1, True),
    "Opening": ("No Opening", 0),
    "CellArray": "Part",
    "CellValue": 3.0,
}
BLOCKS = [2, 4]


def surface():
    source = simple.ProgrammableSource(OutputDataSetType="vtkPolyData")
    source.Script = """
import numpy
from vtkmodules.vtkFiltersSources import vtkPlaneSource
plane = vtkPlaneSource()
plane.SetResolution(2, 2)
plane.Update()
output.ShallowCopy(plane.GetOutput())
output.CellData.append(numpy.array([3, 4, 3, 5]), "Part")
output.CellData.append(numpy.full((4, 3), 0.25), "Colour")
"""
    source.UpdatePipeline()
    return source


def blocks():
    """0 { 1, 2, 3 }"""
    group = simple.GroupDatasets(Input=[surface(), surface(), surface()])
    group.UpdatePipeline()
    return group


def changed_proxy():
    proxy = SurfaceMaterial(registrationName="material", Input=surface())
    proxy.Blocks = BLOCKS
    proxies.set_all(proxy, NOT_DEFAULT)
    return proxy


def check_changed(proxy):
    proxies.check_all(proxy, NOT_DEFAULT)
    material = proxy.GetClientSideObject()
    assert list(proxy.Blocks) == BLOCKS
    assert material.GetNumberOfBlocks() == len(BLOCKS)
    for block in BLOCKS:
        assert material.HasBlock(block), block


def test_each_property_is_documented_and_reaches_the_filter():
    proxy = SurfaceMaterial(Input=surface())
    proxies.check_documented(proxy, [*NOT_DEFAULT, "Blocks"])
    proxies.check_reach(proxy, NOT_DEFAULT)
    check_changed(changed_proxy())


def test_defaults_of_proxy_and_class_agree():
    for source in (surface(), blocks()):
        proxy = SurfaceMaterial(Input=source)
        proxies.check_defaults(proxy, vtkSurfaceMaterial(), NOT_DEFAULT)
        assert len(proxy.Blocks) == 0 and proxy.GetClientSideObject().GetNumberOfBlocks() == 0


def test_presets_are_the_classes_own():
    proxy = SurfaceMaterial(Input=surface())
    for text in proxy.GetProperty("Preset").Available:
        proxy.Preset = text
        proxy.UpdateVTKObjects()
        constant = getattr(vtkSurfaceMaterial, text.upper().replace(" ", "_"))
        assert proxy.GetClientSideObject().GetPreset() == constant, text
    assert len(proxy.GetProperty("Preset").Available) == vtkSurfaceMaterial.OPENING + 1


def test_array_list_offers_cell_arrays_of_one_component():
    proxy = SurfaceMaterial(Input=surface())
    assert list(proxy.GetProperty("CellArray").Available) == ["None", "Part"]


def test_blocks_get_the_material():
    proxy = SurfaceMaterial(Input=blocks(), Preset="Mirror", Blocks=[2])
    proxy.UpdatePipeline()
    output = servermanager.Fetch(proxy)
    for block in range(3):
        array = output.GetBlock(block).GetCellData().GetArray("SpecularReflectance")
        assert (array.GetComponent(0, 0) > 0.0) == (block == 1), block


def test_a_chain_gives_each_part_its_own():
    mirror = SurfaceMaterial(Input=surface(), Preset="Mirror", CellArray="Part", CellValue=3)
    paint = SurfaceMaterial(Input=mirror, Preset="White Paint", CellArray="Part", CellValue=4)
    paint.UpdatePipeline()
    cells = servermanager.Fetch(paint).GetCellData()
    specular = [cells.GetArray("SpecularReflectance").GetComponent(c, 0) for c in range(4)]
    diffuse = [cells.GetArray("DiffuseReflectance").GetComponent(c, 0) for c in range(4)]
    assert [round(value, 6) for value in specular] == [0.9, 0.0, 0.9, 0.0], specular
    assert [round(value, 6) for value in diffuse] == [0.0, 0.85, 0.0, 0.5], diffuse


def test_state_brings_everything_back():
    changed_proxy()
    proxies.pass_through_a_state()
    check_changed(simple.FindSource("material"))


def test_python_state_says_what_was_set():
    changed_proxy()
    proxies.check_python_state("material", {**NOT_DEFAULT, "Blocks": BLOCKS})


def test_blocks_and_values_can_be_taken_back():
    proxy = changed_proxy()
    proxy.Preset = "Custom"
    proxy.Blocks = []
    proxy.UpdateVTKObjects()
    assert proxy.GetClientSideObject().GetNumberOfBlocks() == 0
    assert proxy.GetClientSideObject().GetPreset() == vtkSurfaceMaterial.CUSTOM
    proxy.Preset = proxies.in_paraview(NOT_DEFAULT["Preset"])
    proxy.Blocks = BLOCKS
    proxy.UpdateVTKObjects()
    check_changed(proxy)


if __name__ == "__main__":
    proxies.run_tests(globals())
