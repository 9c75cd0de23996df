# SPDX-License-Identifier: BSD-3-Clause
"""Under MPI all ranks light a scene together, of which each has a part.

 - On 1 to 4 ranks, with 1 and 2 threads, maps have the bits that they have without MPI.
 - Errors and stops of all kinds, on all ranks or on one, leave no rank waiting and are told once.
 - The filters do so in a pipeline of ParaView as well, whose sources are on one rank or on all.

Starts itself by mpiexec; see rank_scenes.py for what ranks do.
"""

import json
import math
import os
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
WORKER = HERE / "rank_scenes.py"
TIMEOUT = 300  # s; far above what a busy machine takes, since only a rank that waits for ever reaches it


def start(ranks, *arguments):
    """Runs pvbatch on so many ranks; 0 is without MPI."""
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    command = [os.environ["PVBATCH"], *map(str, arguments)]
    if ranks:
        command = [os.environ["MPIEXEC"], *os.environ["MPIEXEC_FLAGS"].split(), "-n", str(ranks), command[0],
                   "--mpi", *command[1:]]
    run = subprocess.run(command, env=environment, text=True, timeout=TIMEOUT, stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT)
    assert run.returncode == 0, f"{ranks} ranks, {arguments}:\n{run.stdout}"
    return run.stdout


def read(folder, kind, ranks):
    return [json.loads((folder / f"{kind}{rank}.json").read_text()) for rank in range(max(1, ranks))]


def check_same(folder):
    """Returns how many maps were the same."""
    start(0, WORKER, "same", folder)
    alone = {name.rsplit(", ", 1)[0]: found for name, found in read(folder, "same_1_", 1)[0].items()}
    assert len(alone) >= 20 and all(found["points"] for found in alone.values())
    for name, found in alone.items():
        one_thread = alone[name.replace("2 threads", "1 threads")]
        assert found == one_thread, name
    continued, at_once = alone["continued 0, 1 threads"], alone["photons 0, 1 threads"]
    assert continued["points"] == at_once["points"]
    compared = 0
    for ranks in (1, 2, 3, 4):
        start(ranks, "--sym", WORKER, "same", folder)
        parts = read(folder, f"same_{ranks}_", ranks)
        for name in parts[0]:
            wanted = alone[name.rsplit(", ", 1)[0]]
            about = f"{ranks} ranks, {name}"
            for kind in ("points", "cells"):
                got = [row for part in parts for row in part[name][kind]]
                got = sorted(set(got)) if kind == "points" else sorted(got)
                assert got == wanted[kind], f"{about}: {len(set(got) ^ set(wanted[kind]))} {kind} differ"
            for part in parts:
                assert part[name]["fields"] == parts[0][name]["fields"], about
            compared += 1
    return compared


def check_statistics(folder):
    """The sums of a table are added in another order, so they may differ by rounding; other numbers may not."""
    for ranks in (0, 3):
        start(ranks, *["--sym"] * (ranks > 0), WORKER, "statistics", folder)
    alone = read(folder, "statistics_1_", 1)[0]
    first, *others = read(folder, "statistics_3_", 3)
    assert first.keys() == alone.keys() and not any(any(column) for other in others for column in other.values())
    for name, column in alone.items():
        assert len(column) == len(first[name]) == 2, (name, column, first[name])
        for wanted, got in zip(column, first[name]):
            same = wanted == got or math.isclose(wanted, got, rel_tol=1e-9)
            assert same, (name, wanted, got)


def check_suggestion(folder):
    for ranks in (0, 2):
        start(ranks, *["--sym"] * (ranks > 0), WORKER, "suggestion", folder)
    alone = read(folder, "suggestion_1_", 1)[0]
    assert 0.05 < alone[1] < 0.1, alone  # the size of a lamp for the room, not the default
    for found in read(folder, "suggestion_2_", 2):
        same = [math.isclose(a, b, rel_tol=1e-9, abs_tol=1e-9) for a, b in zip(alone, found, strict=True)]
        assert all(same), (alone, found)


def check_errors(folder):
    start(3, "--sym", WORKER, "errors", folder)
    parts = read(folder, "errors_", 3)
    for name in parts[0]:
        words, has_map = parts[0][name]["expected"]
        said = [message for part in parts for message in part[name]["errors"]]
        about = f"{name}: {said}"
        assert len(said) == (1 if words else 0), about
        assert not words or words in said[0], about
        for part in parts:
            assert part[name]["map"] == has_map or part[name]["points"] == 0, about
            assert part[name]["fields"] == parts[0][name]["fields"], about
            assert part[name]["after"], about
    return len(parts[0])


# ---- ParaView's pipelines

