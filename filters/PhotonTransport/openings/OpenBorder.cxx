// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/openings/OpenBorder.h"

#include "PhotonTransport/openings/BorderFacets.h"
#include "PhotonTransport/refinement/SortedEnds.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace PhotonTransport
{
namespace
{

constexpr std::uint32_t NoNode = 0xffffffffu;

/// An edge that only one facet has.
struct OpenEdge
{
  glm::dvec3 from, to;
  std::uint32_t facet;
};

std::array<std::uint32_t, 3> SortedEdgesOf(const MeshEdges& edges, std::uint32_t facet)
{
  std::array<std::uint32_t, 3> sorted{ edges.EdgeOf(facet, 0), edges.EdgeOf(facet, 1),
    edges.EdgeOf(facet, 2) };
  std::sort(sorted.begin(), sorted.end());
  return sorted;
}

/// The facet of an edge that has one, or several with the same corners; otherwise NoFacet.
std::uint32_t OnlyFacetOf(const MeshEdges& edges, std::size_t edge)
{
  constexpr std::uint32_t None = 0xffffffffu;
  std::uint32_t only = None;
  bool alone = true;
  edges.ForEachSide(edge,
    [&](const FacetEdge& side)
    {
      alone =
        alone && (only == None || SortedEdgesOf(edges, only) == SortedEdgesOf(edges, side.facet));
      only = std::min(only, side.facet);
    });
  return alone ? only : None;
}

std::vector<OpenEdge> OpenEdgesOf(const TriangleMesh& mesh)
{
  const BorderFacets border = FacetsNearBorder(mesh);
  std::vector<glm::uvec3> facets;
  facets.reserve(border.facets.size());
  for (const std::uint32_t f : border.facets)
  {
    facets.push_back(mesh.facets[f]);
  }
  const MeshEdges edges({ mesh.points, mesh.normals, facets, mesh.rounding });
  std::vector<OpenEdge> open;
  for (std::size_t edge = 0; edge < edges.Number() && !facets.empty(); ++edge)
  {
    const std::uint32_t facet = OnlyFacetOf(edges, edge);
    const PointPair& pair = edges.FirstPair(edge);
    // Other edges may have facets that are not among these.
    if (facet < facets.size() && border.isNear[pair.from] != 0 && border.isNear[pair.to] != 0)
    {
      open.push_back({ mesh.points[pair.from], mesh.points[pair.to], border.facets[facet] });
    }
  }
  return open;
}

/// Makes nodes of the ends of edges.
class Nodes
{
public:
  Nodes(const std::vector<OpenEdge>& open, double rounding)
    : Rounding(rounding)
    , NodeOfEnd(2 * open.size(), NoNode)
    , Sorted(EndsOf(open))
  {
    for (std::uint32_t end = 0; end < this->NodeOfEnd.size(); ++end)
    {
      this->Join(end, end % 2 == 0 ? open[end / 2].from : open[end / 2].to);
    }
  }

  const std::vector<glm::dvec3>& Points() const { return this->NodePoints; }

  /// The nodes on an edge, in order, its ends among them.
  std::vector<std::uint32_t> Along(std::size_t edge, const glm::dvec3& from, const glm::dvec3& to)
  {
    const double gap = GapBetween(from, to, this->Rounding);
    const glm::dvec3 along = to - from;
    const double length = glm::length(along);
    std::vector<std::pair<double, std::uint32_t>> found;
    this->Sorted.ForEachWithin(glm::min(from, to) - gap, glm::max(from, to) + gap,
      [&](const End& end)
      {
        const glm::dvec3 beside = end.point - from;
        const double place = glm::dot(beside, along) / length;
        if (place > gap && place < length - gap &&
          glm::length(beside - (place / length) * along) <= gap)
        {
          found.emplace_back(place, this->NodeOfEnd[end.edge]);
        }
      });
    found.emplace_back(-length, this->NodeOfEnd[2 * edge]);
    found.emplace_back(2.0 * length, this->NodeOfEnd[2 * edge + 1]);
    std::sort(found.begin(), found.end());
    std::vector<std::uint32_t> nodes;
    for (const auto& [place, node] : found)
    {
      if (nodes.empty() || nodes.back() != node)
      {
        nodes.push_back(node);
      }
    }
    return nodes;
  }

private:
  /// Ends whose `edge` is the number of the end.
  static std::vector<End> EndsOf(const std::vector<OpenEdge>& open)
  {
    std::vector<End> ends;
    ends.reserve(2 * open.size());
    for (const OpenEdge& edge : open)
    {
      ends.push_back({ edge.from, static_cast<std::uint32_t>(ends.size()) });
      ends.push_back({ edge.to, static_cast<std::uint32_t>(ends.size()) });
    }
    return ends;
  }

  /// Makes a node of an end that has none, and of all ends in its place.
  void Join(std::uint32_t end, const glm::dvec3& point)
  {
    if (this->NodeOfEnd[end] != NoNode)
    {
      return;
    }
    const auto node = static_cast<std::uint32_t>(this->NodePoints.size());
    this->NodePoints.push_back(point);
    const double gap = GapBetween(point, point, this->Rounding);
    this->Sorted.ForEachWithin(point - gap, point + gap,
      [&](const End& near)
      {
        std::uint32_t& other = this->NodeOfEnd[near.edge];
        other = other == NoNode && glm::distance(near.point, point) <= gap ? node : other;
      });
  }

  double Rounding;
  std::vector<glm::dvec3> NodePoints;
  std::vector<std::uint32_t> NodeOfEnd;
  SortedEnds Sorted;
};

bool AreAlong(const BorderSegment& a, const BorderSegment& b)
{
  return a.from == b.from && a.to == b.to;
}

/// Leaves out what several facets have. Pieces then run from the lesser node to the greater.
void KeepSingle(std::vector<BorderSegment>& segments)
{
  for (BorderSegment& segment : segments)
  {
    if (segment.to < segment.from)
    {
      std::swap(segment.from, segment.to);
    }
  }
  std::sort(segments.begin(), segments.end(),
    [](const BorderSegment& a, const BorderSegment& b) {
      return std::array{ a.from, a.to, a.facet } < std::array{ b.from, b.to, b.facet };
    });
  std::vector<BorderSegment> single;
  for (std::size_t i = 0; i < segments.size();)
  {
    std::size_t end = i + 1;
    while (end < segments.size() && AreAlong(segments[i], segments[end]))
    {
      ++end;
    }
    if (end == i + 1)
    {
      single.push_back(segments[i]);
    }
    i = end;
  }
  segments = std::move(single);
}

} // namespace

OpenBorder FindOpenBorder(const TriangleMesh& mesh)
{
  const std::vector<OpenEdge> open = OpenEdgesOf(mesh);
  Nodes nodes(open, mesh.rounding);
  OpenBorder border;
  for (std::size_t edge = 0; edge < open.size(); ++edge)
  {
    const std::vector<std::uint32_t> along = nodes.Along(edge, open[edge].from, open[edge].to);
    for (std::size_t i = 1; i < along.size(); ++i)
    {
      border.segments.push_back({ along[i - 1], along[i], open[edge].facet });
    }
  }
  KeepSingle(border.segments);
  border.nodes = nodes.Points();
  return border;
}

} // namespace PhotonTransport
