// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/SharedPlanes.h"

#include <glm/geometric.hpp>

#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{
namespace
{

/// Planes are told apart by the point nearest to the origin, which does not depend on the side they
/// face, in cells of this size. Where the data are rounded too much for that, cells are larger.
constexpr float MostCellsPerUnit = 1024.0f;
constexpr float LeastCellsPerUnit = 64.0f;

/// Keeps coordinates that are common in drawings away from the borders of cells.
constexpr float Shift = 0.3f;

/// A plane near the border of a cell is in the neighbour too; more than half a cell is not needed.
constexpr float MostUncertain(float cellsPerUnit)
{
  return 0.5f / cellsPerUnit;
}

/// As many cells as possible in which most planes can still be told apart.
float ChooseCellsPerUnit(const std::vector<FacetPlane>& planes)
{
  constexpr float Coarse = 0x1p-21f; // eight times the rounding of the scene's own coordinates
  constexpr std::ptrdiff_t Few = 16; // one facet in so many may be as narrow as a needle
  float cells = MostCellsPerUnit;
  const auto isTooUncertain = [&](const FacetPlane& plane)
  { return plane.rounding > Coarse && plane.uncertainty > MostUncertain(cells); };
  while (cells > LeastCellsPerUnit &&
    Few * std::count_if(planes.begin(), planes.end(), isTooUncertain) >
      static_cast<std::ptrdiff_t>(planes.size()))
  {
    cells /= 2.0f;
  }
  return cells;
}

/// Calls f(cell) for the cells in which a plane may lie.
template <typename F>
void ForEachCell(const FacetPlane& plane, float cellsPerUnit, const F& f)
{
  const glm::vec3 nearest = glm::dot(plane.point, plane.normal) * plane.normal;
  const float reach = std::min(plane.uncertainty, MostUncertain(cellsPerUnit));
  std::uint64_t first[3], last[3];
  for (int i = 0; i < 3; ++i)
  {
    const float low = (nearest[i] + 2.0f - reach) * cellsPerUnit + Shift; // within [0, 2^13)
    first[i] = static_cast<std::uint64_t>(low);
    last[i] = static_cast<std::uint64_t>(low + 2.0f * reach * cellsPerUnit);
  }
  for (std::uint64_t x = first[0]; x <= last[0]; ++x)
  {
    for (std::uint64_t y = first[1]; y <= last[1]; ++y)
    {
      for (std::uint64_t z = first[2]; z <= last[2]; ++z)
      {
        f((x << 40) | (y << 20) | z);
      }
    }
  }
}

/// Most cells hold one plane: counting them in a small table is much faster than sorting them.
class CellCounts
{
public:
  explicit CellCounts(std::size_t planes)
  {
    while ((std::size_t{ 1 } << this->Bits) < 4 * planes)
    {
      ++this->Bits;
    }
    this->Counts.resize(std::size_t{ 1 } << this->Bits, 0);
  }
  void Add(std::uint64_t cell)
  {
    std::uint8_t& count = this->Counts[this->PlaceOf(cell)];
    count = static_cast<std::uint8_t>(std::min(count + 1, 2));
  }
  bool HasCompany(std::uint64_t cell) const { return this->Counts[this->PlaceOf(cell)] > 1; }

private:
  std::size_t PlaceOf(std::uint64_t cell) const
  {
    return static_cast<std::size_t>((cell * 0x9e3779b97f4a7c15u) >> (64 - this->Bits));
  }
  unsigned Bits = 1;
  std::vector<std::uint8_t> Counts;
};

} // namespace

FacetPlane PlaneOf(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
  const glm::vec3& normal, const DataRounding& rounding)
{
  // A corner is rounded by 2^-25 in each coordinate, a facet of least height h leans by no more
  // than 2^-23 / h from that, and the nearest point moves by twice that times its distance. The
  // distance by which the data's rounding moves corners out of the plane is added.
  const glm::vec3 u = b - a, v = c - a, w = c - b;
  const float longest = std::max({ glm::dot(u, u), glm::dot(v, v), glm::dot(w, w) });
  const float twiceArea = glm::length(glm::cross(u, v));
  const auto off = [&](const glm::vec3& p)
  { return static_cast<float>(rounding.Along(glm::dvec3(normal), glm::dvec3(p))); };
  const float most = rounding.relative > 0.0 ? std::max({ off(a), off(b), off(c) }) : 0.0f;
  // A facet without an area in single precision may lean any way. The nearest point of its plane is
  // then still no farther from the origin than its corner, so 2 is enough. It is also what std::min
  // makes of 0 / 0, which is no number.
  const float lean = std::min(2.0f, (0x1p-22f + 4.0f * most) * std::sqrt(longest) / twiceArea);
  return { a, normal, 2.0f * SheetGap + 2.0f * most + glm::length(a) * lean, most };
}

std::vector<PlaneMember> SharedPlanes(const std::vector<FacetPlane>& planes)
{
  const float cellsPerUnit = ChooseCellsPerUnit(planes);
  CellCounts counts(planes.size());
  for (const FacetPlane& plane : planes)
  {
    ForEachCell(plane, cellsPerUnit, [&](std::uint64_t cell) { counts.Add(cell); });
  }
  std::vector<PlaneMember> members;
  for (std::uint32_t f = 0; f < planes.size(); ++f)
  {
    ForEachCell(planes[f], cellsPerUnit,
      [&](std::uint64_t cell)
      {
        if (counts.HasCompany(cell))
        {
          members.push_back({ cell, f });
        }
      });
  }
  // No two are equal, so there is one order. Only integers are compared, which the floating-point
  // settings of threads do not concern.
  tbb::parallel_sort(members.begin(), members.end());
  std::vector<PlaneMember> groups;
  ForEachGroup(members,
    [&](const PlaneMember* first, const PlaneMember* last)
    {
      if (last - first > 1)
      {
        groups.insert(groups.end(), first, last);
      }
    });
  return groups;
}

} // namespace PhotonTransport
