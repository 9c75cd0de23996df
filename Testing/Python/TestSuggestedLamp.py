# SPDX-License-Identifier: BSD-3-Clause
"""The lamp that ParaView's window gives a new Illumination Map lights any surface: nearly no light on
backs, none of it lost, no warning. The filter's own defaults stay those of the class."""
import proxies
from paraview import servermanager, simple
from vtkIllumination import vtkIlluminationMap, vtkSuggestedLamp
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkMultiBlockDataSet, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendPolyData, vtkReverseSense, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkCubeSource, vtkPlaneSource, vtkSphereSource

LENGTHS = (4.0, 3.0, 2.5)


def output(algorithm, *inputs):
    for data in inputs:
        algorithm.AddInputDataObject(data)
    algorithm.Update()
    return algorithm.GetOutput()


def box(lengths=LENGTHS, centre=(0.0, 0.0, 0.0), inward=False):
    cube = vtkCubeSource()
    cube.SetBounds(*(c + sign * 0.5 * l for c, l in zip(centre, lengths) for sign in (-1.0, 1.0)))
    triangles = output(vtkTriangleFilter(), output(cube))
    reverse = vtkReverseSense()
    reverse.SetReverseCells(inward)
    reverse.SetReverseNormals(inward)
    return output(reverse, triangles)


def plane(normal, centre=(0.0, 0.0, 0.0)):
    source = vtkPlaneSource()
    source.SetResolution(8, 8)
    source.SetNormal(*normal)
    source.SetCenter(*centre)
    return output(source)


def sphere():
    source = vtkSphereSource()
    source.SetThetaResolution(32)
    source.SetPhiResolution(16)
    return output(source)


def together(*parts):
    append = vtkAppendPolyData()
    return output(append, *parts)


def as_blocks(*parts):
    blocks = vtkMultiBlockDataSet()
    for number, part in enumerate(parts):
        blocks.SetBlock(number, part)
    return blocks


def without_normals(surface):
    bare = vtkPolyData()
    bare.CopyStructure(surface)
    return bare


def without_the_wall_in_front(room):
    """Its first two triangles are the wall at -x."""
    open_room = vtkPolyData()
    open_room.DeepCopy(room)
    open_room.BuildLinks()
    for cell in (0, 1):
        open_room.DeleteCell(cell)
    open_room.RemoveDeletedCells()
    return open_room


def l_shaped_room():
    """Without points above the middle of its bounds' floor plan."""
    corners = ((0, 0), (4, 0), (4, 1), (1, 1), (1, 4), (0, 4))
    parts = (((0, 0), (4, 0), (4, 1), (0, 1)), ((0, 1), (1, 1), (1, 4), (0, 4)))
    points, cells = vtkPoints(), vtkCellArray()

    def add(*quad):
        cells.InsertNextCell(4, [points.InsertNextPoint(corner) for corner in quad])

    for part in parts:
        add(*((x, y, 0) for x, y in part))              # the floor looks up
        add(*((x, y, 2) for x, y in reversed(part)))    # the ceiling down
    for (x, y), (u, v) in zip(corners, corners[1:] + corners[:1]):
        add((u, v, 0), (x, y, 0), (x, y, 2), (u, v, 2))  # walls inward
    room = vtkPolyData()
    room.SetPoints(points)
    room.SetPolys(cells)
    return room


ROOMS = {
    "a room": box(inward=True),
    "a room without normals": without_normals(box(inward=True)),
    "a large room far away": box((4000, 3000, 2500), (1e6, 2e6, 0.0), inward=True),
    "a furnished room": together(box(inward=True), box((1.0, 0.8, 0.7), (0.1, 0.1, -0.9))),
    "the same in blocks": as_blocks(box(inward=True), box((1.0, 0.8, 0.7), (0.1, 0.1, -0.9))),
    "a room with a piece of roof": together(box(inward=True), box((4.4, 3.4, 0.2), (0.0, 0.0, 1.4))),
    "a room that is open in front": without_the_wall_in_front(box(inward=True)),
    "an L-shaped room": l_shaped_room(),
}
OPEN = {
    "a sphere": sphere(),
    "a box": box(),
    "a floor": plane((0, 0, 1)),
    "a ceiling": plane((0, 0, -1)),
    "a wall": plane((1, 0, 0)),
    "a slope": plane((1, 1, 0.1)),
    "a box on a floor": together(plane((0, 0, 1)), box((0.3, 0.3, 0.3), (0.0, 0.0, 0.2))),
}


def lamp_for(surface):
    lamp = vtkSuggestedLamp()
    lamp.SetInputDataObject(surface)
    lamp.Update()
    return lamp


