# SPDX-License-Identifier: BSD-3-Clause
"""ParaView lists the plugin and loads it by its name once it is asked to; Python has the class."""
from paraview import simple

simple.LoadDistributedPlugin("IlluminationMaps", ns=globals())
from vtkIllumination import vtkIlluminationMap  # noqa: E402

lit = simple.IlluminationMap(Input=simple.Plane(), Photons=10000)
lit.UpdatePipeline()
assert isinstance(lit.GetClientSideObject(), vtkIlluminationMap)
assert lit.PointData["Illuminance"].GetRange()[1] > 0.0
