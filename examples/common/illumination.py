# SPDX-License-Identifier: BSD-3-Clause
"""Runs the filter IlluminationMap on a surface and hands out what it found."""

import os
from dataclasses import dataclass
from pathlib import Path

import numpy as np
from paraview import servermanager, simple
from vtk.util.numpy_support import vtk_to_numpy

REGISTRATIONS = ("Flat", "Facet Ratio", "Vertex Normalised")


@dataclass
class IlluminationMap:
    """A surface with its illumination map."""

    surface: object  # vtkPolyData with the filter's arrays
    facts: dict  # the filter's field data of one value each: name -> number or text

    def array(self, name="Illuminance"):
        """A point array, such as the illuminance in lx."""
        return vtk_to_numpy(self.surface.GetPointData().GetArray(name))


def load_plugin():
    """Makes the filter known to ParaView; the environment says where the plugin is."""
    simple.LoadPlugin(os.environ["ILLUMINATION_PLUGIN"], remote=False, ns=vars(simple))


def python_packages():
    """Folders of Python packages beside the plugin: vtkIllumination and illumination_report."""
    libraries = Path(os.environ["ILLUMINATION_PLUGIN"]).resolve().parents[3]
    return [str(folder) for folder in libraries.glob("python3*/*-packages")]


def as_source(data):
    """A ParaView source that hands out a VTK data object."""
    source = simple.TrivialProducer()
    source.GetClientSideObject().SetOutput(data)
    source.UpdatePipeline()
    return source


def texts(data, name):
    """The lines of a field array of text, such as Notes or Effects."""
    array = data.GetFieldData().GetAbstractArray(name)
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())] if array else []


def facts_of(data):
    """The field arrays of one value each: name -> number or text."""
    arrays = data.GetFieldData()
    facts = {}
    for i in range(arrays.GetNumberOfArrays()):
        array = arrays.GetAbstractArray(i)
        if array.GetNumberOfValues() == 1:
            value = array.GetVariantValue(0)
            facts[array.GetName()] = value.ToDouble() if array.IsNumeric() else value.ToString()
    return facts


def through(make_proxy, surface, **properties):
    """What a filter makes of a vtkPolyData."""
    source = as_source(surface)
    proxy = make_proxy(Input=source, **properties)
    proxy.UpdatePipeline()
    result = servermanager.Fetch(proxy)
    simple.Delete(proxy)
    simple.Delete(source)
    return result


def run_filter(make_proxy, surface, wanted, properties):
    """What a filter makes of a vtkPolyData; raises if a point array that is wanted is not there."""
    result = through(make_proxy, surface, **properties)
    if result.GetPointData().GetArray(wanted) is None:
        raise RuntimeError(f"no {wanted}: the filter has failed; its message is above")
    return result


def illuminate(surface, **properties):
    """The illumination map of a vtkPolyData; properties are those of the filter, by name."""
    result = run_filter(simple.IlluminationMap, surface, "Illuminance", properties)
    return IlluminationMap(result, facts_of(result))


def smooth(surface, **properties):
    """An illuminated vtkPolyData with the arrays of IlluminationMapSmoothing, whose properties these are."""
    return run_filter(
        simple.IlluminationMapSmoothing, surface, "StandardErrorSmoothed", properties)


def illuminance_of_seeds(surface, seeds, array="Illuminance", **properties):
    """Illuminance (lx) by independent runs: one row a seed, one column a point."""
    return np.array([illuminate(surface, Seed=seed, **properties).array(array) for seed in seeds])
