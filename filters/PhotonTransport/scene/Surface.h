// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/materials/Material.h"
#include "PhotonTransport/refinement/FacetOrigin.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// The surface that a refined one was made from.
struct GivenSurface
{
  std::vector<glm::uvec3> facets;
  std::size_t points = 0; ///< They are the first points of the refined surface, too.
  double turn = 0.0;      ///< The limit that the refinement kept to, see RefinementLimits; radians.
  /// Whether more parts were wanted than were allowed. It may also be that there are none.
  bool isCoarse = false;
  /// Which part of which given facet a facet is, one a facet. Parts of a facet follow each other.
  std::vector<FacetOrigin> origins;

  bool IsFirstPart(std::size_t facet) const
  {
    return facet == 0 || this->origins[facet].facet != this->origins[facet - 1].facet;
  }
};

/// What the user says of a facet as an opening, through which outdoor light enters.
enum class OpeningMark : std::uint8_t
{
  None,     ///< Nothing: it is one if it lets light through and leads outdoors.
  Opening,  ///< It is one.
  NoOpening ///< It is none, nor is a hole beside it or around it.
};

/// A triangulated surface as the user describes it, or as it was refined from that.
struct Surface
{
  std::vector<glm::dvec3> points;  ///< In the data's length unit; finite where a facet uses them.
  std::vector<glm::dvec3> normals; ///< One a point, any length; they say which side is the front.
  std::vector<glm::uvec3> facets;  ///< Point indices.
  std::vector<Material> materials; ///< What facets do with light, on both sides alike.
  std::vector<std::uint32_t> materialOfFacet; ///< One a facet: which of the materials.
  /// What the front of each facet emits, >= 0, or empty if none emits. Its Luminous() is in lm/m^2.
  std::vector<Colour> exitance;
  std::vector<OpeningMark> openingOfFacet; ///< One a facet, or empty if nothing is said of any.
  double metresPerUnit = 1.0;              ///< > 0, finite.
  /// By how much each coordinate of `points` was rounded at most before it came here, relative to
  /// that coordinate: 2^-24 for points of single precision, 0 for double. >= 0, finite. Surfaces
  /// that lie in one plane up to this are in one place, see SharedPlace.
  double rounding = 0.0;
  /// Empty unless the surface is refined. Light is registered on the given facets.
  GivenSurface given;

  bool IsRefined() const { return !this->given.origins.empty(); }
};

/// Throws InvalidInput at the first value outside what Surface promises.
void Validate(const Surface& surface);

/// Whether a facet treats the channels unequally, or emits them unequally.
/// @param surface Valid.
bool IsColoured(const Surface& surface, std::size_t facet);

} // namespace PhotonTransport
