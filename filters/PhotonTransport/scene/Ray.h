// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <cstdint>

namespace PhotonTransport
{

/// A ray in the scene's coordinates.
struct Ray
{
  glm::vec3 origin;
  glm::vec3 direction; ///< Unit length.
};

/// A part of a ray, from its origin on.
struct Segment
{
  Ray ray;
  float length; ///< May be infinite.
};

constexpr std::uint32_t NoFacet = 0xffffffffu;
constexpr std::uint32_t NoPart = 0xffffffffu;
/// Stands for no part either, on a facet that shares its place with others: rays start clear of all
/// of these facets, and farther by Hit::inPart.x (Scene::SafeOrigin).
constexpr std::uint32_t NoPartButLifted = 0xfffffffeu;

/// The first facet along a ray.
struct Hit
{
  std::uint32_t facet = NoFacet;
  glm::vec3 barycentric{ 0.0f }; ///< Of the facet's three corners; in [0, 1], sum 1.
  /// The part that was hit, if the facet is traced in parts: the place in the part gives the point
  /// more precisely.
  std::uint32_t part = NoPart;
  glm::vec3 inPart{ 0.0f }; ///< Barycentric coordinates of the part.

  explicit operator bool() const { return this->facet != NoFacet; }
};

} // namespace PhotonTransport
