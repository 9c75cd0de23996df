// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/FacetOverlap.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <utility>
#include <vector>

namespace PhotonTransport
{

/// Overlaps of facets that are farther apart than rounding explains (FacetOverlap::excess above 1).
///
/// What rounding explains differs from place to place. A sheet may lie in the plane of another one
/// in some places and a little off it in others. It is then in one place with it as a whole, since
/// otherwise one facet would get the light and its neighbour would not. Therefore overlaps up to an
/// excess of 16 join the overlaps to which a corner of each of the two facets connects them.
class NearOverlaps
{
public:
  /// @param positions, facets Must outlive this.
  NearOverlaps(const LargeArray<glm::vec3>& positions, const LargeArray<Facet>& facets)
    : Positions(positions)
    , Facets(facets)
  {
  }

  void Add(const FacetOverlap& overlap) { this->Overlaps.push_back(overlap); }
  bool Empty() const { return this->Overlaps.empty(); }

  /// Takes out the overlaps that belong to sheets in one place.
  /// @param inOnePlace Indices of the facets that overlap others in one plane.
  std::vector<FacetOverlap> TakeJoined(const std::vector<std::uint32_t>& inOnePlace);

  /// The other overlaps where it is left to chance which facet gets the light: they are connected
  /// with sheets in one place, or one of the facets lies behind another one and in front of another
  /// one or the same. To be called after TakeJoined.
  std::vector<FacetOverlap> LeftToChance() const;

private:
  void JoinPositions(const std::vector<std::uint32_t>& inOnePlace);
  void Mark(std::uint32_t facet);
  bool IsMarked(std::uint32_t facet) const;
  bool AreMarked(const FacetOverlap& overlap) const
  {
    return this->IsMarked(overlap.first) && this->IsMarked(overlap.second);
  }

  const LargeArray<glm::vec3>& Positions;
  const LargeArray<Facet>& Facets;
  std::vector<FacetOverlap> Overlaps;
  std::vector<std::uint32_t> First; ///< By point: the first point of those in its place.
  std::vector<std::uint8_t> Marks;  ///< By point: it belongs to a sheet in one place with others.
};

} // namespace PhotonTransport
