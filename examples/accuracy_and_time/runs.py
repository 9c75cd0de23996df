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
        self.proxy = simple.IlluminationMap(Input=self.source, **scene.lamp, **properties)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        simple.Delete(self.proxy)
        simple.Delete(self.source)

    def to(self, photons):
        """Goes on to so many photons; returns the illuminance of the points in lx."""
        self.proxy.Photons = photons
        self.proxy.UpdatePipeline()
        result = servermanager.Fetch(self.proxy)
        array = result.GetPointData().GetArray("Illuminance")
        if array is None:
            raise RuntimeError("IlluminationMap has failed; its message is above")
        return vtk_to_numpy(array).copy()

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
    text = repr(sorted(scene.lamp.items())).encode()
    data = b"".join(vtk_to_numpy(part).tobytes() for part in parts)
    return hashlib.sha256(text + data).hexdigest()[:12]


def long_run(scene, photons, folder):
    """The Truth by very many photons of another seed; kept in a file for the next time."""
    file = folder / f"{scene.name}_{digest(scene)}_{photons}_photons.npz"
    if not file.exists():
        print(f"{scene.name}: a long run of {photons} photons", flush=True)
        with Run(scene, Seed=1001) as run:
            np.savez(file, lux=run.to(photons), error=run.rounds()["RelativeError"][-1])
    kept = np.load(file)
    print(f"{scene.name}: the long run's own error is {100 * float(kept['error']):.3f} %")
    return Truth(kept["lux"], float(kept["error"]))
