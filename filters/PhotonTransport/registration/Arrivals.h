// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace PhotonTransport
{

/// Where the photons of a lamp first arrived, each counted once. A photon arrives on a front, where
/// it registers, or on a back that lets no light through. A back whose material lets light through
/// (a lamp shade, a pane, the inside of a glass body) is not counted: there a photon is still on
/// its way. So, exactly and for any scene,
///
///   emitted = front + back + escaped + absorbed + cutOff.
///
/// PhotonBalance counts how the photons end: emitted = absorbed + escaped + cutOff.
struct Arrivals
{
  std::uint64_t front = 0;    ///< On a front, where it registered.
  std::uint64_t back = 0;     ///< On a back that lets no light through; it may reach a front later.
  std::uint64_t escaped = 0;  ///< Left the scene before it arrived.
  std::uint64_t absorbed = 0; ///< By a back that lets light through, before it arrived.
  std::uint64_t cutOff = 0;   ///< At such a back, by the path length limit or a switch.

  std::uint64_t Emitted() const
  {
    return this->front + this->back + this->escaped + this->absorbed + this->cutOff;
  }

  Arrivals& operator+=(const Arrivals& other)
  {
    this->front += other.front;
    this->back += other.back;
    this->escaped += other.escaped;
    this->absorbed += other.absorbed;
    this->cutOff += other.cutOff;
    return *this;
  }
};

} // namespace PhotonTransport
