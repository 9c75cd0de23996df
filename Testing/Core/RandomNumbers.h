// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/sampling/PhotonSample.h"

#include <cstdint>
#include <random>

/// Independent numbers that no photon uses.
class RandomNumbers
{
public:
  explicit RandomNumbers(std::uint32_t seed)
    : Engine(seed)
  {
  }
  std::uint32_t Bits() { return static_cast<std::uint32_t>(this->Engine()); }
  float Unit() { return PhotonTransport::UnitFloat(this->Bits()); }

private:
  std::mt19937 Engine;
};
