# SPDX-License-Identifier: BSD-3-Clause
"""The example states open, run and show something."""
import os
import tempfile

import proxies
from paraview import simple
from paraview.vtk.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkIOImage import vtkPNGReader

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "examples", "states")


def colours(view):
    reader = vtkPNGReader()
    with tempfile.TemporaryDirectory() as folder:
        reader.SetFileName(os.path.join(folder, "view.png"))
        simple.SaveScreenshot(reader.GetFileName(), view)
        reader.Update()
    pixels = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars()).astype(int)[:, :3]
    return len(set((pixels @ (1, 256, 65536)).tolist()))


def check_state(name):
    """@return The map."""
    simple.LoadState(os.path.join(FOLDER, name))
    lit = simple.FindSource("Illumination Map")
    lit.UpdatePipeline()
    fields = lit.FieldData
    assert fields.GetArray("FluxOnFronts").GetRange()[1] > 0.0
    simple.RenderAllViews()
    for view in simple.GetRenderViews():
        assert colours(view) > 300, (name, colours(view))
    return lit


def test_the_room_is_lit_by_its_luminaire():
    lit = check_state("room.pvsm")
    least, greatest = lit.PointData["Illuminance"].GetRange()
    # Straight below the panel: 4000 lm, 1.26 m away, about I0 / d^2 with I0 = 4000 / pi and its length.
    assert least > 50.0 and 600.0 < greatest < 1300.0, (least, greatest)


def test_the_garden_has_the_light_of_sun_and_sky():
    lit = check_state("garden.pvsm")
    greatest = lit.PointData["Illuminance"].GetRange()[1]
    assert 70000.0 < greatest < 70000.0 + 2 * 15000.0 + 25000.0, greatest
    assert lit.PointData["Illuminance_Sun"].GetRange()[0] == 0.0  # in the shadow, by final gathering


if __name__ == "__main__":
    proxies.run_tests(globals())
