// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/refinement/Subdivision.h"
#include "PhotonTransport/scene/ProcessEnd.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace PhotonTransport
{

/// A ray in the scene's coordinates.
struct Ray
{
  glm::vec3 origin;
  glm::vec3 direction; ///< Unit length.
};

constexpr std::uint32_t NoFacet = 0xffffffffu;
constexpr std::uint32_t NoPart = 0xffffffffu;
/// Stands for no part of a facet that has others in its place: rays start clear of these, and by
/// Hit::inPart.x more (Scene::SafeOrigin).
constexpr std::uint32_t NoPartButLifted = 0xfffffffeu;

/// The first facet along a ray.
struct Hit
{
  std::uint32_t facet = NoFacet;
  glm::vec3 barycentric{ 0.0f }; ///< Of the facet's three corners; in [0, 1], sum 1.
  /// Of the facet, where it is traced in parts: the place in it tells the point more finely.
  std::uint32_t part = NoPart;
  glm::vec3 inPart{ 0.0f }; ///< Barycentric coordinates of the part.

  explicit operator bool() const { return this->facet != NoFacet; }
};

/// The bounding volume hierarchy. The only class that knows Embree (3.13 or 4).
class EmbreeScene
{
public:
  /// @param points In [-1, 1]. @param facets Indices into points; none of zero area.
  /// @param parts Of the facets that are traced in parts; hits on them are hits on their facet.
  /// Throws std::runtime_error with Embree's own words if the build fails.
  EmbreeScene(std::vector<glm::vec3> points, std::vector<glm::uvec3> facets,
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

  /// Calls f(facet) for all facets whose bounds come within a distance of a point, in any order,
  /// more than once for a facet that is traced in parts.
  void ForEachNear(
    const glm::vec3& point, float distance, const std::function<void(std::uint32_t)>& f) const;

  const FacetPart& Part(std::uint32_t part) const;

private:
  struct Implementation;
  ProcessPtr<Implementation> Impl;
};

} // namespace PhotonTransport