def lit(surface, lamp=None):
    """The field data of a map, by the suggested lamp or by the defaults."""
    illuminate = vtkIlluminationMap()
    illuminate.SetInputDataObject(surface)
    illuminate.SetPhotons(20000)
    if lamp:
        illuminate.SetLampType(lamp.GetLampType())
        illuminate.SetLampPosition(lamp.GetLampPosition())
        illuminate.SetLampDirection(lamp.GetLampDirection())
    illuminate.Update()
    return illuminate.GetOutputDataObject(0).GetFieldData()


def share(field, name):
    return field.GetArray(name).GetValue(0) / field.GetArray("EmittedFlux").GetValue(0)


def test_a_room_is_lit_from_below_its_ceiling():
    for name, room in ROOMS.items():
        lamp = lamp_for(room)
        assert lamp.GetLampType() == vtkIlluminationMap.POINT, name
        field = lit(room, lamp)
        least = 0.8 if "open" in name else 1.0 - 1e-9
        assert share(field, "FluxOnFronts") >= least, (name, share(field, "FluxOnFronts"))
        assert share(field, "FluxOnBacks") == 0.0, name
        assert field.GetAbstractArray("Warnings").GetNumberOfValues() == 0, name
    x, y, z = lamp_for(ROOMS["a room"]).GetLampPosition()
    assert abs(x) < 0.01 and abs(y) < 0.01 and abs(z - (1.25 - 0.15 * 2.5)) < 1e-6, (x, y, z)


def test_what_is_no_room_is_lit_from_its_front():
    for name, surface in OPEN.items():
        lamp = lamp_for(surface)
        assert lamp.GetLampType() == vtkIlluminationMap.PARALLEL, name
        field = lit(surface, lamp)
        assert share(field, "FluxOnFronts") > 0.2, (name, share(field, "FluxOnFronts"))
        assert share(field, "FluxOnBacks") == 0.0, name
        assert field.GetAbstractArray("Warnings").GetNumberOfValues() == 0, name


def test_a_lamp_of_another_type_is_in_front_too():
    for name, surface in OPEN.items():
        lamp = lamp_for(surface)
        illuminate = vtkIlluminationMap()
        illuminate.SetInputDataObject(surface)
        illuminate.SetPhotons(20000)
        illuminate.SetLampType(vtkIlluminationMap.DISK)
        illuminate.SetLampPosition(lamp.GetLampPosition())
        illuminate.SetLampDirection(lamp.GetLampDirection())
        illuminate.SetLampSize(lamp.GetLampSize(), lamp.GetLampSize())
        illuminate.Update()
        field = illuminate.GetOutputDataObject(0).GetFieldData()
        assert share(field, "FluxOnFronts") > 0.03, (name, share(field, "FluxOnFronts"))
        assert share(field, "FluxOnBacks") == 0.0, name


def test_the_defaults_leave_a_room_dark_and_so_are_not_what_a_new_map_should_have():
    field = lit(ROOMS["a room"])
    assert share(field, "FluxOnFronts") == 0.0 and share(field, "FluxOnBacks") > 0.1


def test_without_triangles_it_is_the_lamp_of_a_new_map():
    illuminate = vtkIlluminationMap()
    for empty in (vtkPolyData(), vtkMultiBlockDataSet()):
        lamp = lamp_for(empty)
        for name in ("LampType", "LampPosition", "LampDirection"):
            assert getattr(lamp, "Get" + name)() == getattr(illuminate, "Get" + name)(), name


def test_the_proxy_tells_what_the_class_does():
    wall = simple.Plane(Origin=[0, 0, 0], Point1=[0, 0, 1], Point2=[1, 0, 0])  # faces +y
    proxy = servermanager.ProxyManager().SMProxyManager.NewProxy("internal_filters", "SuggestedLamp")
    proxy.GetProperty("Input").SetInputConnection(0, wall.SMProxy, 0)
    proxy.UpdateVTKObjects()
    proxy.UpdatePipeline()
    proxy.UpdatePropertyInformation()
    direction = [proxy.GetProperty("LampDirection").GetElement(i) for i in range(3)]
    assert max(abs(a - b) for a, b in zip(direction, (0, -1, 0))) < 1e-6, direction


def test_scripts_keep_the_lamp_of_the_class():
    proxy = IlluminationMap(Input=simple.Box())  # noqa: F821
    proxies.check_defaults(proxy, vtkIlluminationMap(), ("LampType", "LampPosition", "LampDirection", "LampSize"))


if __name__ == "__main__":
    proxies.run_tests(globals())
