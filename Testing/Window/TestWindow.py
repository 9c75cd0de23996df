# SPDX-License-Identifier: BSD-3-Clause
"""The plugin in ParaView's window, as a user meets it. paraview --script=TestWindow.py runs this there and
writes what failed, or nothing, into the file $ILLUMINATION_WINDOW_RESULT."""
import os
import tempfile
import traceback

import window
from paraview import simple, smtrace
from paraview.vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

ROOM = """
import numpy
from vtkmodules.vtkFiltersCore import vtkReverseSense
from vtkmodules.vtkFiltersGeneral import vtkBoxClipDataSet
from vtkmodules.vtkFiltersSources import vtkTessellatedBoxSource
box = vtkTessellatedBoxSource()
box.SetBounds(0, 4, 0, 3, 0, 2.5)
box.SetLevel(8)
box.QuadsOn()
box.DuplicateSharedPointsOn()
box.Update()
room = vtkReverseSense()
room.SetInputConnection(box.GetOutputPort())
room.Update()
output.ShallowCopy(room.GetOutput())
output.CellData.append(numpy.full(output.GetNumberOfCells(), 0.5), "Grey")
"""


def room(name="room"):
    source = simple.ProgrammableSource(registrationName=name, OutputDataSetType="vtkPolyData", Script=ROOM)
    simple.Show(source)
    simple.ResetCamera()
    window.wait()
    return source


def new_map(source):
    """Illumination Map of a source, made by the menu."""
    simple.SetActiveSource(source)
    window.wait()
    window.trigger("IlluminationMap")
    window.enter("Photons", "60000")  # no more than the first map of a progressive run has
    return simple.GetActiveSource()


def begin():
    """Nothing but an empty view. (ParaView's ResetSession in a script leaves its window without the plugin.)"""
    for view in simple.GetViews()[1:]:
        simple.Delete(view)
    for source in reversed(list(simple.GetSources().values())):
        simple.Delete(source)
    simple.SetActiveView(simple.GetActiveViewOrCreate("RenderView"))
    window.wait()


def colours_of_view():
    """How many different colours the view shows; the background and the axes have few."""
    reader = vtkPNGReader()
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "view.png")
        simple.SaveScreenshot(file, simple.GetActiveView())
        reader.SetFileName(file)
        reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)[:, :3]
    return len(set((pixels @ (1, 256, 65536)).tolist()))


def test_labels_have_units_and_python_names_do_not():
    begin()
    lit = new_map(room())
    assert lit.LampType == "Point", lit.LampType
    shown = window.labels()
    for text in ("Luminous Flux (lm)", "Lamp Position (data's length)", "Metres Per Unit (m)", "Time Limit (s)"):
        assert text in shown, (text, shown)
    assert "Lamp Direction" not in shown, shown  # a point has none
    assert lit.LuminousFlux == 1000.0
    lit.LampType = "Disk"
    window.wait()
    assert "Lamp Radius (data's length)" in window.labels(), window.labels()
    assert window.offers("Reflectance") and not window.offers("AdaptiveRefinement")
    lit.ReflectanceArray, lit.Method = "Grey", "Final Gathering"
    window.wait()
    assert "Reflectance (off: Reflectance Array is chosen)" in window.labels(), window.labels()
    assert not window.offers("Reflectance") and window.offers("AdaptiveRefinement")
    lit.LampType = "Parallel"
    window.wait()
    assert "Parallel Illuminance (lx)" in window.labels() and "Luminous Flux (lm)" not in window.labels()


def test_first_map_is_lit_in_one_view_with_the_unit_at_its_colours():
    begin()
    lit = new_map(room())
    window.apply()
    x, y, z = lit.LampPosition
    assert 0 < x < 4 and 0 < y < 3 and 1.25 < z < 2.5, lit.LampPosition
    assert lit.PointData["Illuminance"].GetRange()[0] > 0.0
    assert len(simple.GetViews()) == 1, simple.GetViews()  # no table beside the view
    bar = simple.GetScalarBar(simple.GetColorTransferFunction("Illuminance"), simple.GetActiveView())
    assert bar.Title == "Illuminance (lx)", bar.Title
    assert colours_of_view() > 600, colours_of_view()
    simple.Hide(lit)
    assert colours_of_view() < 400, colours_of_view()


