// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/map/MapBlocks.h"

#include "Illumination/pipeline/InputError.h"
#include "Illumination/surface/GhostPoints.h"
#include "Illumination/surface/SurfaceTriangles.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>

namespace
{

vtkDataArray* CheckedArray(const MapBlocks::Block& block, const std::string& name, int components)
{
  vtkPointData* arrays = block.data->GetPointData();
  vtkAbstractArray* found = arrays->GetAbstractArray(name.c_str());
  const std::string where = "point array '" + name + "'" + block.name;
  if (!found)
  {
    throw InputError("there is no " + where);
  }
  auto* array = vtkDataArray::SafeDownCast(found);
  if (!array)
  {
    throw InputError(where + " is a " + found->GetClassName() + ", not numbers");
  }
  if (array->GetNumberOfComponents() != components)
  {
    throw InputError(where + " has " + std::to_string(array->GetNumberOfComponents()) +
      " components; " + std::to_string(components) + " are wanted");
  }
  if (array->GetNumberOfTuples() != block.data->GetNumberOfPoints())
  {
    throw InputError(where + " has " + std::to_string(array->GetNumberOfTuples()) + " values for " +
      std::to_string(block.data->GetNumberOfPoints()) + " points");
  }
  return array;
}

} // namespace

MapBlocks::MapBlocks(vtkDataObject* data)
{
  if (auto* single = vtkPolyData::SafeDownCast(data))
  {
    this->Append(single, "");
  }
  else if (auto* composite = vtkCompositeDataSet::SafeDownCast(data))
  {
    auto it = vtk::TakeSmartPointer(composite->NewIterator());
    for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
    {
      if (auto* block = vtkPolyData::SafeDownCast(it->GetCurrentDataObject()))
      {
        this->Append(block, " of block " + std::to_string(it->GetCurrentFlatIndex()));
      }
    }
  }
  if (this->AllFacets.empty())
  {
    throw InputError("the input has no polygons or triangle strips with a map to smooth");
  }
  this->FindOwners();
}

void MapBlocks::Append(vtkPolyData* data, const std::string& name)
{
  const SurfaceTriangles triangles = TrianglesOf(data, nullptr, name);
  if (!HasSurface(data))
  {
    return;
  }
  this->Parts.push_back({ data, name, this->AllPoints.size() });
  const auto offset = static_cast<unsigned>(this->AllPoints.size());
  for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
  {
    glm::dvec3 point;
    data->GetPoint(p, &point.x);
    this->AllPoints.push_back(point);
  }
  auto it = vtk::TakeSmartPointer(triangles.mesh->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    this->AllFacets.emplace_back(offset + static_cast<unsigned>(ids[0]),
      offset + static_cast<unsigned>(ids[1]), offset + static_cast<unsigned>(ids[2]));
  }
}

void MapBlocks::FindOwners()
{
  std::vector<std::pair<vtkPolyData*, std::string>> blocks;
  for (const Block& block : this->Parts)
  {
    blocks.emplace_back(block.data, block.name);
  }
  const std::vector<GhostPoints> ghosts = FindGhostPoints(blocks);
  for (std::size_t b = 0; b < ghosts.size(); ++b)
  {
    for (const GhostPoint& ghost : ghosts[b].owned)
    {
      this->OwnerOfGhost.emplace_back(
        this->Parts[b].firstPoint + static_cast<std::size_t>(ghost.point),
        this->Parts[ghost.ownerBlock].firstPoint + static_cast<std::size_t>(ghost.owner));
    }
  }
}

std::string MapBlocks::NameOfPoint(std::size_t point) const
{
  const auto after = std::upper_bound(this->Parts.begin(), this->Parts.end(), point,
    [](std::size_t p, const Block& block) { return p < block.firstPoint; });
  const Block& block = *(after - 1);
  return "point " + std::to_string(point - block.firstPoint) + block.name;
}

bool MapBlocks::Have(const std::string& array) const
{
  return std::all_of(this->Parts.begin(), this->Parts.end(),
    [&](const Block& block) { return block.data->GetPointData()->HasArray(array.c_str()) != 0; });
}

void MapBlocks::ForEachTuple(const std::string& array, int components,
  const std::function<void(std::size_t, vtkDataArray*, vtkIdType)>& f) const
{
  for (const Block& block : this->Parts)
  {
    vtkDataArray* checked = CheckedArray(block, array, components);
    for (vtkIdType p = 0; p < checked->GetNumberOfTuples(); ++p)
    {
      f(block.firstPoint + static_cast<std::size_t>(p), checked, p);
    }
  }
}

std::vector<double> MapBlocks::Values(const std::string& array) const
{
  std::vector<double> values(this->AllPoints.size());
  this->ForEachTuple(array, 1,
    [&](std::size_t point, vtkDataArray* tuples, vtkIdType tuple)
    { values[point] = tuples->GetComponent(tuple, 0); });
  return values;
}

std::vector<PhotonTransport::GroupValues> MapBlocks::Groups(const std::string& array) const
{
  std::vector<PhotonTransport::GroupValues> groups(this->AllPoints.size());
  this->ForEachTuple(array, static_cast<int>(PhotonTransport::Groups),
    [&](std::size_t point, vtkDataArray* tuples, vtkIdType tuple)
    { tuples->GetTuple(tuple, groups[point].data()); });
  return groups;
}
