# SPDX-License-Identifier: BSD-3-Clause
"""The classes work from Python without ParaView's proxies, on plain VTK data."""
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkFiltersSources import vtkSphereSource

from vtkIllumination import vtkIlluminationMap

sphere = vtkSphereSource()
sphere.SetThetaResolution(24)
sphere.SetPhiResolution(12)

illuminate = vtkIlluminationMap()
illuminate.SetInputConnection(sphere.GetOutputPort())
illuminate.SetLampType(illuminate.PARALLEL)
illuminate.SetParallelIlluminance(500)
illuminate.SetPhotons(200000)
illuminate.Update()

illuminance = illuminate.GetOutput().GetPointData().GetArray("Illuminance")
assert illuminance is not None
assert illuminate.GetOutput().GetNumberOfPoints() == illuminance.GetNumberOfTuples()
low, high = illuminance.GetRange()
assert low == 0, low  # the side away from the light
assert 490 < high < 550, high
assert "ParallelIlluminance: 500" in str(illuminate)
