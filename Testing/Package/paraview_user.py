# SPDX-License-Identifier: BSD-3-Clause
"""ParaView loads the plugin by itself from a folder on PV_PLUGIN_PATH; Python has the class and the report."""
from paraview.simple import *
from illumination_report import write_report
from vtkIllumination import vtkIlluminationMap

illuminated = IlluminationMap(Input=Plane(), Photons=10000)
illuminated.UpdatePipeline()
assert isinstance(illuminated.GetClientSideObject(), vtkIlluminationMap)
assert illuminated.GetProperty("Photons").GetData() == 10000

assert write_report("report.html", illuminated, pictures={}).stat().st_size > 10000
