// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/registration/Registration.h"
#include "PhotonTransport/scene/FourLanes.h"
#include "PhotonTransport/scene/Scene.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace PhotonTransport
{

/// Numbers of the three corners of a facet; the fourth has no meaning.
inline Four OfCorners(const glm::vec3& numbers)
{
  return Four{ numbers.x, numbers.y, numbers.z, 0.0f };
}

/// Scalar products of a vector with four others.
inline Four Dots(const glm::vec3& v, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
  const glm::vec3& d)
{
  return v.x * Four{ a.x, b.x, c.x, d.x } + v.y * Four{ a.y, b.y, c.y, d.y } +
    v.z * Four{ a.z, b.z, c.z, d.z };
}

/// Area that the ring of `v` shows to light arriving from `towards`, over its whole area:
/// sum (towards . a_f)^+ / sum |a_f|. Only grazing light needs this sum over the ring; otherwise
/// Vertex::shownArea gives the same.
inline float ShownArea(const Scene& scene, std::uint32_t v, const glm::vec3& towards)
{
  const std::size_t number = scene.RingSize(v);
  const auto area = [&](std::size_t i)
  { return i < number ? scene.AreaInRing(v, i) : glm::vec3(0.0f); };
  const Four none{};
  Four sums{};
  for (std::size_t i = 0; i < number; i += 4)
  {
    const Four shown = Dots(towards, area(i), area(i + 1), area(i + 2), area(i + 3));
    sums += shown > none ? shown : none;
  }
  return (sums[0] + sums[1] + sums[2] + sums[3]) * scene.Vertices()[v].inverseThreeAreas;
}

/// The weights of HitWeights for Registration::FacetRatio.
inline Four FacetRatioWeights(const Scene& scene, const RegisteredPlace& place,
  const glm::vec3& facetNormal, const glm::vec3& towards)
{
  glm::vec3 smooth(0.0f);
  for (int corner = 0; corner < 3; ++corner)
  {
    smooth += place.barycentric[corner] * scene.Vertices()[place.vertices[corner]].normal;
  }
  const float length = glm::length(smooth);
  const float cosSmooth = glm::dot(towards, smooth);
  if (!(cosSmooth > 0.0f && length > 0.0f))
  {
    return Four{};
  }
  const float cosFlat = std::max(0.0f, glm::dot(towards, facetNormal));
  // Formula (2) as its text means it: the first s_norm is the smooth normal, the second the flat.
  return std::min(cosSmooth / (length * cosFlat), LargestFactor) * OfCorners(place.barycentric);
}

/// What light shows of the vertices of a facet, side by side; the fourth number is 0.
struct ShownCorners
{
  ShownCorners(const Scene& scene, const glm::uvec3& vertices, const glm::vec3& towards)
  {
    const Vertex& a = scene.Vertices()[vertices.x];
    const Vertex& b = scene.Vertices()[vertices.y];
    const Vertex& c = scene.Vertices()[vertices.z];
    const glm::vec3 none(0.0f);
    this->sinTilt = OfCorners({ a.sinTilt, b.sinTilt, c.sinTilt });
    this->cosine = Dots(towards, a.normal, b.normal, c.normal, none);
    this->area = Dots(towards, a.shownArea, b.shownArea, c.shownArea, none);
  }

  /// Where light is so grazing that only the sum over the ring tells the area.
  FourBits NeedsRing() const
  {
    const Four zero{};
    return (this->cosine > zero) & (this->cosine < this->sinTilt);
  }

  Four sinTilt;
  Four cosine; ///< To the vertex normal.
  Four area;   ///< See ShownArea.
};

/// Whether the weights of a hit take sums over rings.
template <Registration RegistrationKind>
bool NeedsRings(const Scene& scene, const RegisteredPlace& place, const glm::vec3& towards)
{
  if constexpr (RegistrationKind == Registration::VertexNormalised)
  {
    return Any(ShownCorners(scene, place.vertices, towards).NeedsRing());
  }
  return false;
}

/// The weights of HitWeights for Registration::VertexNormalised: of all corners at once, and
/// without branches, since chance decides whether a corner is flat.
inline Four VertexNormalisedWeights(
  const Scene& scene, const RegisteredPlace& place, const glm::vec3& towards)
{
  ShownCorners corners(scene, place.vertices, towards);
  const FourBits needsRing = corners.NeedsRing();
  if (Any(needsRing)) // rarely
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      if (needsRing[corner] != 0)
      {
        corners.area[corner] = ShownArea(scene, place.vertices[corner], towards);
      }
    }
  }
  const Four zero{};
  // The hit facet is in the ring, so only rounding at grazing incidence can bring this to 0.
  const Four shown = Largest(zero, corners.area);
  Four factor = Least(FourTimes(LargestFactor), corners.cosine / shown);
  factor = corners.cosine > zero ? factor : zero;
  const Four barycentric = OfCorners(place.barycentric);
  return corners.sinTilt < zero ? barycentric : barycentric * factor;
}

/// Weights of one hit for the three vertices of its facet, before the bound. Each is within
/// [0, LargestFactor] times its barycentric coordinate; the fourth number has no meaning. On facets
/// that are flat all registrations do the same as Registration::Flat, up to rounding.
/// @param facetNormal Of the facet that was hit. @param towards Unit, on the front of the facet:
/// back along the ray for a hit on the front, along it for a hit on the back.
template <Registration RegistrationKind>
Four HitWeights(const Scene& scene, const RegisteredPlace& place, const glm::vec3& facetNormal,
  const glm::vec3& towards)
{
  if constexpr (RegistrationKind == Registration::Flat)
  {
    return OfCorners(place.barycentric);
  }
  else if constexpr (RegistrationKind == Registration::FacetRatio)
  {
    return FacetRatioWeights(scene, place, facetNormal, towards);
  }
  else
  {
    return VertexNormalisedWeights(scene, place, towards);
  }
}

} // namespace PhotonTransport
