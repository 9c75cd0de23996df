// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/memory/LargeArray.h"
#include "PhotonTransport/refinement/FacetOrigin.h"

#include <glm/vec3.hpp>

#include <cmath>
#include <vector>

namespace PhotonTransport
{

/// How far a ray starts above its facet, relative to the reach of its point (Scene::Reach): 32
/// units in the last place of a coordinate as large as that. A start is rounded once, by half such
/// a unit, and Embree's distances to facets err by a few units of the facets' extent, which parts
/// keep within three times the reach (Waechter and Binder, "A Fast and Robust Method for
/// Avoiding Self-Intersection", Ray Tracing Gems, 2019, measure the same errors and add a wide
/// reserve).
constexpr float OriginOffset = 0x1p-19f;

/// How far from the facet's edges a ray starts, in offsets. A start lifted off one wall of an acute
/// corner would land behind the other wall if it were closer to the edge than offset * cot(angle).
/// 4 is enough for corners of 14 degrees and more; with less, rays get out there.
constexpr float EdgeClearance = 4.0f;

/// The points of a surface, on the way to the scene's records.
struct PlacedPoints
{
  LargeArray<glm::vec3> positions; ///< In scene units.
  LargeArray<glm::dvec3> normals;  ///< See UsableNormal.
};

/// What the walk needs of a facet, in one half of a cache line.
struct alignas(32) Facet
{
  glm::uvec3 vertices;
  float reflectance; ///< Diffuse, luminous.
  glm::vec3 normal;  ///< Unit, on the side of the vertex normals (the front).
  /// MarginPerOffset(), with the sign -1 where IsFlat(): there is no room for more.
  float signedMargin;

  /// Least barycentric coordinate at which a ray may start, for each unit of its offset; see
  /// SafeOrigin.
  float MarginPerOffset() const { return std::fabs(this->signedMargin); }
  /// Whether all vertices that light on it counts for are flat; see Vertex::IsFlat().
  bool IsFlat() const { return std::signbit(this->signedMargin); }
};

/// The facet of the given surface that a facet of a refined one is a part of: light counts for its
/// vertices.
struct alignas(64) GivenFacet
{
  glm::uvec3 vertices;
  FacetOrigin origin;
};

/// A point of a facet on which light is registered.
struct RegisteredPlace
{
  const glm::uvec3& vertices; ///< Of a record of the scene.
  glm::vec3 barycentric;
};

/// What registration and reflection need of a vertex. Areas are in scene units.
struct alignas(64) Vertex
{
  glm::vec3 position;
  glm::vec3 normal; ///< Unit: the given one, or the ring's if the given one is not usable.
  /// Mean area vector over area, (1/3 sum a_f) / (1/3 sum |a_f|), over the ring.
  glm::vec3 shownArea;
  /// -1: flat, no compensation. 2: some facet tilts 90 degrees or more. Else the sine of the
  /// largest tilt, which is the angle between the normal and the normal of a facet of the ring.
  /// Light with -w.n >= sinTilt meets every facet of the ring from the front.
  float sinTilt;
  /// 1 / sum |a_f|; 0 for a vertex without a facet, and 1 where only the position counts.
  float inverseThreeAreas;

  /// Whether all registrations do the same here as Registration::Flat.
  bool IsFlat() const { return this->sinTilt < 0.0f; }
};

} // namespace PhotonTransport
