// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/adaptive/AdaptiveMesh.h"

#include "PhotonTransport/threads/Threads.h"

#include <glm/geometric.hpp>

#include <array>
#include <utility>

namespace PhotonTransport
{
namespace
{

/// A corner of a part: its point, and the given facet's barycentric coordinates of it.
struct Corner
{
  std::uint32_t point;
  glm::vec3 barycentric;
};

std::vector<FacetOrigin> WholeFacets(std::size_t number)
{
  std::vector<FacetOrigin> origins;
  origins.reserve(number);
  for (std::uint32_t f = 0; f < number; ++f)
  {
    origins.push_back({ f, WholeFacet });
  }
  return origins;
}

} // namespace

/// The next level, as far as it is made.
struct AdaptiveMesh::Dividing
{
  std::vector<std::uint32_t> middles; ///< [pair] The new point, where there is one.
  std::vector<glm::uvec3> facets;
  std::vector<FacetOrigin> origins;
  std::vector<std::uint32_t> parents;

  void Add(std::uint32_t facet, const Corner& a, const Corner& b, const Corner& c)
  {
    this->facets.emplace_back(a.point, b.point, c.point);
    this->origins.push_back({ facet, { a.barycentric, b.barycentric, c.barycentric } });
  }
};

AdaptiveMesh::AdaptiveMesh(const TriangleMesh& mesh)
  : AllPoints(mesh.points)
  , AllFacets(mesh.facets)
  , AllOrigins(WholeFacets(mesh.facets.size()))
  , Rounding(mesh.rounding)
  , AllEdges({ this->AllPoints, this->NoNormals, this->AllFacets, this->Rounding })
{
  this->MeasureEdges();
}

void AdaptiveMesh::MeasureEdges()
{
  this->Lengths.resize(this->AllEdges.Number());
  ForEach(this->Lengths.size(),
    [&](std::size_t edge)
    {
      const PointPair& pair = this->AllEdges.FirstPair(edge);
      this->Lengths[edge] = glm::distance(this->AllPoints[pair.from], this->AllPoints[pair.to]);
    });
}

/// Of several with the same length that of the edge with the least number.
int AdaptiveMesh::LongestSide(std::size_t facet) const
{
  int longest = 0;
  for (int side = 1; side < 3; ++side)
  {
    const std::uint32_t edge = this->AllEdges.EdgeOf(facet, static_cast<std::size_t>(side));
    const std::uint32_t other = this->AllEdges.EdgeOf(facet, static_cast<std::size_t>(longest));
    const double more = this->Lengths[edge] - this->Lengths[other];
    if (more > 0.0 || (more == 0.0 && edge < other))
    {
      longest = side;
    }
  }
  return longest;
}

void AdaptiveMesh::Close(Marks& halved) const
{
  std::vector<std::uint32_t> front;
  for (std::uint32_t edge = 0; edge < halved.size(); ++edge)
  {
    if (halved[edge] != 0)
    {
      front.push_back(edge);
    }
  }
  while (!front.empty())
  {
    const std::uint32_t edge = front.back();
    front.pop_back();
    this->AllEdges.ForEachSide(edge,
      [&](const FacetEdge& at)
      {
        const auto side = static_cast<std::size_t>(this->LongestSide(at.facet));
        const std::uint32_t longest = this->AllEdges.EdgeOf(at.facet, side);
        if (halved[longest] == 0)
        {
          halved[longest] = 1;
          front.push_back(longest);
        }
      });
  }
}

std::uint64_t AdaptiveMesh::FacetsAfter(const Marks& halved) const
{
  std::uint64_t facets = this->AllFacets.size();
  for (std::uint32_t edge = 0; edge < halved.size(); ++edge)
  {
    // Each halved edge of a facet adds one.
    facets += halved[edge] != 0 ? this->AllEdges.NumberOfFacets(edge) : 0;
  }
  return facets;
}

AdaptiveMesh::Halved AdaptiveMesh::Halve(const Marks& halved)
{
  Dividing dividing;
  Halved result;
  dividing.middles.resize(this->AllEdges.Pairs().size());
  for (std::size_t i = 0; i < dividing.middles.size(); ++i)
  {
    const PointPair& pair = this->AllEdges.Pairs()[i];
    if (halved[pair.edge] != 0)
    {
      dividing.middles[i] = static_cast<std::uint32_t>(this->AllPoints.size());
      this->AllPoints.push_back(0.5 * (this->AllPoints[pair.from] + this->AllPoints[pair.to]));
      result.pairs.push_back(pair);
    }
  }
  const std::uint64_t facets = this->FacetsAfter(halved);
  dividing.facets.reserve(facets);
  dividing.origins.reserve(facets);
  for (std::size_t f = 0; f < this->AllFacets.size(); ++f)
  {
    this->AddParts(f, halved, dividing);
    dividing.parents.resize(dividing.facets.size(), static_cast<std::uint32_t>(f));
  }
  result.parents = std::move(dividing.parents);
  this->AllFacets = std::move(dividing.facets);
  this->AllOrigins = std::move(dividing.origins);
  this->AllEdges = MeshEdges({ this->AllPoints, this->NoNormals, this->AllFacets, this->Rounding });
  this->MeasureEdges();
  return result;
}

/// The longest side is halved first, and then the others of its halves, unless all three are: then
/// the four parts are like the facet.
void AdaptiveMesh::AddParts(std::size_t facet, const Marks& halved, Dividing& dividing) const
{
  const FacetOrigin& origin = this->AllOrigins[facet];
  const int longest = this->LongestSide(facet);
  const auto side = [&](int turn) { return static_cast<std::size_t>((longest + turn) % 3); };
  const auto corner = [&](int turn) {
    return Corner{ this->AllFacets[facet][(longest + turn) % 3], origin.corners[side(turn)] };
  };
  const auto isHalved = [&](int turn)
  { return halved[this->AllEdges.EdgeOf(facet, side(turn))] != 0; };
  const auto middle = [&](int turn)
  {
    return Corner{ dividing.middles[this->AllEdges.PairOf(facet, side(turn))],
      0.5f * (corner(turn + 1).barycentric + corner(turn + 2).barycentric) };
  };
  const Corner a = corner(0), b = corner(1), c = corner(2);
  const auto add = [&](const Corner& p, const Corner& q, const Corner& r)
  { dividing.Add(origin.facet, p, q, r); };
  if (!isHalved(0))
  {
    add(a, b, c);
    return;
  }
  const Corner bc = middle(0);
  const bool ca = isHalved(1), ab = isHalved(2);
  if (ab && ca)
  {
    add(a, middle(2), middle(1));
    add(middle(2), b, bc);
    add(middle(1), bc, c);
    add(middle(2), bc, middle(1));
    return;
  }
  if (ab)
  {
    add(a, middle(2), bc);
    add(middle(2), b, bc);
  }
  else
  {
    add(a, b, bc);
  }
  if (ca)
  {
    add(a, bc, middle(1));
    add(middle(1), bc, c);
  }
  else
  {
    add(a, bc, c);
  }
}

} // namespace PhotonTransport
