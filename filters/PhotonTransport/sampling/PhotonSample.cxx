// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/sampling/PhotonSample.h"

namespace PhotonTransport
{

PhotonSample::PhotonSample(const SequenceKey& key, std::uint64_t photonIndex)
  : Key(key)
  , Index(photonIndex)
{
  this->StartSequence();
}

void PhotonSample::StartSequence()
{
  if (this->Key.sampling == Sampling::Random)
  {
    this->DrawPoint();
    return;
  }
  this->Point = SobolPointAt(static_cast<std::uint32_t>(this->Index));
  constexpr std::uint32_t ScrambleStream = 0x4f77656eu;
  // Past 2^32 photons another, independently scrambled sequence begins.
  const auto sequence = static_cast<std::uint32_t>(this->Index >> 32);
  for (std::uint32_t d = 0; d < SobolDimensions; ++d)
  {
    this->Scrambles[d] =
      Philox({ d, sequence, 0, this->Key.replicate }, { this->Key.seed, ScrambleStream })[0];
  }
}

void PhotonSample::DrawPoint()
{
  // Blocks that no scattering order reaches.
  const auto low = PhotonRandom(this->Key, this->Index, 0xfffffffeu);
  const auto high = PhotonRandom(this->Key, this->Index, 0xffffffffu);
  for (unsigned d = 0; d < 4; ++d)
  {
    this->Point[d] = low[d];
    this->Point[d + 4] = high[d];
  }
}

void PhotonSample::Advance()
{
  const auto position = static_cast<std::uint32_t>(this->Index);
  ++this->Index;
  if (this->Key.sampling == Sampling::Random)
  {
    this->DrawPoint();
  }
  else if (position == 0xffffffffu)
  {
    this->StartSequence();
  }
  else
  {
    AdvanceSobolPoint(this->Point, position);
  }
}

} // namespace PhotonTransport
