// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/materials/Colour.h"

#include <cstdint>

namespace PhotonTransport
{

/// Which light of a receiver some rays bring. Light through openings is gathered by rays of its
/// own, which are sent there. All rays together bring all light once, by the first opening that
/// light comes through straight to the receiver.
struct LightThrough
{
  static constexpr std::uint32_t Anywhere = 0xffffffffu;
  static constexpr std::uint32_t NoOpening = 0xfffffffeu;
  std::uint32_t opening = Anywhere; ///< Its index, or one of these.

  bool IsOpening() const { return this->opening < NoOpening; }
};

/// A ray on its way from a receiver.
struct GatherFlight
{
  std::uint32_t ray; ///< Index, below 2^16.
  std::uint32_t order = 0;
  Colour weight{ 1.0f }; ///< Of what it finds.
  bool branched = false; ///< It has left a diffuse facet near by towards an opening.
  bool direct = true;    ///< Only clear panes so far.
  LightThrough through{};
  /// Only diffuse facets near the receiver so far, from which it is followed in place of reading
  /// their cells.
  bool close = true;
  bool expected = false;   ///< A cell has told what light to expect; see GatherWalk.
  bool undeflected = true; ///< Only clear panes since the receiver or the last diffuse facet.
};

} // namespace PhotonTransport
