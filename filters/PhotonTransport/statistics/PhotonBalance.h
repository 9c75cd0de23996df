// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace PhotonTransport
{

/// What became of the photons: emitted = absorbed + escaped + cutOff, exactly.
struct PhotonBalance
{
  std::uint64_t emitted = 0;
  std::uint64_t absorbed = 0; ///< Ended by Russian roulette at a surface.
  std::uint64_t escaped = 0;  ///< Left the scene without a further hit.
  std::uint64_t cutOff = 0;   ///< Survived, but reached the path length limit.
  std::uint64_t segments = 0; ///< Rays traced.

  PhotonBalance& operator+=(const PhotonBalance& other)
  {
    this->emitted += other.emitted;
    this->absorbed += other.absorbed;
    this->escaped += other.escaped;
    this->cutOff += other.cutOff;
    this->segments += other.segments;
    return *this;
  }
};

} // namespace PhotonTransport
