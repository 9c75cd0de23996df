// SPDX-License-Identifier: BSD-3-Clause
#include "GhostPoints.h"

#include "GhostCells.h"
#include "InputChecks.h"

#include "PhotonTransport/scene/FacetSide.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <utility>

namespace
{

using Position = std::array<double, 3>;

/// What the cells and arrays of a block say of its points.
class Points
{
public:
  Points(vtkPolyData* data, const std::string& block)
    : Data(data)
    , Normals(CheckedNormals(data, block))
    , Flags(GhostPointFlags(data, block))
    , OfScene(static_cast<std::size_t>(data->GetNumberOfPoints()), false)
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

  /// To the front: the normal that is given, or that of the cells around by their winding.
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
  /// Those of the scene and copies.
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

  /// A polygon by its fan; a strip by its first triangle, the others being much the same.
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

/// NaN has no place in an order.
bool IsFinite(const Position& place)
{
  return std::isfinite(place[0]) && std::isfinite(place[1]) && std::isfinite(place[2]);
}

struct Candidate
{
  std::size_t block;
  vtkIdType point;
};

/// For the place of each ghost point the points there that may own it.
std::map<Position, std::vector<Candidate>> FindCandidates(const std::vector<Points>& blocks)
{
  std::map<Position, std::vector<Candidate>> places;
  const auto forEach = [&](const auto& f)
  {
    for (std::size_t b = 0; b < blocks.size(); ++b)
    {
      for (vtkIdType p = 0; p < blocks[b].Count(); ++p)
      {
        f(blocks[b], b, p);
      }
    }
  };
  forEach(
    [&](const Points& block, std::size_t, vtkIdType p)
    {
      const Position place = block.At(p);
      if (block.IsGhost(p) && IsFinite(place))
      {
        places[place];
      }
    });
  forEach(
    [&](const Points& block, std::size_t b, vtkIdType p)
    {
      const auto found =
        block.IsUsed(p) && !block.IsGhost(p) ? places.find(block.At(p)) : places.end();
      if (found != places.end())
      {
        found->second.push_back({ b, p });
      }
    });
  return places;
}

/// The candidate that faces most like the ghost; null if none does.
const Candidate* OwnerOf(
  std::vector<Points>& blocks, const Candidate& ghost, const std::vector<Candidate>& candidates)
{
  // A copy has its owner's normal. Where none are given, a copy may have fewer cells around it, and
  // those of a corner that has three walls face 55 degrees away from it.
  constexpr double Same = 0.999;
  constexpr double Alike = 0.5;
  const Candidate* owner = nullptr;
  double best = 0.0;
  const glm::dvec3 front = blocks[ghost.block].FrontOf(ghost.point);
  for (const Candidate& candidate : candidates)
  {
    const bool given = blocks[ghost.block].HaveNormals() && blocks[candidate.block].HaveNormals();
    const double cosine = glm::dot(front, blocks[candidate.block].FrontOf(candidate.point));
    if (cosine > (given ? Same : Alike) && cosine > best)
    {
      owner = &candidate;
      best = cosine;
    }
  }
  return owner;
}

} // namespace

std::vector<GhostPoints> FindGhostPoints(
  const std::vector<std::pair<vtkPolyData*, std::string>>& blocks)
{
  if (std::none_of(blocks.begin(), blocks.end(),
        [](const auto& block) { return HasGhosts(block.first, block.second); }))
  {
    return {};
  }
  std::vector<Points> points;
  points.reserve(blocks.size());
  for (const auto& [data, name] : blocks)
  {
    points.emplace_back(data, name);
  }
  const std::map<Position, std::vector<Candidate>> places = FindCandidates(points);
  std::vector<GhostPoints> found(blocks.size());
  for (std::size_t b = 0; b < points.size(); ++b)
  {
    for (vtkIdType p = 0; p < points[b].Count(); ++p)
    {
      if (!points[b].IsGhost(p))
      {
        continue;
      }
      const Position place = points[b].At(p);
      const auto there = IsFinite(place) ? places.find(place) : places.end();
      const Candidate* owner =
        there == places.end() ? nullptr : OwnerOf(points, { b, p }, there->second);
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
