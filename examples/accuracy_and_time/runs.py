# SPDX-License-Identifier: BSD-3-Clause
"""Runs the filter and goes on: each photon number costs only what it has more than the last."""

import hashlib

import numpy as np
from paraview import servermanager, simple
from vtk.util.numpy_support import vtk_to_numpy

from illumination import as_source
from scenes import Truth

COLUMNS = (
    "Photons",
    "Seconds",
    "RelativeError",
    "SegmentsPerSecond",
    "PredictedSeconds",
)


class Run:
    """One filter that is asked for more and more photons."""

    def __init__(self, scene, **properties):
        self.source = as_source(scene.surface)
        self.lamps = [simple.Luminaire(**scene.luminaire)] if scene.luminaire else []
        lamp = {"Luminaires": self.lamps} if self.lamps else {}
        self.proxy = simple.IlluminationMap(Input=self.source, **lamp, **scene.lamp, **properties)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        for one in (self.proxy, *self.lamps, self.source):
            simple.Delete(one)

    def array(self, name):
        """A point array of the map as it is."""
        array = servermanager.Fetch(self.proxy).GetPointData().GetArray(name)
        if array is None:
            raise RuntimeError("IlluminationMap has failed; its message is above")
        return vtk_to_numpy(array).copy()

    def to(self, photons):
        """Goes on to so many photons; returns the illuminance of the points in lx."""
        self.proxy.Photons = photons
        self.proxy.UpdatePipeline()
        return self.array("Illuminance")

    def rounds(self):
        """The table Accuracy so far: column name -> array with a value for each round."""
        table = servermanager.Fetch(self.proxy, idx=1)
        return {name: vtk_to_numpy(table.GetColumnByName(name)).astype(float) for name in COLUMNS}


def photon_numbers(largest, smallest=10_000):
    """1, 2, 5, 10, 20, ... times a power of ten, from the smallest to the largest."""
    numbers = [k * 10**power for power in range(12) for k in (1, 2, 5)]
    return [n for n in numbers if smallest <= n <= largest]


def curve(scene, truth, photons, **properties):
    """Rows of a curve: growing photon numbers, errors as shares of the mean illuminance."""
    rows = []
    with Run(scene, **properties) as run:
        for n in photons:
            lux = run.to(n)
            now = {name: float(values[-1]) for name, values in run.rounds().items()}
            rows.append(
                {
                    "Photons": int(now["Photons"]),
                    "Seconds": now["Seconds"],
                    "True error": scene.relative_error(lux, truth),
                    "Estimated error": now["RelativeError"],
                    "Segments per second": now["SegmentsPerSecond"],
                }
            )
    return rows


def digest(scene):
    """A few letters that stand for a scene's surface and lamp."""
    surface = scene.surface
    parts = [surface.GetPoints().GetData(), surface.GetPolys().GetConnectivityArray()]
    parts += [surface.GetPointData().GetNormals()]
    cells = surface.GetCellData()
    parts += [cells.GetArray(i) for i in range(cells.GetNumberOfArrays())]
    lamps = sorted({**scene.lamp, **(scene.luminaire or {})}.items())
    text = repr(lamps).encode()
    data = b"".join(vtk_to_numpy(part).tobytes() for part in parts)
    return hashlib.sha256(text + data).hexdigest()[:12]


def long_run(scene, photons, folder, method="Final Gathering"):
    """The Truth by very many photons of another seed; kept in a file for the next time.

    By Final Gathering it is the light at the points themselves; by Photon Tracing a mean over the
    facets around them, against which a map has no error but noise.
    """
    file = folder / f"{scene.name}_{digest(scene)}_{method.replace(' ', '_')}_{photons}.npz"
    if not file.exists():
        print(f"{scene.name}: a long run of {photons} photons, {method}", flush=True)
        with Run(scene, Seed=1001, Method=method) as run:
            lux = run.to(photons)
            np.savez(file, lux=lux, error=scene.share(run.array("StandardError"), lux))
    kept = np.load(file)
    print(f"{scene.name}: the long run's own error is {100 * float(kept['error']):.3f} %")
    return Truth(kept["lux"], float(kept["error"]))


def truth_of(scene, folder):
    """The exact illuminance, or where it is not known that of a long run at the points."""
    return scene.exact if scene.exact is not None else long_run(scene, scene.long, folder)
