// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/surface/GhostPoints.h"

#include "Illumination/surface/GhostCells.h"
#include "Illumination/surface/InputChecks.h"

#include "PhotonTransport/geometry/TriangleArea.h"
#include "PhotonTransport/scene/FacetSide.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStaticPointLocator.h"
#include "vtkUnsignedCharArray.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace Illumination
{
namespace
{

using Position = std::array<double, 3>;

/// What the cells and arrays of a block say of its points.
class BlockPoints
{
public:
  BlockPoints(vtkPolyData* data, const std::string& block)
    : Data(data)
    , Normals(CheckedNormals(data, block))
    , Flags(GhostPointFlags(data, block))
    , Ghosts(data, block)
    , OfScene(static_cast<std::size_t>(data->GetNumberOfPoints()), false)
    , OfCopies(this->OfScene)
  {
    this->ForEachCell(
      [&](vtkIdType cell, vtkIdType size, const vtkIdType* corners)
      {
        std::vector<bool>& used = this->Ghosts.IsCopy(cell) ? this->OfCopies : this->OfScene;
        for (vtkIdType i = 0; i < size; ++i)
        {
          used[static_cast<std::size_t>(corners[i])] = true;
        }
      });
  }

  vtkIdType Count() const { return this->Data->GetNumberOfPoints(); }
  bool HaveNormals() const { return this->Normals != nullptr; }

  bool IsUsed(vtkIdType point) const { return this->OfScene[static_cast<std::size_t>(point)]; }
  bool IsGhost(vtkIdType point) const
  {
    const bool ofCopies = this->OfCopies[static_cast<std::size_t>(point)];
    const bool marked =
      this->Flags && (this->Flags->GetValue(point) & vtkDataSetAttributes::DUPLICATEPOINT) != 0;
    return this->IsUsed(point) ? marked : ofCopies;
  }

  Position At(vtkIdType point) const
  {
    Position place{};
    this->Data->GetPoint(point, place.data());
    return place;
  }

  /// The unit vector to the front: the given normal, or without any the mean of the cells around,
  /// by their winding.
  glm::dvec3 FrontOf(vtkIdType point)
  {
    glm::dvec3 front;
    if (this->Normals)
    {
      this->Normals->GetTuple(point, &front.x);
      return PhotonTransport::UsableNormal(front);
    }
    if (this->Fronts.empty())
    {
      this->SumAreas();
    }
    return PhotonTransport::UsableNormal(this->Fronts[static_cast<std::size_t>(point)]);
  }

private:
  /// Calls f for the cells of the scene and for duplicates of other blocks' cells.
  template <typename Function>
  void ForEachCell(const Function& f) const
  {
    vtkIdType cell = this->Data->GetNumberOfVerts() + this->Data->GetNumberOfLines();
    for (vtkCellArray* cells : { this->Data->GetPolys(), this->Data->GetStrips() })
    {
      auto it = vtk::TakeSmartPointer(cells->NewIterator());
      for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell(), ++cell)
      {
        vtkIdType size = 0;
        const vtkIdType* corners = nullptr;
        it->GetCurrentCell(size, corners);
        if (size >= 3 && (!this->Ghosts.IsGhost(cell) || this->Ghosts.IsCopy(cell)))
        {
          f(cell, size, corners);
        }
      }
    }
  }

  /// Sums area vectors of cells: of a polygon all triangles of its fan, of a strip the first
  /// triangle, which faces much as the others do.
  void SumAreas()
  {
    this->Fronts.assign(static_cast<std::size_t>(this->Count()), glm::dvec3(0.0));
    const vtkIdType firstStrip = this->Data->GetNumberOfCells() - this->Data->GetNumberOfStrips();
    this->ForEachCell(
      [&](vtkIdType cell, vtkIdType size, const vtkIdType* corners)
      {
        const auto at = [&](vtkIdType i)
        {
          const Position p = this->At(corners[i]);
          return glm::dvec3(p[0], p[1], p[2]);
        };
        glm::dvec3 area(0.0);
        for (vtkIdType i = 1; i + 1 < (cell < firstStrip ? size : 3); ++i)
        {
          area += glm::cross(at(i) - at(0), at(i + 1) - at(0));
        }
        for (vtkIdType i = 0; i < size && std::isfinite(glm::length(area)); ++i)
        {
          this->Fronts[static_cast<std::size_t>(corners[i])] += area;
        }
      });
  }

  vtkPolyData* Data;
  vtkDataArray* Normals;
  vtkUnsignedCharArray* Flags;
  GhostCells Ghosts;
  std::vector<bool> OfScene;  ///< Used by a cell of the scene.
  std::vector<bool> OfCopies; ///< Used by a copy of another block's cell.
  std::vector<glm::dvec3> Fronts;
};

bool HasGhosts(vtkPolyData* data, const std::string& block)
{
  return GhostCells(data, block).Any() || GhostPointFlags(data, block);
}

/// The search needs finite places.
bool IsFinite(const Position& place)
{
  return std::isfinite(place[0]) && std::isfinite(place[1]) && std::isfinite(place[2]);
}

/// A point of one of the blocks.
struct Place
{
  std::size_t block;
  vtkIdType point;
};

/// Finds owners among the points of the scene that are no copies.
class Owners
{
public:
  explicit Owners(std::vector<BlockPoints>& blocks)
    : Blocks(blocks)
  {
    vtkNew<vtkPoints> candidates;
    candidates->SetDataTypeToDouble();
    double farthest = 0.0;
    for (std::size_t b = 0; b < blocks.size(); ++b)
    {
      for (vtkIdType p = 0; p < blocks[b].Count(); ++p)
      {
        if (blocks[b].IsUsed(p) && !blocks[b].IsGhost(p))
        {
          const Position x = blocks[b].At(p);
          candidates->InsertNextPoint(x.data());
          this->Places.push_back({ b, p });
          farthest = std::max({ farthest, std::fabs(x[0]), std::fabs(x[1]), std::fabs(x[2]) });
        }
      }
    }
    this->Radius = PhotonTransport::SingleRounding * farthest;
    vtkNew<vtkPolyData> cloud;
    cloud->SetPoints(candidates);
    this->Locator->SetDataSet(cloud);
    this->Locator->BuildLocator();
  }

  /// The point in the ghost's place that faces most like it; null if none does.
  const Place* Of(const Place& ghost)
  {
    // A copy has its owner's normal. Where none are given, a copy may have fewer cells around it,
    // and those of a corner that has three walls face 55 degrees away from it.
    constexpr double Same = 0.999;
    constexpr double Alike = 0.5;
    BlockPoints& block = this->Blocks[ghost.block];
    const Position place = block.At(ghost.point);
    if (this->Places.empty() || !IsFinite(place))
    {
      return nullptr;
    }
    this->Locator->FindPointsWithinRadius(this->Radius, place.data(), this->Near);
    this->Near->Sort(); // among equals the first, whatever the order of the search
    const Place* owner = nullptr;
    double best = 0.0;
    for (vtkIdType i = 0; i < this->Near->GetNumberOfIds(); ++i)
    {
      const Place& there = this->Places[static_cast<std::size_t>(this->Near->GetId(i))];
      BlockPoints& other = this->Blocks[there.block];
      const bool given = block.HaveNormals() && other.HaveNormals();
      const double cosine = glm::dot(block.FrontOf(ghost.point), other.FrontOf(there.point));
      if (cosine > (given ? Same : Alike) && cosine > best)
      {
        owner = &there;
        best = cosine;
      }
    }
    return owner;
  }

private:
  std::vector<BlockPoints>& Blocks;
  std::vector<Place> Places; ///< Of the locator's points.
  double Radius = 0.0;
  vtkNew<vtkStaticPointLocator> Locator;
  vtkNew<vtkIdList> Near;
};

} // namespace

std::vector<GhostPoints> FindGhostPoints(const std::vector<NamedSurface>& blocks)
{
  if (std::none_of(blocks.begin(), blocks.end(),
        [](const NamedSurface& block) { return HasGhosts(block.data, block.name); }))
  {
    return {};
  }
  std::vector<BlockPoints> points;
  points.reserve(blocks.size());
  for (const NamedSurface& block : blocks)
  {
    points.emplace_back(block.data, block.name);
  }
  Owners owners(points);
  std::vector<GhostPoints> found(blocks.size());
  for (std::size_t b = 0; b < points.size(); ++b)
  {
    for (vtkIdType p = 0; p < points[b].Count(); ++p)
    {
      if (!points[b].IsGhost(p))
      {
        continue;
      }
      const Place* owner = owners.Of({ b, p });
      if (owner)
      {
        found[b].owned.push_back({ p, owner->block, owner->point });
      }
      else if (!points[b].IsUsed(p)) // otherwise it has light of its own
      {
        found[b].firstOwnerless = found[b].ownerless++ == 0 ? p : found[b].firstOwnerless;
      }
    }
  }
  return found;
}

} // namespace Illumination
