// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/NearOverlaps.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <tuple>

namespace PhotonTransport
{
namespace
{

constexpr double Joins = 16.0;

} // namespace

std::vector<FacetOverlap> NearOverlaps::TakeJoined(const std::vector<std::uint32_t>& inOnePlace)
{
  const auto key = [](const FacetOverlap& overlap)
  { return std::tuple(overlap.first, overlap.second, overlap.excess, overlap.area); };
  std::sort(this->Overlaps.begin(), this->Overlaps.end(),
    [&](const FacetOverlap& a, const FacetOverlap& b) { return key(a) < key(b); });
  this->JoinPositions(inOnePlace);
  std::for_each(
    inOnePlace.begin(), inOnePlace.end(), [&](std::uint32_t facet) { this->Mark(facet); });
  std::vector<FacetOverlap> joined;
  for (bool more = true; more;)
  {
    // What joins in a round lets others join in the next one.
    const auto rest = std::stable_partition(this->Overlaps.begin(), this->Overlaps.end(),
      [&](const FacetOverlap& overlap)
      { return overlap.excess > Joins || !this->AreMarked(overlap); });
    more = rest != this->Overlaps.end();
    std::for_each(rest, this->Overlaps.end(),
      [&](const FacetOverlap& overlap)
      {
        this->Mark(overlap.first);
        this->Mark(overlap.second);
      });
    joined.insert(joined.end(), rest, this->Overlaps.end());
    this->Overlaps.erase(rest, this->Overlaps.end());
  }
  return joined;
}

std::vector<FacetOverlap> NearOverlaps::LeftToChance() const
{
  constexpr unsigned Behind = 1, InFront = 2, Both = 3;
  std::vector<std::uint8_t> others(this->Facets.size(), 0); // where those near a facet lie
  const auto add = [&](std::uint32_t facet, unsigned sides)
  { others[facet] = static_cast<std::uint8_t>(others[facet] | sides); };
  for (const FacetOverlap& overlap : this->Overlaps)
  {
    const bool behind = overlap.low<0.0, inFront = overlap.high> 0.0;
    add(overlap.first, (behind ? Behind : 0u) | (inFront ? InFront : 0u));
    add(overlap.second, (behind ? InFront : 0u) | (inFront ? Behind : 0u));
  }
  std::vector<FacetOverlap> chance;
  std::copy_if(this->Overlaps.begin(), this->Overlaps.end(), std::back_inserter(chance),
    [&](const FacetOverlap& overlap)
    {
      return others[overlap.first] == Both || others[overlap.second] == Both ||
        this->AreMarked(overlap);
    });
  return chance;
}

/// Sheets of separate points are connected where these lie in the same place.
void NearOverlaps::JoinPositions(const std::vector<std::uint32_t>& inOnePlace)
{
  std::vector<std::uint32_t> points;
  const auto add = [&](std::uint32_t facet)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      points.push_back(this->Facets[facet].vertices[corner]);
    }
  };
  std::for_each(inOnePlace.begin(), inOnePlace.end(), add);
  for (const FacetOverlap& overlap : this->Overlaps)
  {
    add(overlap.first);
    add(overlap.second);
  }
  const auto key = [&](std::uint32_t p)
  {
    const glm::vec3& place = this->Positions[p];
    return std::tuple(place.x, place.y, place.z, p);
  };
  std::sort(points.begin(), points.end(),
    [&](std::uint32_t p, std::uint32_t q) { return key(p) < key(q); });
  this->First.resize(this->Positions.size());
  this->Marks.assign(this->Positions.size(), 0);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const bool known = i > 0 && this->Positions[points[i]] == this->Positions[points[i - 1]];
    this->First[points[i]] = known ? this->First[points[i - 1]] : points[i];
  }
}

void NearOverlaps::Mark(std::uint32_t facet)
{
  for (int corner = 0; corner < 3; ++corner)
  {
    this->Marks[this->First[this->Facets[facet].vertices[corner]]] = 1;
  }
}

bool NearOverlaps::IsMarked(std::uint32_t facet) const
{
  const glm::uvec3& corners = this->Facets[facet].vertices;
  return (this->Marks[this->First[corners.x]] | this->Marks[this->First[corners.y]] |
           this->Marks[this->First[corners.z]]) != 0;
}

} // namespace PhotonTransport
