# SPDX-License-Identifier: BSD-3-Clause
"""Writes the report: what is in it, in which order, and where each part comes from."""

import datetime
import platform
from pathlib import Path

from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkVersion

from . import page, session
from .charts import ERRORS, data_uri, draw_accuracy, figure_uri
from .plan import draw_plan, find_level
from .statistics import Statistics
from .surfaces import facet_error, lit_triangles, part_names


def _texts(data, name):
    """The lines of a field array of text."""
    array = data.GetFieldData().GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())] if array else []


def _number(data, name):
    """The number of a field array; None if there is none."""
    array = data.GetFieldData().GetArray(name)
    return array.GetTuple1(0) if array and array.GetNumberOfValues() else None


def _statistics(surfaces, data, parts, level, up, metres):
    """Statistics of the whole, each block, each part and the level of the plan."""
    table = Statistics(surfaces[0].array, metres)
    table.add(surfaces, "All of the surface")
    if len(surfaces) > 1:
        for surface in surfaces:
            table.add([surface], surface.name)
    if parts:
        table.add(surfaces, parts=parts, part_names=part_names(data, parts))
    if level:
        table.add(level.surfaces, f"Plan: level {up} = {metres * level.height:.3g} m")
    return table


def _rounds(table):
    """Column -> values of the table Accuracy that the chart shows."""
    columns = ["Photons", "Seconds", *ERRORS]
    found = {name: table.GetRowData().GetArray(name) for name in columns}
    return {name: vtk_to_numpy(array).tolist() if array else [] for name, array in found.items()}


def _balance(data):
    """(what, value as text) of the run as a whole."""
    facts = {
        "Photons": ("PhotonsEmitted", "{:,.0f}"),
        "Absorbed": ("PhotonsAbsorbed", "{:,.0f}"),
        "Left the scene": ("PhotonsEscaped", "{:,.0f}"),
        "Luminous flux of all lamps, lm": ("EmittedFlux", "{:,.6g}"),
        "Time, s": ("Seconds", "{:.3g}"),
    }
    rows = [(what, _number(data, name), form) for what, (name, form) in facts.items()]
    rows = [(what, form.format(value)) for what, value, form in rows if value is not None]
    return rows + [("Ended by", text) for text in _texts(data, "StoppedBy")]


def _versions(data):
    """(what, version) of the programs."""
    return [
        ("Illumination Maps", ", ".join(_texts(data, "IlluminationMapsVersion"))),
        ("ParaView", str(simple.GetParaViewSourceVersion()).replace("paraview version ", "")),
        ("VTK", vtkVersion.GetVTKVersion()),
        ("Python", platform.python_version()),
    ]


def _scene(lit):
    """(heading, settings) of the filters that made the map and of its luminaires."""
    illumination = session.upstream(lit, session.MAP)
    smoothing = session.upstream(lit, session.SMOOTHING)
    tables = [("Illumination Map", session.settings(illumination))]
    tables += [("Illumination Map Smoothing", session.settings(smoothing))] if smoothing else []
    for i, lamp in enumerate(session.luminaires(illumination)):
        told = session.settings(lamp)
        tables.append((f"Luminaire {i + 1}: {lamp.SMProxy.GetXMLLabel()}", told))
    return tables


def write_report(path, lit=None, title="Illumination", pictures=None, parts=None, up="z", plan_height=None):
    """Writes a report on a lit surface as one HTML page that needs no other file.

    path: the file. lit: an Illumination Map or a filter after it; None: the active source, or else the
    last that comes from an Illumination Map. pictures: caption -> file of a PNG, or its bytes; None: all
    render views of the session as they are. parts: name of a cell array of numbers or text; its parts get
    statistics of their own, numbers under the names that a field array such as PartNames gives. up: the axis that
    points up, "x", "y" or "z". plan_height: of the level that the isolux plan shows, in the data's unit;
    None: the largest. Returns the path. Raises RuntimeError where there is no illumination map.
    """
    lit = session.lit_source(lit)
    illumination = session.upstream(lit, session.MAP)
    data = session.fetched(lit)
    surfaces = lit_triangles(data)
    if not surfaces:
        raise RuntimeError("there is nothing to report on: Illumination Map has made no map, see its message")
    metres = illumination.MetresPerUnit
    level = find_level(surfaces, up, plan_height)
    plan = draw_plan(level, session.places(illumination), up, metres) if level else None
    rounds = _rounds(session.fetched(illumination, 1))
    shown = session.session_pictures() if pictures is None else pictures
    images = {
        caption: data_uri(image if isinstance(image, bytes) else Path(image).read_bytes())
        for caption, image in shown.items()
    }
    statistics = _statistics(surfaces, data, parts, level, up, metres)
    html = page.report_page(
        title=title,
        date=datetime.datetime.now().strftime("%Y-%m-%d %H:%M"),
        pictures=images,
        plan=figure_uri(plan) if plan else None,
        statistics=statistics.rows,
        statistics_notes=statistics.notes,
        accuracy=figure_uri(draw_accuracy(rounds)) if len(rounds["Seconds"]) > 1 else None,
        rounds=rounds,
        facet_error=facet_error(surfaces),
        run=_balance(data),
        settings=_scene(lit),
        effects=_texts(data, "Effects"),
        warnings=_texts(data, "Warnings"),
        notes=_texts(data, "Notes") + _texts(data, "SmoothingNotes") + _texts(data, "AppearanceNotes"),
        versions=_versions(data),
    )
    path = Path(path)
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(html, encoding="utf-8")
    return path
