// SPDX-License-Identifier: BSD-3-Clause
// One triangle under parallel light, by the core and by the VTK filter.
#include "PhotonTransport/transport/IlluminationRun.h"

#ifdef WITH_VTK_MODULE
#include "vtkIlluminationMap.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#endif

#include <cmath>
#include <iostream>

namespace
{
bool Near(double value, double expected, const char* what)
{
  std::cout << what << ": " << value << " lx, expected " << expected << " lx\n";
  return std::fabs(value - expected) < 0.01 * expected;
}

double MeanByCore()
{
  PhotonTransport::Surface surface;
  surface.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } };
  surface.normals.assign(3, { 0, 0, 1 });
  surface.facets = { { 0, 1, 2 } };
  surface.materials.resize(1);
  surface.materials[0].diffuseReflectance = PhotonTransport::Colour(0.5F);
  surface.materialOfFacet = { 0 };
  const PhotonTransport::Scene scene(surface);
  const PhotonTransport::ParallelLight light{ { 0, 0, -1 }, 100.0 };
  PhotonTransport::IlluminationRun run(scene, light, {});
  run.Advance({ 100'000 });
  const PhotonTransport::IlluminationMap map = run.Front();
  return (map.direct[0] + map.direct[1] + map.direct[2]) / 3.0;
}

#ifdef WITH_VTK_MODULE
double MeanByFilter()
{
  vtkNew<vtkPlaneSource> plane;
  vtkNew<vtkIlluminationMap> illuminate;
  illuminate->SetInputConnection(plane->GetOutputPort());
  illuminate->SetParallelIlluminance(100.0);
  illuminate->Update();
  vtkDataArray* illuminance = illuminate->GetOutput()->GetPointData()->GetArray("Illuminance");
  double sum = 0.0;
  for (vtkIdType i = 0; illuminance && i < illuminance->GetNumberOfTuples(); ++i)
  {
    sum += illuminance->GetTuple1(i);
  }
  return illuminance ? sum / static_cast<double>(illuminance->GetNumberOfTuples()) : 0.0;
}
#endif
}

int main()
{
  bool good = Near(MeanByCore(), 100.0, "core");
#ifdef WITH_VTK_MODULE
  good = Near(MeanByFilter(), 100.0, "filter") && good;
#endif
  return good ? 0 : 1;
}
