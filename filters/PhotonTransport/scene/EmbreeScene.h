// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/refinement/FacetParts.h"
#include "PhotonTransport/scene/Ray.h"
#include "PhotonTransport/scene/SceneRecords.h"
#include "PhotonTransport/threads/ProcessEnd.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace PhotonTransport
{

/// The bounding volume hierarchy. The only class that knows Embree (3.13 or 4).
class EmbreeScene
{
public:
  /// @param vertices Positions in [-1, 1]. @param facets None of zero area. Embree reads both where
  /// they are: they must outlive the hierarchy, unmoved.
  /// @param parts Of the facets that are traced in parts; hits on them are hits on their facet.
  /// Throws std::runtime_error with Embree's own words if the build fails.
  EmbreeScene(const LargeArray<Vertex>& vertices, const LargeArray<Facet>& facets,
    std::vector<FacetPart> parts = {});
  ~EmbreeScene();
  EmbreeScene(EmbreeScene&&) noexcept;
  EmbreeScene& operator=(EmbreeScene&&) noexcept;

  /// The first hit of each ray. Safe to call from any number of threads.
  ///
  /// The error of a hit grows with the length of the ray. A ray that comes from far to a place near
  /// the origin, where coordinates are fine, is therefore traced again from shortly before its hit:
  /// from far it could not tell which of two facets close together it meets first.
  ///
  /// Rays go to Embree eight at a time, which is up to a third faster than one by one even where
  /// they have nothing in common. A ray that meets an edge may get either of its facets, depending
  /// on its neighbours in the eight: callers that promise the same bits pass the same groups.
  void Intersect(const Ray* rays, Hit* hits, std::size_t count) const;

  /// For each segment whether it meets anything, 1 or 0. The error of a place on it grows with its
  /// length, so callers let segments start where coordinates are finer; see Scene::SegmentBetween.
  /// @param neighbours Whether segments that follow each other are short and close together, which
  /// takes less time then, and more where they are not.
  void FindOccluded(const Segment* segments, std::uint8_t* occluded, std::size_t count,
    bool neighbours = false) const;

  /// Calls f(facet) for all facets whose bounds come within a distance of a point, in any order,
  /// more than once for a facet that is traced in parts.
  void ForEachNear(
    const glm::vec3& point, float distance, const std::function<void(std::uint32_t)>& f) const;

  const FacetPart& Part(std::uint32_t part) const;
  std::size_t NumberOfParts() const;

private:
  struct Implementation;
  ProcessPtr<Implementation> Impl;
};

} // namespace PhotonTransport
