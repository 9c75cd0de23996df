// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/refinement/OpenEdges.h"

#include "PhotonTransport/refinement/SortedEnds.h"
#include "PhotonTransport/threads/Threads.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{
namespace
{

/// Adds the edge and those along it, if it has a point between its ends.
void AddIfDivided(std::uint32_t edge, const glm::dvec3& from, const glm::dvec3& to, double gap,
  const SortedEnds& ends, std::vector<std::uint32_t>& found)
{
  const glm::dvec3 along = to - from;
  const double length = glm::length(along);
  if (!(length > 2.0 * gap))
  {
    return;
  }
  std::vector<std::uint32_t> onEdge; // an edge with both ends here is here twice
  bool divided = false;
  ends.ForEachWithin(glm::min(from, to) - gap, glm::max(from, to) + gap,
    [&](const End& end)
    {
      const glm::dvec3 beside = end.point - from;
      const double place = std::clamp(glm::dot(beside, along) / length, 0.0, length);
      if (end.edge != edge && glm::length(beside - (place / length) * along) <= gap)
      {
        divided = divided || (place > gap && place < length - gap);
        onEdge.push_back(end.edge);
      }
    });
  if (divided)
  {
    found.push_back(edge);
    std::sort(onEdge.begin(), onEdge.end());
    for (auto twice = std::adjacent_find(onEdge.begin(), onEdge.end()); twice != onEdge.end();
         twice = std::adjacent_find(twice + 2, onEdge.end()))
    {
      found.push_back(*twice);
    }
  }
}

} // namespace

std::vector<std::uint32_t> EdgesWithPointsOnThem(const TriangleMesh& mesh, const MeshEdges& edges)
{
  const std::vector<End> ends = edges.OpenEnds(mesh);
  const SortedEnds sorted(ends);
  PerThread<std::vector<std::uint32_t>> onThreads(MostThreadIndices());
  ForEach(ends.size() / 2,
    [&](std::size_t i)
    {
      const glm::dvec3 &from = ends[2 * i].point, &to = ends[2 * i + 1].point;
      AddIfDivided(
        ends[2 * i].edge, from, to, GapBetween(from, to, mesh.rounding), sorted, onThreads.Own());
    });
  std::vector<std::uint32_t> found;
  for (const std::vector<std::uint32_t>& some : onThreads)
  {
    found.insert(found.end(), some.begin(), some.end());
  }
  return found;
}

} // namespace PhotonTransport
