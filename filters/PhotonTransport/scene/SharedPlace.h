// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>

namespace PhotonTransport
{

/// Corners of a facet, as bits.
constexpr unsigned AllCorners = 7;

/// Facets in one plane that face the same way and have a part in common: each of them registers
/// the light that arrives there, and the last one in the list decides what becomes of it, as if it
/// lay on top. Facets are in one plane if rounding, also that of the data's coordinates, explains
/// how far they are apart. Light that leaves such facets starts beyond all of them.
///
/// A vertex that belongs to a facet and to a copy of it counts the light and the area once. For
/// that the three lowest bits mark the corners of a copy that an earlier facet has counted already.
/// The other bits say how a facet shares its place.
enum SharedPlace : std::uint8_t
{
  SharesPlace = 1 << 3,     ///< Set wherever one of the bits below is.
  IsCopy = 1 << 4,          ///< An earlier facet has the same three corners.
  OverlapsInPart = 1 << 5,  ///< It overlaps a facet that is no copy of it.
  UnlikeMaterials = 1 << 6, ///< A facet in its place has another material.
  ShinesToo = 1 << 7        ///< It shines, and so does a facet that it overlaps in part.
};

/// One of the facets in the place of a hit.
struct Sharer
{
  std::uint32_t facet;
  glm::vec3 barycentric;
  unsigned corners; ///< The corners that count, as bits.
};

/// How many facets share their place in one way, and the two of them with the largest common area.
struct SharedPlaceNote
{
  std::size_t facets = 0;
  std::uint32_t first = 0, second = 0; ///< In the surface's list.
  double squareMetres = 0.0;           ///< What these two have in common.
  double apart = 0.0;                  ///< How far any two are apart at most, in the data's unit.
};

/// The notes on all facets that share their place, by the way in which they do.
struct SharedPlaceNotes
{
  SharedPlaceNote copies, inPart, unlikeMaterials, shineToo;
  /// Facets that nearly do, see NearOverlaps: chance decides which of them light meets.
  SharedPlaceNote leftToChance;
};

} // namespace PhotonTransport
