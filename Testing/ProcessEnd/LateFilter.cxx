// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIlluminationMap.h"

#include "vtkSphereSource.h"

/// A filter with a surface, not yet executed. The caller owns it.
extern "C" VTK_ABI_EXPORT vtkAlgorithm* MakeFilter(long long photons)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(32);
  auto* filter = vtkIlluminationMap::New();
  filter->SetInputConnection(sphere->GetOutputPort());
  filter->SetPhotons(photons);
  return filter;
}
