// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/sampling/ScatteringSamples.h"

#include "PhotonTransport/sampling/WideVectors.h"

namespace PhotonTransport
{

void ScatteringSamples::Draw()
{
  alignas(64) std::array<std::uint32_t, Most> survival;
  alignas(64) std::array<float, Most> u, v;
  WithWideVectors(
    [&]
    {
      const std::size_t count = this->Count;
      for (std::size_t i = 0; i < count; ++i) // simple enough to become vector operations
      {
        const std::array<std::uint32_t, 4> bits =
          PhotonRandom(this->Key, this->IndexLow[i], this->IndexHigh[i], this->Order[i]);
        survival[i] = bits[0];
        u[i] = UnitFloat(bits[1]);
        v[i] = UnitFloat(bits[2]);
      }
    });
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    this->Samples[this->Places[i]] = { survival[i], u[i], v[i] };
  }
  this->Count = 0;
}

} // namespace PhotonTransport
