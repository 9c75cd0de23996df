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
///   emitted = front + back + escaped + absorbed + cutOff + elsewhere.
///
/// Where light comes through openings, photons of one part of a lamp's light may be counted by
/// another part; then these are `elsewhere`. PhotonBalance counts how the photons end. Arrivals are
/// numbers of photons, or in lm.
template <typename Number>
struct ArrivalsOf
{
  Number front{ 0 };    ///< On a front, where it registered.
  Number back{ 0 };     ///< On a back that lets no light through; it may reach a front later.
  Number escaped{ 0 };  ///< Left the scene before it arrived.
  Number absorbed{ 0 }; ///< By a back that lets light through, before it arrived.
  Number cutOff{ 0 };   ///< At such a back, by the path length limit or a switch.
  /// Handed over before it arrived, blocked, or arrived outdoors, where the Whole of the lamp
  /// counts it; see PhotonBalance and LightPart.
  Number elsewhere{ 0 };

  /// All but those elsewhere.
  Number Emitted() const
  {
    return this->front + this->back + this->escaped + this->absorbed + this->cutOff;
  }

  ArrivalsOf& operator+=(const ArrivalsOf& other)
  {
    this->AddTimes(1, other);
    return *this;
  }

  /// Adds another one, each of its photons counted `times`.
  template <typename Other>
  void AddTimes(Number times, const ArrivalsOf<Other>& other)
  {
    this->front += times * static_cast<Number>(other.front);
    this->back += times * static_cast<Number>(other.back);
    this->escaped += times * static_cast<Number>(other.escaped);
    this->absorbed += times * static_cast<Number>(other.absorbed);
    this->cutOff += times * static_cast<Number>(other.cutOff);
    this->elsewhere += times * static_cast<Number>(other.elsewhere);
  }
};

using Arrivals = ArrivalsOf<std::uint64_t>;
using ArrivedFlux = ArrivalsOf<double>; ///< lm

} // namespace PhotonTransport
