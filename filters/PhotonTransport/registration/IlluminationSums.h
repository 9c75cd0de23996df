// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/materials/Colour.h"
#include "PhotonTransport/memory/HugePages.h"
#include "PhotonTransport/registration/Arrivals.h"
#include "PhotonTransport/registration/CellCounts.h"
#include "PhotonTransport/registration/PhotonBalance.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace PhotonTransport
{

class Ranks;

/// Sums of weights as 64-bit integers with 28 fraction bits. Integer addition is associative: a sum
/// has the same bits whatever the order, and 3e10 full hits fit.
using FixedPoint = std::int64_t;
constexpr float FixedPointOne = 0x1p28f;

/// Rounds to nearest. @param weight in [0, 2^30). @param startWeight Of the photon, by which the
/// weight counts; the product must be in that range, too.
inline FixedPoint ToFixedPoint(float weight, float startWeight = 1.0f)
{
  return static_cast<FixedPoint>(weight * (startWeight * FixedPointOne) + 0.5f);
}
inline double FromFixedPoint(FixedPoint sum)
{
  return static_cast<double>(sum) / double{ FixedPointOne };
}

/// Rounds to nearest. @param share [0, 1]
inline FixedPoint ShareOf(FixedPoint weight, float share)
{
  return static_cast<FixedPoint>(static_cast<double>(weight) * double{ share } + 0.5);
}

/// A weight by channels, which add up to it: the channel with the largest share takes what rounding
/// leaves. None is negative. @param shares Together 1 up to rounding.
inline std::array<FixedPoint, 3> PartsByChannel(FixedPoint weight, const Colour& shares)
{
  std::array<FixedPoint, 3> parts = { ShareOf(weight, shares.x), ShareOf(weight, shares.y),
    ShareOf(weight, shares.z) };
  const std::size_t largest =
    shares.y >= shares.x ? (shares.y >= shares.z ? 1 : 2) : (shares.x >= shares.z ? 0 : 2);
  parts[largest] += weight - parts[0] - parts[1] - parts[2];
  return parts;
}

/// For weights that may be huge: with 12 fraction bits, a sum can hold nearly 2^31 hits of weight
/// 2^20.
constexpr float CoarseFixedPointOne = 0x1p12f;
inline FixedPoint ToCoarseFixedPoint(float weight)
{
  return static_cast<FixedPoint>(weight * CoarseFixedPointOne + 0.5f);
}
inline double FromCoarseFixedPoint(FixedPoint sum)
{
  return static_cast<double>(sum) / double{ CoarseFixedPointOne };
}

/// What one vertex has got: V_i of Barladian, "Indirect illumination on curve surfaces", and for
/// VertexNormalised that times A_i, so that E_i = (flux / N) V_i / A_i holds for every
/// registration.
struct alignas(32) VertexSums
{
  FixedPoint direct = 0;
  FixedPoint indirect = 0;
  std::uint64_t hits = 0; ///< On the facets around the vertex.

  VertexSums& operator+=(const VertexSums& other)
  {
    this->direct += other.direct;
    this->indirect += other.indirect;
    this->hits += other.hits;
    return *this;
  }
};

/// Parts of the light on the front that are kept apart, by colour.
struct LightLayers
{
  static constexpr std::size_t Channels = 3;
  /// Of each photon the channels' shares in its light, and their squares, which tell how much
  /// photons differ in them.
  static constexpr std::size_t ColourLayers = 2 * Channels;

  LightLayers() = default;
  /// @param slots See IlluminationSums.
  LightLayers(std::size_t slots, bool colour)
    : perSlot(colour ? ColourLayers : 0)
  {
    ResizeOnHugePages(this->sums, slots * this->perSlot);
  }

  bool HasColour() const { return this->perSlot > 0; }

  std::size_t perSlot = 0;
  std::vector<FixedPoint> sums; ///< [slot][layer]
  LampCellCounts lampCells;     ///< Empty unless light is counted by cells and lamps.
};

/// E = (flux / N) V / A, lx; 0 where no photon or no area is. @param flux lm. @param area m^2.
/// @param weights V, from the sums of `photons` photons.
inline double IlluminanceOf(double flux, double area, double weights, double photons)
{
  // In this order, since the flux of one weight may be too small for a normal number.
  return area > 0.0 && photons > 0.0 ? flux / area * weights / photons : 0.0;
}

/// All that is kept of a set of photons. The sums of disjoint sets add up. The light of a vertex is
/// in a slot, or in one slot for each lamp where lamps are kept apart: all vertices of the first
/// lamp come first.
struct IlluminationSums
{
  IlluminationSums() = default;
  IlluminationSums(std::size_t vertices, bool backSide, std::size_t sources = 1,
    LightLayers ofLight = {}, std::size_t lampsApart = 1)
    : lamps(lampsApart)
    , layers(std::move(ofLight))
    , cutByWeightBound(sources)
    , balances(sources)
    , arrivals(sources)
  {
    ResizeOnHugePages(this->front, vertices * lampsApart);
    ResizeOnHugePages(this->back, backSide ? vertices * lampsApart : 0);
  }

  std::size_t lamps = 1;         ///< That are kept apart.
  std::vector<VertexSums> front; ///< [slot]
  std::vector<VertexSums> back;  ///< [slot] Empty unless the back is registered.
  LightLayers layers;
  CellCounts cells; ///< Empty unless light is counted by cells.
  /// [source] Weight that the bound cut off, coarse and without the start weight, over all vertices
  /// and the sides that are registered.
  std::vector<FixedPoint> cutByWeightBound;
  std::vector<PhotonBalance> balances; ///< [source] See Emitter.
  std::vector<Arrivals> arrivals;      ///< [source]

  PhotonBalance Balance() const;
};

/// Adds `part` to `total` and clears it.
void MoveInto(LightLayers& total, LightLayers& part);
void MoveInto(IlluminationSums& total, IlluminationSums& part);
/// The same of all but vertices and layers.
void MoveCounts(IlluminationSums& total, IlluminationSums& part);

/// Replaces sums by those over all ranks.
void SumOver(Ranks& ranks, IlluminationSums& sums);

} // namespace PhotonTransport
