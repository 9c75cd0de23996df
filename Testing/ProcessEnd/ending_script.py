# SPDX-License-Identifier: BSD-3-Clause
"""Makes a map and ends as its argument says."""
import os
import sys

from paraview import simple

simple.LoadPlugin(os.environ["ILLUMINATION_PLUGIN"], remote=False, ns=globals())
lit = IlluminationMap(Input=simple.Sphere(), Photons=20000)  # noqa: F821
lit.UpdatePipeline()
assert lit.PointData["Illuminance"].GetRange()[1] > 0.0
way = sys.argv[1]
if way == "exit":
    sys.exit(3)
elif way == "os_exit":
    os._exit(4)
elif way == "raise":
    raise ValueError("on purpose")
elif way == "delete":
    simple.Delete(lit)
    del lit
    sys.exit(0)
elif way == "disconnect":
    simple.Disconnect()
    sys.exit(0)
