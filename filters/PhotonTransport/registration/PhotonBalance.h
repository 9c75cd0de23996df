// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/materials/ScatteringSet.h"

#include <array>
#include <cstdint>

namespace PhotonTransport
{

/// What became of the photons: emitted = absorbed + escaped + cutOff, exactly.
struct PhotonBalance
{
  std::uint64_t emitted = 0;
  std::uint64_t absorbed = 0; ///< Ended at a surface.
  std::uint64_t escaped = 0;  ///< Left the scene without a further hit.
  std::uint64_t cutOff = 0;   ///< Ended by the path length limit or by an effect switched off.
  std::uint64_t segments = 0; ///< Rays traced.
  std::uint64_t onBacks = 0;  ///< Those of them that ended on the back of a facet.
  /// [Scattering] Part of cutOff: photons that an effect which is switched off would have carried
  /// on.
  std::array<std::uint64_t, Scatterings> switchedOff{};

  PhotonBalance& operator+=(const PhotonBalance& other)
  {
    this->emitted += other.emitted;
    this->absorbed += other.absorbed;
    this->escaped += other.escaped;
    this->cutOff += other.cutOff;
    this->segments += other.segments;
    this->onBacks += other.onBacks;
    for (unsigned s = 0; s < Scatterings; ++s)
    {
      this->switchedOff[s] += other.switchedOff[s];
    }
    return *this;
  }
};

} // namespace PhotonTransport
