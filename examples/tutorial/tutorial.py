# SPDX-License-Identifier: BSD-3-Clause
"""Makes the tutorial's pictures in ParaView's window, by the steps that the tutorial tells.

paraview --script=tutorial.py runs this; the folder is $ILLUMINATION_TUTORIAL. The build's target
TutorialPictures does it on a virtual screen.
"""

import os
import traceback
from pathlib import Path

import window
from paraview import simple

FOLDER = Path(os.environ["ILLUMINATION_TUTORIAL"])


def picture(name):
    simple.RenderAllViews()
    window.wait(0.5)
    window.picture(str(FOLDER / f"{name}.png"))


def look(position, focus, angle=30):
    view = simple.GetActiveView()
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = position, focus, (0, 0, 1)
    view.CameraViewAngle = angle


def by_menu(name, source):
    simple.SetActiveSource(None)
    simple.SetActiveSource(source)
    window.wait()
    window.trigger(name, 0.5)
    return simple.GetActiveSource()


def open_room():
    room = simple.OpenDataFile(str(FOLDER / "room.obj"), registrationName="room.obj")
    simple.Show(room).BackfaceRepresentation = "Cull Backface"
    look((9.5, -6.5, 5.5), (2.5, 2.0, 1.2))
    picture("1_room")
    return room


def refine(room):
    fine = by_menu("SurfaceRefinement", room)
    window.enter("MaximumEdgeLength", "0.15")
    window.apply()
    display = simple.Show(fine)
    display.Representation, display.BackfaceRepresentation = "Surface With Edges", "Cull Backface"
    picture("2_refined")
    display.Representation = "Surface"
    return fine


def show_map(lit, most):
    """@param most lx, the end of the colours; the ceiling beside a lamp, which is not seen, is far brighter."""
    display = simple.Show(lit)
    display.BackfaceRepresentation = "Cull Backface"
    display.SetScalarBarVisibility(simple.GetActiveView(), True)
    simple.GetColorTransferFunction("Illuminance").RescaleTransferFunction(0, most)


def light(fine):
    lit = by_menu("IlluminationMap", fine)
    lit.Progressive = 0  # each picture is of a finished map
    picture("3_new_map")
    window.apply(1)
    show_map(lit, 120)
    picture("4_first_map")
    return lit


def change_lamp(lit):
    simple.SetActiveSource(lit)
    lit.LampType = "Disk"
    window.wait(0.3)
    window.enter("LampSize", "0.3")
    window.enter("LuminousFlux", "3000")
    window.enter("TargetRelativeError", "0.02")
    window.enter("Photons", "1000000000")
    window.apply(2)
    show_map(lit, 350)
    picture("5_disk")


def chart(lit):
    layout, render = simple.GetLayout(), simple.GetActiveView()
    layout.SplitVertical(0, 0.55)
    view = simple.CreateView("XYChartView")
    layout.AssignView(2, view)
    display = simple.Show(simple.OutputPort(lit, 1), view)
    display.UseIndexForXAxis, display.XArrayName = 0, "Seconds"
    display.SeriesVisibility = ["RelativeError"]
    view.LeftAxisLogScale, view.BottomAxisLogScale = 1, 1
    view.LeftAxisTitle, view.BottomAxisTitle = "RelativeError", "seconds"
    simple.SetActiveView(view)
    picture("6_accuracy")
    layout.RemoveView(view)
    layout.Collapse(2)
    simple.Delete(view)
    simple.SetActiveView(render)


def appearance(lit):
    smooth = by_menu("IlluminationMapSmoothing", lit)
    window.apply(1)
    look_of_room = by_menu("IlluminatedAppearance", smooth)
    window.apply(1)
    simple.HideAll()
    simple.Show(look_of_room)
    look((4.8, 0.2, 1.6), (1.5, 2.6, 1.0), 70)
    picture("7_appearance")


def luminaires(lit):
    simple.HideAll()
    simple.Show(lit)
    look((9.5, -6.5, 5.5), (2.5, 2.0, 1.2))
    lamps = []
    for number, x in ((1, 1.5), (2, 3.5)):
        window.trigger("Luminaire", 0.5)
        lamp = simple.GetActiveSource()
        simple.RenameSource(f"Panel {number}", lamp)
        lamp.Type, lamp.Position, lamp.Size, lamp.LuminousFlux = "Rectangle", [x, 2.0, 2.75], [0.6, 0.6], 2500
        lamp.LuminaireName = f"Panel {number}"
        window.wait()
        simple.Show(lamp)
        lamps.append(lamp)
    lit.Luminaires = lamps
    lit.UpdatePipeline()
    simple.SetActiveSource(lit)
    window.apply_if_offered(2)
    show_map(lit, 500)
    picture("8_luminaires")


def main():
    simple.LoadPlugin(os.environ["ILLUMINATION_PLUGIN"], remote=False, ns=vars(simple))
    window.resize(1280, 850, panel=360)
    room = open_room()
    fine = refine(room)
    lit = light(fine)
    change_lamp(lit)
    chart(lit)
    appearance(lit)
    luminaires(lit)


failed = ""
try:
    main()
except BaseException:
    failed = traceback.format_exc()
Path(os.environ["ILLUMINATION_WINDOW_RESULT"]).write_text(failed)
window.close()
