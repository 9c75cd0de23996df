// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/SharedPlanes.h"

#include "PhotonTransport/threads/Threads.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <oneapi/tbb/parallel_sort.h>

#include <algorithm>
#include <atomic>
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

/// The cells in which a plane may lie: first and last along each axis.
struct CellRange
{
  CellRange(const FacetPlane& plane, float cellsPerUnit)
  {
    const glm::vec3 nearest = glm::dot(plane.point, plane.normal) * plane.normal;
    const float reach = std::min(plane.uncertainty, MostUncertain(cellsPerUnit));
    for (int i = 0; i < 3; ++i)
    {
      const float low = (nearest[i] + 2.0f - reach) * cellsPerUnit + Shift; // within [0, 2^13)
      this->first[i] = static_cast<std::uint64_t>(low);
      this->last[i] = static_cast<std::uint64_t>(low + 2.0f * reach * cellsPerUnit);
    }
  }
  std::uint64_t first[3], last[3];
};

/// Calls f(cell) for the cells in which a plane may lie.
template <typename F>
void ForEachCell(const FacetPlane& plane, float cellsPerUnit, const F& f)
{
  const CellRange cells(plane, cellsPerUnit);
  for (std::uint64_t x = cells.first[0]; x <= cells.last[0]; ++x)
  {
    for (std::uint64_t y = cells.first[1]; y <= cells.last[1]; ++y)
    {
      for (std::uint64_t z = cells.first[2]; z <= cells.last[2]; ++z)
      {
        f((x << 40) | (y << 20) | z);
      }
    }
  }
}

/// Which cells hold more than one plane, which most do not: marks in a small table are much faster
/// than sorting all cells. Cells that share a mark count as one.
class CellMarks
{
public:
  explicit CellMarks(std::size_t planes)
  {
    while ((std::size_t{ 1 } << this->Bits) < 4 * planes)
    {
      ++this->Bits;
    }
    this->Marks = std::vector<std::atomic<std::uint8_t>>(std::size_t{ 1 } << this->Bits);
  }
  /// May be called on many threads: what is marked in the end does not depend on their order.
  void Add(std::uint64_t cell)
  {
    std::atomic<std::uint8_t>& mark = this->Marks[this->PlaceOf(cell)];
    if (mark.load(std::memory_order_relaxed) < Several &&
      mark.fetch_or(One, std::memory_order_relaxed) != 0)
    {
      mark.fetch_or(Several, std::memory_order_relaxed);
    }
  }
  bool HasCompany(std::uint64_t cell) const
  {
    return this->Marks[this->PlaceOf(cell)].load(std::memory_order_relaxed) >= Several;
  }

private:
  static constexpr std::uint8_t One = 1, Several = 2;

  std::size_t PlaceOf(std::uint64_t cell) const
  {
    return static_cast<std::size_t>((cell * 0x9e3779b97f4a7c15u) >> (64 - this->Bits));
  }
  unsigned Bits = 1;
  std::vector<std::atomic<std::uint8_t>> Marks;
};

/// The planes in the cells that hold more than one of those that are marked.
std::vector<PlaneMember> MembersWithCompany(const std::vector<FacetPlane>& planes,
  const std::vector<std::uint8_t>& marked, float cellsPerUnit)
{
  CellMarks marks(static_cast<std::size_t>(
    std::count_if(marked.begin(), marked.end(), [](std::uint8_t mark) { return mark != 0; })));
  ForEach(planes.size(),
    [&](std::size_t f)
    {
      if (marked[f] != 0)
      {
        ForEachCell(planes[f], cellsPerUnit, [&](std::uint64_t cell) { marks.Add(cell); });
      }
    });
  constexpr std::size_t Chunk = 8192;
  std::vector<std::vector<PlaneMember>> chunks((planes.size() + Chunk - 1) / Chunk);
  const auto gather = [&](std::size_t c)
  {
    const std::size_t end = std::min((c + 1) * Chunk, planes.size());
    for (auto f = static_cast<std::uint32_t>(c * Chunk); f < end; ++f)
    {
      ForEachCell(planes[f], cellsPerUnit,
        [&](std::uint64_t cell)
        {
          if (marks.HasCompany(cell))
          {
            chunks[c].push_back({ cell, f });
          }
        });
    }
  };
  ForEach(chunks.size(), gather, 1);
  std::vector<PlaneMember> members;
  for (const std::vector<PlaneMember>& chunk : chunks)
  {
    members.insert(members.end(), chunk.begin(), chunk.end());
  }
  return members;
}

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

float PlaneCellsPerUnit(std::size_t facets, const std::function<FacetPlane(std::size_t)>& planeOf,
  const DataRounding& rounding)
{
  constexpr float Coarse = 0x1p-21f; // eight times the rounding of the scene's own coordinates
  constexpr std::size_t Few = 16;    // one facet in so many may be as narrow as a needle
  const glm::dvec3 farthest = glm::abs(rounding.origin) + 1.0;
  float cells = MostCellsPerUnit;
  if (rounding.relative * (farthest.x + farthest.y + farthest.z) <= double{ Coarse })
  {
    return cells; // as nearly always
  }
  std::vector<float> uncertainties(facets);
  ForEach(facets,
    [&](std::size_t f)
    {
      const FacetPlane plane = planeOf(f);
      uncertainties[f] = plane.rounding > Coarse ? plane.uncertainty : 0.0f;
    });
  const auto tooUncertain = [&]
  {
    return static_cast<std::size_t>(std::count_if(uncertainties.begin(), uncertainties.end(),
      [&](float uncertainty) { return uncertainty > MostUncertain(cells); }));
  };
  while (cells > LeastCellsPerUnit && Few * tooUncertain() > facets)
  {
    cells /= 2.0f;
  }
  return cells;
}

bool ShareACell(const FacetPlane& one, const FacetPlane& other, float cellsPerUnit)
{
  const CellRange a(one, cellsPerUnit), b(other, cellsPerUnit);
  bool share = true;
  for (int i = 0; i < 3; ++i)
  {
    share = share && a.first[i] <= b.last[i] && b.first[i] <= a.last[i];
  }
  return share;
}

std::vector<PlaneMember> SharedPlanes(const std::vector<FacetPlane>& planes,
  const std::vector<std::uint8_t>& marked, float cellsPerUnit)
{
  std::vector<PlaneMember> members = MembersWithCompany(planes, marked, cellsPerUnit);
  // No two are equal, so there is one order. Only integers are compared, which the floating-point
  // settings of threads do not concern.
  tbb::parallel_sort(members.begin(), members.end());
  auto end = members.begin();
  ForEachGroup(members,
    [&](const PlaneMember* first, const PlaneMember* last)
    { end = last - first > 1 ? std::copy(first, last, end) : end; });
  members.erase(end, members.end());
  return members;
}

} // namespace PhotonTransport