def test_luminaires_replace_the_own_lamp():
    begin()
    lit = new_map(room())
    lit.Luminaires = [simple.Luminaire(registrationName="Desk lamp")]
    simple.SetActiveSource(lit)
    window.wait()
    shown = window.labels()
    assert "Lamp Type (off: Luminaires are connected: Desk lamp)" in shown, shown
    assert "Luminous Flux (lm)" not in shown and "Place of the Lamp" not in shown, shown
    assert not window.offers("LampType")
    lit.Luminaires = []
    window.wait()
    assert "Luminous Flux (lm)" in window.labels() and window.offers("LampType")


def test_a_new_luminaire_is_placed_in_what_is_seen():
    begin()
    room()
    window.trigger("Luminaire")
    lamp = simple.GetActiveSource()
    assert list(lamp.Position) == [2.0, 1.5, 0.85 * 2.5], list(lamp.Position)
    lamp.Type = "Sphere"
    window.wait()
    assert "Radius (data's length)" in window.labels() and "Direction" not in window.labels(), window.labels()


def test_blocks_are_chosen_only_where_there_are_some():
    begin()
    source = room()
    simple.SetActiveSource(source)
    window.trigger("SurfaceMaterial")
    assert not window.offers("Blocks")
    material = simple.GetActiveSource()
    material.Preset = "White Paint"
    window.wait()
    assert "Preset (matt, reflects 0.85)" in window.labels(), window.labels()
    group = simple.GroupDatasets(Input=[source, room("other")])
    group.UpdatePipeline()
    simple.SetActiveSource(group)
    window.trigger("SurfaceMaterial")
    assert window.offers("Blocks")


def values(lit):
    return (lit.LampType, list(lit.LampPosition), lit.LuminousFlux, lit.PointData["Illuminance"].GetRange())


def test_undo_and_redo():
    begin()
    lit = new_map(room())
    window.apply()
    expected = values(lit)
    for _ in range(2):  # the apply, and the filter itself
        window.trigger("actionEditUndo")
    assert simple.FindSource("IlluminationMap1") is None
    for _ in range(2):
        window.trigger("actionEditRedo")
    again = simple.FindSource("IlluminationMap1")
    again.UpdatePipeline()
    assert values(again) == expected, (values(again), expected)


def test_state_and_trace_bring_the_map_back():
    begin()
    source = room()
    smtrace.start_trace(preamble="")
    lit = new_map(source)
    window.enter("LuminousFlux", "500")
    window.apply()
    assert lit.LuminousFlux == 500.0, lit.LuminousFlux
    script = smtrace.stop_trace()
    expected = values(lit)
    with tempfile.TemporaryDirectory() as folder:
        state = os.path.join(folder, "state.pvsm")
        simple.SaveState(state)
        begin()
        simple.LoadState(state)
        window.wait()
        again = simple.FindSource("IlluminationMap1")
        again.UpdatePipeline()
        assert values(again) == expected, (values(again), expected)
    begin()
    room()
    exec(script, {**vars(simple)})
    window.wait()
    again = simple.FindSource("IlluminationMap1")
    again.UpdatePipeline()
    assert values(again) == expected, (values(again), expected, script)


def pixel(point):
    """Where the view shows a point."""
    renderer = simple.GetActiveView().GetRenderer()
    renderer.SetWorldPoint(*point, 1.0)
    renderer.WorldToDisplay()
    return [int(v) for v in renderer.GetDisplayPoint()[:2]]


