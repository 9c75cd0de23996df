# SPDX-License-Identifier: BSD-3-Clause
"""What the panel in ParaView's window says by hints in the XML: the unit of each property, as its help tells
it, and the numbers of presets. (Testing/Window sees that the window shows them.)"""
import os
import re
from pathlib import Path

import proxies
from paraview import servermanager, simple

PROXIES = (("filters", "IlluminationMap"), ("filters", "IlluminationMapSmoothing"), ("filters", "IlluminatedAppearance"),
           ("filters", "IlluminanceSensors"), ("filters", "IlluminanceStatistics"), ("filters", "SurfaceMaterial"),
           ("filters", "SurfaceRefinement"), ("sources", "Luminaire"), ("sources", "PhotometricReader"))
# How help texts name a unit, and how labels do.
UNITS = {"°": r"\b[dD]egrees", "m": r"\bmetres\b", "data's length": r"data's (unit of )?length", "lm": r"\blumens\b",
         "lx": r"\blux\b|\blx\b", "cd/m²": r"cd/m\^2", "lm/m²": r"lm/m\^2", "s": r"^Seconds\b", "GiB": r"^GiB\b",
         "fc": r"\bfc\b", "stops": r"\bstops\b", "distances between points": r"distances between points"}


def numbers():
    """(proxy, name, property) of all that are real numbers or arrays with a unit."""
    manager = servermanager.ProxyManager().SMProxyManager
    for group, name in PROXIES:
        proxy = manager.GetPrototypeProxy(group, name)
        for key in servermanager.Proxy(proxy=proxy).ListProperties():
            found = proxy.GetProperty(key)
            if found and (found.IsA("vtkSMDoubleVectorProperty") or key.endswith("Array")):
                yield name, key, found


def labels(found):
    hints = found.GetHints()
    elements = [hints.GetNestedElement(i) for i in range(hints.GetNumberOfNestedElements())] if hints else []
    return [element for element in elements if element.GetName() == "PanelLabel"]


def test_labels_have_the_units_that_the_help_tells():
    checked = 0
    for name, key, found in numbers():
        text = " ".join(found.GetDocumentation().GetDescription().split())
        told = {unit for unit, words in UNITS.items() if re.search(words, text)}
        shown = {element.GetAttribute("unit") for element in labels(found)} - {None}
        if key == "MetresPerUnit":
            told.discard("data's length")  # what it is the length of
        assert shown == told, (name, key, shown, told)
        checked += len(shown)
    assert checked > 40, checked


def test_presets_show_their_numbers():
    surface = simple.Plane()
    material = SurfaceMaterial(Input=surface)  # noqa: F821
    names = list(material.GetProperty("Preset").Available)
    shown = {int(e.GetAttribute("values")): e.GetAttribute("unit")
             for e in labels(material.GetProperty("Preset").SMProperty)}
    assert sorted(shown) == list(range(1, len(names))), shown  # all but Custom
    for number, text in shown.items():
        material.Preset = names[number]
        material.UpdatePipeline()
        cells = servermanager.Fetch(material).GetCellData()
        values = set()
        for array in ("DiffuseReflectance", "SpecularReflectance", "GlossyReflectance", "DiffuseTransmittance",
                      "ClearTransmittance"):
            values |= {round(v, 4) for v in cells.GetArray(array).GetTuple3(0)} - {0.0}
        if "roughness" in text:
            values.add(round(cells.GetArray("Roughness").GetTuple1(0), 4))
        if "index" in text:
            values.add(round(cells.GetArray("RefractiveIndex").GetTuple1(0), 4))
        told = {float(n) for n in re.findall(r"\d\.\d+", text)}
        assert told == values or (names[number] == "Opening" and values == {1.0}), (names[number], text, values)


def test_the_table_of_accuracy_opens_no_view_by_itself():
    hints = servermanager.ProxyManager().SMProxyManager.GetPrototypeProxy("filters", "IlluminationMap").GetHints()
    view = hints.FindNestedElementByName("View")
    assert (view.GetAttribute("type"), view.GetAttribute("port")) == ("None", "1")


def test_help_pages_do_not_ask_for_cell_arrays():
    pages = {page.name: page.read_text(encoding="utf-8") for page in Path(os.environ["ILLUMINATION_HELP"]).glob("*.html")}
    if not pages:
        print("There are no help pages in this build.")
        return
    assert {"filters.IlluminationMap.html", "sources.Luminaire.html"} <= set(pages), sorted(pages)
    for name, text in pages.items():
        assert "field array (cell)" not in text and "Suggested" not in name, name


if __name__ == "__main__":
    proxies.run_tests(globals())