# name -> (errors, mean illuminance of the map, "map" or None for no map)
PIPELINES = {
    "plane": (0, 1000.0),  # a source that only rank 0 has, lit by the default parallel light
    "plane_lamp": (0, "map"),
    "sphere": (0, "map"),  # a source of which each rank has a part
    "sphere_lamp": (0, "map"),
    "elsewhere": (0, 1000.0),
    "elsewhere_lamp": (0, "map"),  # the surface on the last rank only, the luminaire on the first
    "nothing": (1, None),
    "bad_value": (1, None),
    "smoothed": (0, "map"),
}
PIECES = """
info = self.GetOutputInformation(0)
info.Set(self.CAN_HANDLE_PIECE_REQUEST(), 1)
"""
PLANE_ON_LAST_RANK = """
from vtkmodules.vtkFiltersSources import vtkPlaneSource
from vtkmodules.vtkParallelCore import vtkMultiProcessController
controller = vtkMultiProcessController.GetGlobalController()
if controller.GetLocalProcessId() == controller.GetNumberOfProcesses() - 1:
    plane = vtkPlaneSource()
    plane.SetResolution(4, 4)
    plane.Update()
    self.GetOutput().ShallowCopy(plane.GetOutput())
"""


def pipeline(name):
    from paraview import simple
    if name == "nothing":
        surface = simple.ProgrammableSource(OutputDataSetType="vtkPolyData", Script="pass")
    elif name.startswith("elsewhere"):
        surface = simple.ProgrammableSource(OutputDataSetType="vtkPolyData", ScriptRequestInformation=PIECES,
                                            Script=PLANE_ON_LAST_RANK)
    elif name.startswith(("sphere", "smoothed")):
        surface = simple.Sphere()
    else:
        surface = simple.Plane(XResolution=4, YResolution=4)
    more = {}
    if name.endswith("lamp"):
        more["Luminaires"] = [Luminaire(Type="Point", Position=[0, 0, 3])]  # noqa: F821
    if name == "bad_value":
        more["MaximumPathLength"] = 0
    result, array = IlluminationMap(Input=surface, Photons=20000, **more), "Illuminance"  # noqa: F821
    if name == "smoothed":
        result, array = IlluminationMapSmoothing(Input=result), "IlluminanceSmoothed"  # noqa: F821
    tell(f"PIPELINE {name}")
    for _ in range(2):  # an execution after the first goes the same way
        result.UpdatePipeline()
    found = result.PointData[array]
    tell(f"MAP {found.GetRange() if found else None}")


def tell(line):
    """Writes to the stream of VTK's messages, in one piece: mpiexec forwards each stream for itself, so that lines on
    another one would come before or after messages by chance."""
    os.write(2, f"{line}\n".encode())


def pipelines():
    from paraview import simple
    simple.LoadPlugin(os.environ["ILLUMINATION_PLUGIN"], remote=False, ns=globals())
    for name in PIPELINES:
        pipeline(name)


def check_pipelines():
    said = start(2, HERE / "TestSeveralRanks.py", "pipelines").split("PIPELINE ")[1:]
    assert len(said) == len(PIPELINES), said
    for (name, (errors, expected)), lines in zip(PIPELINES.items(), said):
        assert lines.startswith(name + "\n"), lines
        assert lines.count("ERR|") == errors, lines
        maps = [line for line in lines.splitlines() if line.startswith("MAP")]
        assert len(maps) == 1 and (maps[0] == "MAP None") == (expected is None), lines
        if isinstance(expected, float):
            low, high = (float(number) for number in maps[0][5:-1].split(","))
            # 20000 Sobol points: below 2 % at each of the points
            assert abs(low / expected - 1) < 0.05 and abs(high / expected - 1) < 0.05, lines


def check():
    with tempfile.TemporaryDirectory() as folder:
        maps = check_same(Path(folder))
        print(maps, "maps on 1 to 4 ranks have the same bits", flush=True)
        check_statistics(Path(folder))
        check_suggestion(Path(folder))
        stops = check_errors(Path(folder))
        print(stops, "errors and stops on 3 ranks", flush=True)
    check_pipelines()
    sys.path[:0] = [str(HERE.parent)]
    from test_tables import put_result
    results = Path(os.environ["TEST_RESULTS"])
    put_result(results, "SeveralRanks", "SameBits", "maps that depend on how a surface is divided between ranks",
               f"{maps} maps on 1 to 4 ranks with 1 and 2 threads: the bits without MPI")
    put_result(results, "SeveralRanks", "ErrorsAndStops", "a rank that waits for ever, errors told by each rank",
               f"{stops} kinds on 3 ranks: one message each, and all go on")


if __name__ == "__main__":  # without sys.exit, which leaves MPI without its end
    pipelines() if len(sys.argv) > 1 else check()
