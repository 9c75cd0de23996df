// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/sampling/PhotonSample.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace PhotonTransport
{

/// Draws the numbers of one scattering of each of many photons together, with the bits of
/// ScatteringNumbers::At: the chain of Philox's multiplications is as long for one photon as for
/// all, and what a photon does is known before it is its turn.
class ScatteringSamples
{
public:
  static constexpr std::size_t Most = 64;

  explicit ScatteringSamples(const SequenceKey& key)
    : Key(key)
  {
  }

  /// Sets the sample of a place in the list of photons, of which there is none yet.
  /// @param order Of the scattering.
  void Add(std::size_t place, const ScatteringNumbers& numbers, std::uint32_t order)
  {
    if (order == 0)
    {
      this->Samples[place] = numbers.first;
      return;
    }
    this->Places[this->Count] = static_cast<std::uint8_t>(place);
    this->IndexLow[this->Count] = static_cast<std::uint32_t>(numbers.photonIndex);
    this->IndexHigh[this->Count] = static_cast<std::uint32_t>(numbers.photonIndex >> 32);
    this->Order[this->Count++] = order;
  }
  /// Ends the list.
  void Draw();

  const ScatteringSample& operator[](std::size_t place) const { return this->Samples[place]; }

private:
  SequenceKey Key;
  std::size_t Count = 0;
  std::array<std::uint8_t, Most> Places;
  alignas(64) std::array<std::uint32_t, Most> IndexLow, IndexHigh, Order;
  std::array<ScatteringSample, Most> Samples;
};

} // namespace PhotonTransport