def drag(start, end):
    """With the mouse in the view, from a point in space to what the view shows of another."""
    view = simple.GetActiveView()
    simple.Render(view)
    window.wait()
    (x, y), (to_x, to_y) = pixel(start), pixel(end)
    interactor = view.GetInteractor()

    def mouse(event, step=0):
        interactor.SetEventInformation(x + (to_x - x) * step // 5, y + (to_y - y) * step // 5, 0, 0, "", 0, "")
        interactor.InvokeEvent(event)

    mouse("MouseMoveEvent")
    mouse("LeftButtonPressEvent")
    for step in range(1, 6):
        mouse("MouseMoveEvent", step)
    mouse("LeftButtonReleaseEvent", 5)
    window.wait()


def test_the_handle_moves_the_lamp():
    begin()
    lit = new_map(room())
    before = list(lit.LampPosition)
    drag(before, [before[0] + 0.5, before[1], before[2]])
    window.apply()
    after = list(lit.LampPosition)
    assert any(abs(a - b) > 0.1 for a, b in zip(before, after)), (before, after)


def test_handles_change_the_size_of_the_lamp():
    begin()
    lit = new_map(room())
    lit.LampType, lit.LampSize = "Rectangle", [1.0, 0.8]
    window.wait()
    x, y, z = lit.LampPosition
    place = list(lit.LampPosition)
    for start, end, expected in (((x + 0.5, y, z), (x + 0.75, y, z), (1.5, 0.8)),
                                 ((x, y - 0.4, z), (x, y - 0.6, z), (1.5, 1.2))):
        drag(start, end)
        window.apply()
        # A pixel is 0.02 of these lengths, and the mouse may take a handle beside its middle.
        off = max([abs(a - b) for a, b in zip(lit.LampSize, expected)])
        assert off < 0.1, (lit.LampSize, expected)
    assert list(lit.LampPosition) == place, "the handles of the size leave the place as it is"
    lit.LampType = "Disk"
    window.wait()
    drag((x + lit.LampSize[0], y, z), (x + 0.5, y, z))
    assert window.offers("Accept")
    window.apply()
    assert abs(lit.LampSize[0] - 0.5) < 0.1, lit.LampSize


def emitted(lit):
    return lit.FieldData.GetArray("PhotonsEmitted").GetRange()[0]


def test_the_map_refines_itself_until_all_photons_are_traced():
    begin()
    lit = new_map(room())
    window.enter("Photons", "2097152")
    window.click("Accept", 0.0)
    seen = [emitted(lit)]
    for _ in range(600):
        window.wait(0.1)
        if emitted(lit) != seen[-1]:
            seen.append(emitted(lit))
        if seen[-1] >= 2097152:
            break
    assert seen[0] < 2097152 and seen[-1] == 2097152 and len(seen) > 2 and seen == sorted(seen), seen


def test_pause_holds_a_run_and_delete_ends_it():
    begin()
    lit = new_map(room())
    window.enter("Photons", "10000000000")
    window.click("Accept", 0.5)
    window.click("Pause", 0.5)
    held = emitted(lit)
    window.wait(1.5)
    assert emitted(lit) == held < 1e10
    window.click("Pause", 0.0)
    for _ in range(300):
        window.wait(0.1)
        if emitted(lit) > held:
            break
    assert emitted(lit) > held
    window.click("Delete", 0.5)
    assert "IlluminationMap" not in "".join(name for name, _ in simple.GetSources())


def test_menus_have_icons():
    for name in ("IlluminationMap", "IlluminationMapSmoothing", "IlluminatedAppearance", "IlluminanceSensors",
                 "IlluminanceStatistics", "SurfaceMaterial", "SurfaceRefinement", "Luminaire"):
        assert window.has_icon(name), name


def main():
    failed = []
    simple.LoadPlugin(os.environ["ILLUMINATION_PLUGIN"], remote=False, ns=vars(simple))
    window.resize(1280, 850)
    for name, test in list(globals().items()):
        if name.startswith("test_"):
            try:
                print(name, flush=True)
                test()
            except BaseException:
                failed.append(f"{name}\n{traceback.format_exc()}")
    with open(os.environ["ILLUMINATION_WINDOW_RESULT"], "w") as result:
        result.write("\n".join(failed))
    window.close()


main()
