# SPDX-License-Identifier: BSD-3-Clause
"""Both methods, as they are and smoothed: error at points against seconds, all work included."""

import time

import numpy as np
from paraview import servermanager, simple
from vtk.util.numpy_support import vtk_to_numpy

from runs import Run, photon_numbers

METHODS = ("Photon Tracing", "Final Gathering")
FEWEST = 5_000  # photons
MOST = 10**9


def told_error(run, method):
    """What the filter tells of the error at each point (lx): noise and, with facets, FacetError."""
    noise = run.array("StandardError")
    return noise if method == "Final Gathering" else np.hypot(noise, run.array("FacetError"))


def smoothed_map(run):
    """The smoothed illuminance of a run (lx), what it tells of its error, and its seconds."""
    proxy = simple.IlluminationMapSmoothing(Input=run.proxy)
    start = time.perf_counter()
    proxy.UpdatePipeline()
    seconds = time.perf_counter() - start
    points = servermanager.Fetch(proxy).GetPointData()
    simple.Delete(proxy)
    names = ("IlluminanceSmoothed", "StandardErrorSmoothed")
    lux, error = (vtk_to_numpy(points.GetArray(name)).copy() for name in names)
    return lux, error, seconds


def points_of_curves(scene, truth, method, photons):
    """Two rows, of the map as it is and of the smoothed one, from a run of its own."""
    with Run(scene, Method=method) as run:
        start = time.perf_counter()
        lux = run.to(photons)
        seconds = time.perf_counter() - start
        told = told_error(run, method)
        smooth, smooth_told, more = smoothed_map(run)
    return [
        {
            "Scene": scene.name,
            "Method": method,
            "Smoothed": smoothed,
            "Photons": photons,
            "Seconds": took,
            "True error": scene.relative_error(values, truth),
            "Estimated error": scene.share(error, truth.lux),
            "Truth's error": truth.error,
        }
        for smoothed, took, values, error in (
            ("no", seconds, lux, told),
            ("yes", seconds + more, smooth, smooth_told),
        )
    ]


def method_curve(scene, truth, method, longest):
    """Rows of a method's curves of a scene, up to the first run of so many seconds."""
    rows = []
    points_of_curves(scene, truth, method, FEWEST)  # the first run also loads what all need
    for photons in photon_numbers(MOST, FEWEST):
        rows += points_of_curves(scene, truth, method, photons)
        if rows[-2]["Seconds"] > longest:
            break
    print(f"{scene.name}: {method}", flush=True)
    return rows
