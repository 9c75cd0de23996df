# SPDX-License-Identifier: BSD-3-Clause
"""Under MPI a scene on one rank is lit as without MPI; one that is spread over ranks gets one error
and no map. Run by mpiexec; without arguments it starts itself so, for 2 and 3 ranks."""
import math
import os
import subprocess
import sys
from pathlib import Path

SPREAD = "the scene is spread over several MPI ranks"

# Name of a scene -> (errors, mean illuminance of the map or None for no map).
SCENES = {
    "plane": (0, 1000.0),  # a source that only rank 0 has, lit by the default parallel light
    "plane_lamp": (0, "map"),
    "sphere": (1, None),
    "sphere_lamp": (1, None),
    "gathered": (0, "map"),
    "elsewhere": (0, 1000.0),
    "elsewhere_lamp": (1, None),  # surfaces on the last rank only, the luminaire on the first
    "nothing": (1, None),
    "bad_value": (1, None),
    "smoothed": (0, "map"),
    "smoothed_spread": (1, None),
}
ON_THREE = ("plane_lamp", "sphere", "gathered", "elsewhere", "elsewhere_lamp")


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


def scene(name):
    from paraview import simple
    simple.LoadPlugin(os.environ["ILLUMINATION_PLUGIN"], remote=False, ns=globals())
    if name == "nothing":
        surface = simple.ProgrammableSource(OutputDataSetType="vtkPolyData", Script="pass")
    elif name.startswith("elsewhere"):
        surface = simple.ProgrammableSource(OutputDataSetType="vtkPolyData", ScriptRequestInformation=PIECES,
                                            Script=PLANE_ON_LAST_RANK)
    elif name.startswith(("sphere", "gathered", "smoothed_spread")):
        surface = simple.Sphere()
        if name.startswith("gathered"):
            surface = simple.AggregateDataset(Input=surface, NumberOfTargetProcesses=1)
    else:
        surface = simple.Plane(XResolution=4, YResolution=4)
    more = {}
    if name.endswith("lamp"):
        more["Luminaires"] = [Luminaire(Type="Point", Position=[0, 0, 3])]  # noqa: F821
    if name == "bad_value":
        more["MaximumPathLength"] = 0
    if name == "smoothed_spread":
        surface.UpdatePipeline()
        map_like = simple.Calculator(Input=surface, ResultArrayName="Illuminance", Function="1")
        result, array = IlluminationMapSmoothing(Input=map_like), "IlluminanceSmoothed"  # noqa: F821
    else:
        result, array = IlluminationMap(Input=surface, Photons=20000, **more), "Illuminance"  # noqa: F821
        if name == "smoothed":
            result, array = IlluminationMapSmoothing(Input=result), "IlluminanceSmoothed"  # noqa: F821
    for _ in range(2):  # an execution after the first goes the same way
        result.UpdatePipeline()
    found = result.PointData[array]
    print("MAP", found.GetRange() if found else None, flush=True)


def check(ranks, name):
    errors, expected = SCENES[name]
    environment = dict(os.environ, OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    command = [os.environ["MPIEXEC"], *os.environ["MPIEXEC_FLAGS"].split(), "-n", str(ranks),
               os.environ["PVBATCH"], __file__, name]
    run = subprocess.run(command, env=environment, text=True, timeout=60,
                         stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    said = run.stdout
    about = f"{ranks} ranks, {name}:\n{said}"
    assert run.returncode == 0, about
    assert said.count("ERR|") == errors, about
    spread = name.startswith(("sphere", "smoothed_spread", "elsewhere_lamp"))
    assert (SPREAD in said) == spread, about
    maps = [line for line in said.splitlines() if line.startswith("MAP")]
    assert len(maps) == 1 and (maps[0] == "MAP None") == (expected is None), about
    if isinstance(expected, float):
        low, high = (float(number) for number in maps[0][5:-1].split(","))
        # 20000 Sobol points: below 2 % at each of the points
        assert math.isclose(low, expected, rel_tol=0.05) and math.isclose(high, expected, rel_tol=0.05), about
    print(ranks, name, maps[0], flush=True)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        scene(sys.argv[1])
    else:
        for kind in SCENES:
            check(2, kind)
        for kind in ON_THREE:
            check(3, kind)
        sys.path[:0] = [str(Path(__file__).resolve().parents[1])]
        from test_tables import put_result
        put_result(Path(os.environ["TEST_RESULTS"]), "SeveralRanks", "ScenesOnOneRankAndSpreadOverSeveral",
                   "ranks that light their own piece as if the others' did not exist",
                   f"{len(SCENES)} kinds of scene on 2 ranks, {len(ON_THREE)} on 3: a map or one error each")
