// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSuggestedLamp.h"

#include "Illumination/luminaires/SuggestedLamp.h"
#include "Illumination/pipeline/InputError.h"
#include "Illumination/ranks/ControllerRanks.h"
#include "Illumination/ranks/WholeSurface.h"
#include "Illumination/surface/SurfaceParts.h"
#include "Illumination/surface/SurfaceTriangles.h"
#include "vtkIlluminationMap.h"

#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

using namespace Illumination;

vtkStandardNewMacro(vtkSuggestedLamp);

namespace
{

LitTriangles TrianglesOfAllBlocks(vtkDataObject* input)
{
  LitTriangles all;
  for (const NamedSurface& surface : PartsOf(input).surfaces)
  {
    if (HasSurface(surface.data))
    {
      const SurfaceTriangles triangles =
        TrianglesOf(surface.data, surface.data->GetPointData()->GetNormals(), surface.name);
      AppendFacets(triangles.mesh, all.points.size(), all.facets);
      AppendPoints(triangles.mesh, all.points);
      AppendNormals(triangles.mesh, all.normals);
    }
  }
  return all;
}

SuggestedLamp SuggestionFor(vtkDataObject* input)
{
  try
  {
    return SuggestLamp(TrianglesOfAllBlocks(input));
  }
  catch (const InputError&) // the map will tell
  {
    return {};
  }
}

} // namespace

int vtkSuggestedLamp::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  info->Append(INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkSuggestedLamp::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector*)
{
  // An observer may disconnect the input.
  const vtkSmartPointer<vtkDataObject> in = vtkDataObject::GetData(input[0]);
  SuggestedLamp lamp;
  ControllerRanks ranks;
  ranks.Together(
    [&] { lamp = SuggestionFor(ranks.AreSeveral() ? WholeSurface(ranks, in).Data() : in.Get()); });
  this->LampType = lamp.isParallel ? vtkIlluminationMap::PARALLEL : vtkIlluminationMap::POINT;
  for (int i = 0; i < 3; ++i)
  {
    this->LampPosition[i] = lamp.position[i];
    this->LampDirection[i] = lamp.direction[i];
  }
  this->LampSize = lamp.size;
  return 1;
}

void vtkSuggestedLamp::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "LampType: " << this->LampType << "\n"
     << indent << "LampPosition: " << this->LampPosition[0] << " " << this->LampPosition[1] << " "
     << this->LampPosition[2] << "\n"
     << indent << "LampDirection: " << this->LampDirection[0] << " " << this->LampDirection[1]
     << " " << this->LampDirection[2] << "\n"
     << indent << "LampSize: " << this->LampSize << "\n";
}
