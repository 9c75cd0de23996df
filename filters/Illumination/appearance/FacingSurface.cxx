// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/appearance/FacingSurface.h"

#include "Illumination/pipeline/FieldArrays.h"
#include "Illumination/surface/InputChecks.h"

#include "PhotonTransport/scene/FacetSide.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <map>
#include <utility>

namespace Illumination
{
namespace
{

/// Gives each point of a block's cells one look.
class PointLooks
{
public:
  explicit PointLooks(vtkIdType points)
    : LookOfPoint(static_cast<std::size_t>(points), NoLook)
  {
    for (vtkIdType p = 0; p < points; ++p)
    {
      this->Original.push_back(p);
    }
  }

  /// The point itself, or its copy for the look.
  vtkIdType PointFor(vtkIdType point, std::uint32_t look)
  {
    std::uint32_t& own = this->LookOfPoint[static_cast<std::size_t>(point)];
    if (own == NoLook || own == look)
    {
      own = look;
      return point;
    }
    const auto fresh = static_cast<vtkIdType>(this->Original.size());
    const auto [place, isNew] = this->Copies.emplace(std::make_pair(point, look), fresh);
    if (isNew)
    {
      this->Original.push_back(point);
      this->LookOfPoint.push_back(look);
    }
    return place->second;
  }

  std::vector<vtkIdType> Original;
  std::vector<std::uint32_t> LookOfPoint;

private:
  std::map<std::pair<vtkIdType, std::uint32_t>, vtkIdType> Copies;
};

/// Which way cells look, by point normals.
class Facing
{
public:
  Facing(vtkPolyData* data, vtkDataArray* normals)
    : Data(data)
    , Normals(normals)
  {
  }

  /// Whether the corners of a polygon run clockwise seen from where its normals point.
  bool IsTurned(vtkIdType size, const vtkIdType* ids) const
  {
    if (!this->Normals || size < 3)
    {
      return false;
    }
    const glm::dvec3 area = this->AreaVector(size, ids);
    const glm::dvec3 normal = this->SumOfNormals(size, ids);
    // Normals in the plane of the cell do not tell, as in Illumination Map.
    return glm::dot(area, normal) <
      -PhotonTransport::InPlane * glm::length(area) * glm::length(normal);
  }

  /// The same of a strip, by its first triangle with an area.
  bool IsStripTurned(vtkIdType size, const vtkIdType* ids) const
  {
    for (vtkIdType i = 0; i + 2 < size; ++i)
    {
      const vtkIdType corners[3] = { ids[i], ids[i + 1 + i % 2], ids[i + 2 - i % 2] };
      if (this->AreaVector(3, corners) != glm::dvec3(0.0))
      {
        return this->IsTurned(3, corners);
      }
    }
    return false;
  }

private:
  glm::dvec3 At(vtkIdType point) const
  {
    glm::dvec3 x;
    this->Data->GetPoint(point, &x.x);
    return x;
  }
  glm::dvec3 AreaVector(vtkIdType size, const vtkIdType* ids) const
  {
    const glm::dvec3 first = this->At(ids[0]);
    glm::dvec3 area(0.0);
    for (vtkIdType i = 1; i + 1 < size; ++i)
    {
      area += glm::cross(this->At(ids[i]) - first, this->At(ids[i + 1]) - first);
    }
    return area;
  }
  glm::dvec3 SumOfNormals(vtkIdType size, const vtkIdType* ids) const
  {
    glm::dvec3 sum(0.0);
    for (vtkIdType i = 0; i < size; ++i)
    {
      glm::dvec3 normal;
      this->Normals->GetTuple(ids[i], &normal.x);
      sum += normal;
    }
    return sum;
  }

  vtkPolyData* Data;
  vtkDataArray* Normals;
};

/// The cells with points for their looks, and turned where `turn`(size, ids) says so, which changes
/// the ids. @param look Of the first cell; moved on to that of the cell after the last.
template <typename Turn>
vtkSmartPointer<vtkCellArray> WithLooks(vtkCellArray* cells, PointLooks& points,
  std::vector<std::uint32_t>::const_iterator& look, const Turn& turn)
{
  auto result = vtkSmartPointer<vtkCellArray>::New();
  result->AllocateExact(cells->GetNumberOfCells(), cells->GetNumberOfConnectivityIds());
  std::vector<vtkIdType> ids;
  auto it = vtk::TakeSmartPointer(cells->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell(), ++look)
  {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    it->GetCurrentCell(size, corners);
    ids.assign(corners, corners + size);
    turn(ids);
    std::transform(ids.begin(), ids.end(), ids.begin(),
      [&](vtkIdType point) { return points.PointFor(point, *look); });
    result->InsertNextCell(static_cast<vtkIdType>(ids.size()), ids.data());
  }
  return result;
}

/// Adds the points that are copies, with their arrays.
void CopyPoints(vtkPolyData* input, const std::vector<vtkIdType>& original, vtkPolyData* output)
{
  vtkNew<vtkIdList> from;
  from->SetNumberOfIds(static_cast<vtkIdType>(original.size()));
  std::copy(original.begin(), original.end(), from->GetPointer(0));
  vtkNew<vtkPoints> points;
  points->SetDataType(input->GetPoints()->GetDataType());
  points->SetNumberOfPoints(from->GetNumberOfIds());
  input->GetPoints()->GetData()->GetTuples(from, points->GetData());
  output->SetPoints(points);
  vtkPointData* arrays = output->GetPointData();
  arrays->Initialize();
  arrays->CopyAllOn();
  arrays->CopyGlobalIdsOff(); // they would not be unique
  arrays->CopyAllocate(input->GetPointData(), from->GetNumberOfIds());
  arrays->CopyData(input->GetPointData(), from);
  if (!arrays->HasArray("OriginalPointIds"))
  {
    AddNumbers<vtkIdTypeArray>(arrays, "OriginalPointIds", original);
  }
}

} // namespace

FacingSurface FaceSurface(const NamedSurface& block, const CellLooks& looks)
{
  const Facing facing(block.data, CheckedNormals(block.data, block.name));
  PointLooks points(block.data->GetNumberOfPoints());
  auto look = looks.lookOfCell.begin();
  FacingSurface result{ vtkSmartPointer<vtkPolyData>::New(), {}, {} };
  result.data->ShallowCopy(block.data);
  result.data->SetPolys(WithLooks(block.data->GetPolys(), points, look,
    [&](std::vector<vtkIdType>& ids)
    {
      if (facing.IsTurned(static_cast<vtkIdType>(ids.size()), ids.data()))
      {
        std::reverse(ids.begin(), ids.end());
      }
    }));
  result.data->SetStrips(WithLooks(block.data->GetStrips(), points, look,
    [&](std::vector<vtkIdType>& ids)
    {
      if (facing.IsStripTurned(static_cast<vtkIdType>(ids.size()), ids.data()))
      {
        ids.insert(ids.begin(), ids.front()); // a strip winds the other way from its second point
      }
    }));
  result.original = std::move(points.Original);
  result.lookOfPoint = std::move(points.LookOfPoint);
  if (static_cast<vtkIdType>(result.original.size()) > block.data->GetNumberOfPoints())
  {
    CopyPoints(block.data, result.original, result.data);
  }
  return result;
}

} // namespace Illumination
