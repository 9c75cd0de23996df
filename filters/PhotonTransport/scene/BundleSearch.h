// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/FacetBundles.h"
#include "PhotonTransport/scene/FacetOverlap.h"
#include "PhotonTransport/scene/Outline.h"
#include "PhotonTransport/scene/PlaneTriangle.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace PhotonTransport
{

/// Whether a group is two facets that do not overlap. Most groups are pairs of neighbours: this
/// tells that there is nothing to look for in them without making a bundle.
bool IsPairApart(const FacetPlaces& places, const PlaneMember* first, const PlaneMember* last);

/// Looks for overlaps within one bundle.
class BundleSearch
{
public:
  BundleSearch(const FacetPlaces& places, const Bundle& bundle);

  /// Whether it is worth while to look for them.
  bool MayHaveAny(Outline& outline) const;

  /// Calls f for each overlap.
  void ForEach(const std::function<void(const FacetOverlap&)>& f) const;

private:
  bool AnyMeetAt(const std::vector<std::uint32_t>& some) const;
  void Report(
    std::uint32_t i, std::uint32_t j, const std::function<void(const FacetOverlap&)>& f) const;
  bool AreNear(const PlaneTriangle& one, const PlaneTriangle& other, const CommonPart& common,
    FacetOverlap& overlap) const;
  glm::dvec3 ExactNormal(std::uint32_t facet) const;

  const FacetPlaces& Places;
  int Axis;
  std::vector<PlaneTriangle> Triangles;
};

} // namespace PhotonTransport
