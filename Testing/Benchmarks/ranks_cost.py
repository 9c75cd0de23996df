# SPDX-License-Identifier: BSD-3-Clause
"""What ranks cost, for Ranks.md: mpiexec -n N pvbatch --mpi --sym ranks_cost.py KIND [THREADS]

  cabin THREADS  seconds of a million photons in the cabin, by Photon Tracing, five times
  sum            seconds of sums over the ranks, by their length
  exchange       bytes and seconds for putting the cabin together, of which each rank has a part

Every rank runs it; the first one prints. PYTHONPATH names the folder of the module vtkIllumination.
"""

import sys
import time
from pathlib import Path

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkCharArray
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkParallelCore import vtkCommunicator, vtkMultiProcessController

from vtkIllumination import vtkIlluminationMap

sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "examples" / "cabin"))

CONTROLLER = vtkMultiProcessController.GetGlobalController()
RANK, RANKS = CONTROLLER.GetLocalProcessId(), CONTROLLER.GetNumberOfProcesses()


def tell(*what):
    if RANK == 0:
        print(RANKS, "ranks:", *what, flush=True)


def seconds(work):
    CONTROLLER.Barrier()
    start = time.perf_counter()
    work()
    CONTROLLER.Barrier()
    return time.perf_counter() - start


def cabin_map(threads, photons, surface=None):
    from cabin_geometry import make_cabin
    result = vtkIlluminationMap()
    result.SetInputData(surface if surface is not None else make_cabin() if RANK == 0 else vtkPolyData())
    result.SetLampType(result.EMITTING_FACETS)
    result.SetExitanceArray("Exitance")
    result.SetReflectanceArray("Reflectance")
    result.SetMethod(0)
    result.SetNumberOfThreads(threads)
    result.SetPhotons(photons)
    return result


def cabin(threads):
    """The rate of tracing: of a run that goes on, so without the building of the scene."""
    result = cabin_map(threads, 10**5)
    result.Update()
    for i in range(1, 6):
        result.SetPhotons(10**5 + i * 10**6)
        took = seconds(result.Update)
        table = result.GetOutputDataObject(1)
        spent = vtk_to_numpy(table.GetColumnByName("Seconds"))[-1]
        tell(threads, "threads,", f"{took:.3f} s for an execution, {spent:.3f} s in all rounds up to here")


def sums():
    """vtkCommunicator's AllReduce, as the filter calls it."""
    for length in 2 ** np.arange(0, 25, 3):
        values = numpy_to_vtk(np.ones(length, dtype=np.uint64), deep=True)
        result = values.NewInstance()
        result.SetNumberOfTuples(int(length))
        repeats = max(3, 2**14 // int(length))
        work = lambda: [CONTROLLER.AllReduce(values, result, vtkCommunicator.SUM_OP) for _ in range(repeats)]  # noqa
        took = sorted(seconds(work) / repeats for _ in range(5))[2]
        tell(8 * length, f"bytes, {took:.3e} s, {8 * length / took / 1e9:.3f} GB/s")


def exchange():
    from cabin_geometry import make_cabin
    surface = make_cabin() if RANK == 0 else vtkPolyData()
    bytes_ = vtkCharArray()
    marshal = seconds(lambda: vtkCommunicator.MarshalDataObject(surface, bytes_))
    tell(surface.GetNumberOfPoints(), "points,", surface.GetNumberOfCells(), "cells,",
         bytes_.GetNumberOfValues(), f"bytes, {marshal:.3f} s to make them")
    copy = vtkPolyData()
    tell(f"{seconds(lambda: vtkCommunicator.UnMarshalDataObject(bytes_, copy)):.3f} s to read them")
    result = cabin_map(1, 2048, surface)
    tell(f"{seconds(result.Update):.3f} s for a map of 2048 photons")


if __name__ == "__main__":
    kind = sys.argv[1]
    if kind == "cabin":
        cabin(int(sys.argv[2]))
    else:
        {"sum": sums, "exchange": exchange}[kind]()
