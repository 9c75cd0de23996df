// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/CellSides.h"

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace PhotonTransport
{

/// So many values for each side of each cell, or none at all.
class ValuesOfSides
{
public:
  ValuesOfSides() = default;
  ValuesOfSides(std::size_t sides, std::size_t valuesOfSide)
    : PerSide(valuesOfSide)
    , Values(sides * valuesOfSide, 0.0f)
  {
  }
  /// The values of a side; null if there are none at all.
  float* Of(std::size_t side)
  {
    return this->Values.empty() ? nullptr : &this->Values[side * this->PerSide];
  }
  const float* Of(std::size_t side) const
  {
    return this->Values.empty() ? nullptr : &this->Values[side * this->PerSide];
  }

private:
  std::size_t PerSide = 0;
  std::vector<float> Values;
};

/// The light that leaves each side of each cell diffusely, by replicate of the first pass, in units
/// that the caller chooses, and the caustics that arrive there. A channel's part is luminous, so
/// that parts add up.
struct CellExitance
{
  /// All 0. @param shares Of each replicate in what the first pass has done; their sum is 1, or 0
  /// if it has done nothing. @param numberOfLamps That are kept apart.
  CellExitance(std::size_t cells, std::vector<double> shares, std::size_t numberOfChannels,
    std::size_t numberOfLamps, bool caustics)
    : channels(numberOfChannels)
    , lamps(numberOfLamps)
    , shareOf(std::move(shares))
    , known(cells * 2, 1)
    , leaving(cells * 2, this->shareOf.size() * numberOfChannels)
    , caustic(caustics ? this->leaving : ValuesOfSides())
    , leavingByLamp(cells * 2, numberOfChannels * numberOfLamps)
    , causticByLamp(caustics ? this->leavingByLamp : ValuesOfSides())
    , illuminance(cells * 2, 0.0f)
  {
  }

  std::size_t Replicates() const { return this->shareOf.size(); }

  std::size_t channels;
  std::size_t lamps;
  std::vector<double> shareOf;     ///< [replicate]
  std::vector<std::uint8_t> known; ///< [side] Whether anything is known; what leaves others is 0.
  ValuesOfSides leaving;           ///< [side][replicate][channel]
  ValuesOfSides caustic;           ///< [side][replicate][channel]; none if there are no caustics.
  ValuesOfSides leavingByLamp;     ///< [side][channel][lamp] Of all replicates.
  ValuesOfSides causticByLamp;     ///< The same.
  std::vector<float> illuminance;  ///< [side] The mean over all replicates.
};

} // namespace PhotonTransport
