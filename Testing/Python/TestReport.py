# SPDX-License-Identifier: BSD-3-Clause
"""The report: one page from a small scene, with all its parts, and its numbers against closed forms."""
import base64
import math
import os
import re
import tempfile
from html.parser import HTMLParser
from pathlib import Path

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
from vtkmodules.vtkCommonCore import vtkPoints
from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData

from illumination_report import write_report
from illumination_report.plan import find_level
from illumination_report.statistics import Statistics
from illumination_report.surfaces import lit_triangles

PARTS = ["Pictures", "Isolux plan", "Statistics", "Accuracy", "Warnings", "What was simulated, and why",
         "Notes", "Terms", "Versions"]  # fmt: skip


class Outline(HTMLParser):
    """Headings, pictures and the nesting of a page."""

    def __init__(self):
        super().__init__()
        self.open, self.headings, self.pictures, self.text = [], [], [], ""

    def handle_starttag(self, tag, attributes):
        if tag == "img":
            self.pictures.append(dict(attributes)["src"])
        elif tag != "meta":
            self.open.append(tag)
        if tag == "h2":
            self.headings.append("")

    def handle_endtag(self, tag):
        assert self.open.pop() == tag, tag

    def handle_data(self, data):
        self.text += data
        if self.open and self.open[-1] == "h2":
            self.headings[-1] += data


def outline(page):
    found = Outline()
    found.feed(page)
    assert not found.open, found.open
    return found


def ramp(height=0.0, size=1.0, up=1.0):
    """Two triangles of a square whose normals point up (1) or down (-1), with 100 lx at x = 0 and 300 lx
    at x = size; cell array Part: 0 and 1.
    """
    square = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], dtype=float)
    surface = vtkPolyData()
    surface.SetPoints(vtkPoints())
    surface.GetPoints().SetData(numpy_to_vtk(size * square + [0, 0, height], deep=1))
    corners = vtkCellArray()
    triangles = np.array([0, 1, 2, 0, 2, 3])
    corners.SetData(*(numpy_to_vtkIdTypeArray(a, deep=1) for a in (np.array([0, 3, 6]), triangles)))
    surface.SetPolys(corners)
    light = np.array([100.0, 300.0, 300.0, 100.0])
    arrays = {"Illuminance": light, "StandardError": 0.01 * light, "Normals": np.tile([0.0, 0.0, up], (4, 1))}
    for data, named in ((surface.GetPointData(), arrays), (surface.GetCellData(), {"Part": np.arange(2.0)})):
        for name, values in named.items():
            array = numpy_to_vtk(values, deep=1)
            array.SetName(name)
            data.AddArray(array)
    surface.GetPointData().SetActiveNormals("Normals")
    return lit_triangles(surface)[0]


def check_statistics():
    table = Statistics("Illuminance", metres_per_unit=0.5)
    table.add([ramp(), ramp(1.0)], "Both")
    table.add([ramp()], parts="Part", part_names=["Left"])
    (both, of_both), (left, of_left), (other, of_other) = table.rows
    assert (both, left, other) == ("Both", "Left", "1"), table.rows
    wanted = {"Area, m²": 0.5, "Mean, lx": 200.0, "Flux, lm": 100.0}
    for name, value in wanted.items():
        assert math.isclose(of_both[name][0], value), (name, of_both)
    assert of_both["Area, m²"][1] is None
    # As if the noise of all points went together: 1 % of the mean.
    assert math.isclose(of_both["Mean, lx"][1], 2.0), of_both
    for name, value in {"Minimum, lx": 100.0, "Maximum, lx": 300.0, "U0 (min/mean)": 0.5}.items():
        found, error = of_both[name]
        assert 0.0 < error < 0.05 * value and abs(found - value) <= 5.0 * error, (name, of_both)
    # Two of three corners of the first triangle have 300 lx, and one of the second.
    assert math.isclose(of_left["Mean, lx"][0], 700.0 / 3.0), of_left
    assert math.isclose(of_other["Mean, lx"][0], 500.0 / 3.0), of_other
    assert any("largest that they can be" in note for note in table.notes), table.notes
    try:
        table.add([ramp()], parts="None of these")
    except RuntimeError as error:
        assert "Illuminance Statistics" in str(error)
    else:
        raise AssertionError("there is no such array")


def check_levels():
    large, small = ramp(), ramp(2.0, size=0.5)
    assert find_level([small, large]).height == 0.0
    level = find_level([small, large], height=1.8)
    assert level.height == 2.0
    table = Statistics("Illuminance")
    table.add(level.surfaces, "Level")
    assert math.isclose(table.rows[0][1]["Area, m²"][0], 0.25), table.rows
    assert find_level([ramp(up=-1.0)]) is None
    assert find_level([large], up="y") is None


def check_page(folder):
    simple.LoadPlugin(os.environ["ILLUMINATION_PLUGIN"], ns=globals())
    try:
        write_report(folder / "none.html")
    except RuntimeError as error:
        assert "Illumination Map" in str(error)
    else:
        raise AssertionError("there is nothing to report on")
    room = simple.Box(XLength=4, YLength=3, ZLength=2.5)
    bare = simple.PassArrays(Input=simple.Triangulate(Input=room), PointDataArrays=[], CellDataArrays=[])
    inward = simple.ReverseSense(Input=bare)  # without normals the winding tells the side
    lit = IlluminationMap(  # noqa: F821
        Input=inward, LampType="Lambertian Point", LampPosition=[0, 0, 1.2], LuminousFlux=2000, Photons=300000, GroupMeans=1
    )
    dot = base64.b64decode(
        "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=="
    )
    path = write_report(folder / "deep" / "room.html", lit, title="Room <1> & more", pictures={"A & B": dot})
    page = path.read_text(encoding="utf-8")
    found = outline(page)
    assert found.headings == PARTS, found.headings
    assert len(found.pictures) == 3, len(found.pictures)
    for address in found.pictures:
        kind, data = address.split(",")
        assert kind == "data:image/png;base64", kind
        assert base64.b64decode(data).startswith(b"\x89PNG"), address[:80]
    assert not re.search('(src|href)=(?!"data:)', page), "the page needs no other file"
    assert "Room <1> & more" in found.text and "<1>" not in page, "text is escaped"
    for words in ("Plan: level z = -1.25 m", "interreflection: on", "Lambertian Point", "photon limit", "2,000", "A & B",
                  " ± ", "FacetError", "errors: by the differences between four groups"):  # fmt: skip
        assert words in found.text, words
    # The room's surface is 2 (4 · 3 + 4 · 2.5 + 3 · 2.5) m².
    assert ">59<" in page, page[page.index("Statistics") :][:800]


check_statistics()
check_levels()
with tempfile.TemporaryDirectory() as name:
    check_page(Path(name))
