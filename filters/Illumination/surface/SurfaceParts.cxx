// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/surface/SurfaceParts.h"

#include "Illumination/pipeline/PieceNames.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace Illumination
{

SurfaceParts PartsOf(vtkDataObject* data)
{
  SurfaceParts parts;
  if (auto* single = vtkPolyData::SafeDownCast(data))
  {
    parts.surfaces.push_back({ single, "" });
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto it = vtk::TakeSmartPointer(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      if (auto* block = vtkPolyData::SafeDownCast(it->GetCurrentDataObject()))
      {
        const unsigned number = it->GetCurrentFlatIndex();
        parts.surfaces.push_back({ block, NameOfBlock(block, number), number });
      }
      else
      {
        ++parts.others;
      }
    }
  }
  return parts;
}

void AppendPoints(vtkPolyData* mesh, std::vector<glm::dvec3>& points)
{
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    glm::dvec3 point;
    mesh->GetPoint(p, &point.x);
    points.push_back(point);
  }
}

void AppendNormals(vtkPolyData* mesh, std::vector<glm::dvec3>& normals)
{
  vtkDataArray* array = mesh->GetPointData()->GetNormals();
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    glm::dvec3 normal(0.0);
    if (array)
    {
      array->GetTuple(p, &normal.x);
    }
    normals.push_back(normal);
  }
}

void AppendFacets(vtkPolyData* mesh, std::size_t firstPoint, std::vector<glm::uvec3>& facets)
{
  const auto first = static_cast<unsigned>(firstPoint);
  auto it = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    facets.emplace_back(first + static_cast<unsigned>(ids[0]),
      first + static_cast<unsigned>(ids[1]), first + static_cast<unsigned>(ids[2]));
  }
}

} // namespace Illumination
