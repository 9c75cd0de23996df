// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/map/MapBlocks.h"

#include "Illumination/pipeline/InputError.h"
#include "Illumination/pipeline/PieceNames.h"
#include "Illumination/surface/GhostPoints.h"
#include "Illumination/surface/InputChecks.h"
#include "Illumination/surface/SurfaceTriangles.h"
#include "Illumination/surface/TriangleOrder.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace Illumination
{
namespace
{

vtkDataArray* CheckedArray(const NamedSurface& block, const std::string& name, int components)
{
  const std::string where = "point array '" + name + "'" + block.name;
  vtkAbstractArray* found = block.data->GetPointData()->GetAbstractArray(name.c_str());
  if (!found)
  {
    throw InputError("there is no " + where);
  }
  return CheckedNumbers(found, where, { components }, block.data->GetNumberOfPoints(), "points");
}

} // namespace

MapBlocks::MapBlocks(vtkDataObject* data)
{
  for (const NamedSurface& part : PartsOf(data).surfaces)
  {
    this->Append(part);
  }
  if (this->AllFacets.empty())
  {
    throw InputError("the input has no polygons or triangle strips with a map to smooth");
  }
  this->FindOwners();
}

void MapBlocks::Append(const NamedSurface& part)
{
  const SurfaceTriangles triangles = TrianglesOf(part.data, nullptr, part.name);
  if (HasSurface(part.data))
  {
    const vtkSmartPointer<vtkPolyData> ordered = OrderedByPlace(triangles.mesh, part.data);
    this->Parts.push_back({ part, this->NumberOfPoints });
    AppendFacets(ordered, this->Places.size(), this->AllFacets);
    AppendPoints(ordered, this->Places);
    for (const vtkIdType point : PointsOfTriangles(ordered))
    {
      this->PointOfVertex.push_back(this->NumberOfPoints + static_cast<std::size_t>(point));
    }
    this->NumberOfPoints += static_cast<std::size_t>(part.data->GetNumberOfPoints());
  }
}

void MapBlocks::FindOwners()
{
  const std::vector<GhostPoints> ghosts =
    FindGhostPoints({ this->Parts.begin(), this->Parts.end() });
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

std::string MapBlocks::NameOfVertex(std::size_t vertex) const
{
  const std::size_t point = this->PointOfVertex[vertex];
  const auto after = std::upper_bound(this->Parts.begin(), this->Parts.end(), point,
    [](std::size_t p, const Block& block) { return p < block.firstPoint; });
  const Block& block = *(after - 1);
  return NameOfPoint(block.data, static_cast<vtkIdType>(point - block.firstPoint), block.name);
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
  std::vector<double> values(this->NumberOfPoints);
  this->ForEachTuple(array, 1,
    [&](std::size_t point, vtkDataArray* tuples, vtkIdType tuple)
    { values[point] = tuples->GetComponent(tuple, 0); });
  return values;
}

std::vector<PhotonTransport::GroupValues> MapBlocks::Groups(const std::string& array) const
{
  std::vector<PhotonTransport::GroupValues> groups(this->NumberOfPoints);
  this->ForEachTuple(array, static_cast<int>(PhotonTransport::Groups),
    [&](std::size_t point, vtkDataArray* tuples, vtkIdType tuple)
    { tuples->GetTuple(tuple, groups[point].data()); });
  return groups;
}

} // namespace Illumination
