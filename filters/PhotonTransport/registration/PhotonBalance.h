// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/materials/ScatteringSet.h"

#include <array>
#include <cstdint>

namespace PhotonTransport
{

/// What became of photons, as numbers or in lm. Exactly, for numbers,
///
///   emitted = absorbed + escaped + cutOff + handedOver + blocked.
template <typename Number>
struct BalanceOf
{
  Number emitted{ 0 };
  Number absorbed{ 0 }; ///< Ended at a surface.
  Number escaped{ 0 };  ///< Left the scene without a further hit.
  Number cutOff{ 0 };   ///< Ended by the path length limit or by an effect switched off.
  /// Ended as they crossed an opening inwards: photons that start there have their light.
  Number handedOver{ 0 };
  /// Not started, as no light comes to their place at an opening from their direction.
  Number blocked{ 0 };
  Number segments{ 0 }; ///< Rays traced to their ends.
  Number onBacks{ 0 };  ///< Those of them that ended on the back of a facet.
  /// [Scattering] Part of cutOff: photons that an effect which is switched off would have carried
  /// on.
  std::array<Number, Scatterings> switchedOff{};

  BalanceOf& operator+=(const BalanceOf& other)
  {
    this->AddTimes(1, other);
    return *this;
  }

  /// Adds another one, each of its photons counted `times`.
  template <typename Other>
  void AddTimes(Number times, const BalanceOf<Other>& other)
  {
    this->emitted += times * static_cast<Number>(other.emitted);
    this->absorbed += times * static_cast<Number>(other.absorbed);
    this->escaped += times * static_cast<Number>(other.escaped);
    this->cutOff += times * static_cast<Number>(other.cutOff);
    this->handedOver += times * static_cast<Number>(other.handedOver);
    this->blocked += times * static_cast<Number>(other.blocked);
    this->segments += times * static_cast<Number>(other.segments);
    this->onBacks += times * static_cast<Number>(other.onBacks);
    for (unsigned s = 0; s < Scatterings; ++s)
    {
      this->switchedOff[s] += times * static_cast<Number>(other.switchedOff[s]);
    }
  }
};

using PhotonBalance = BalanceOf<std::uint64_t>;
using FluxBalance = BalanceOf<double>; ///< lm

} // namespace PhotonTransport
