// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace PhotonTransport
{

/// A compensating factor never exceeds this, even before the bound, so that fixed point holds it.
constexpr float LargestFactor = 0x1p20f;

/// How a hit is spread over its facet's vertices. Formula numbers are those of Barladian,
/// "Indirect illumination on curve surfaces".
enum class Registration : int
{
  Flat = 0,            ///< Formula (1): as if the facets were the surface.
  FacetRatio = 1,      ///< Formulas (2), (3): times cos to the smooth over cos to the flat normal.
  VertexNormalised = 2 ///< Times cos to the vertex normal over the area the ring shows to the ray.
};
constexpr unsigned Registrations = 3;

} // namespace PhotonTransport
