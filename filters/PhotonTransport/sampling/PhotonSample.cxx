// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/sampling/PhotonSample.h"

#include "PhotonTransport/sampling/Warps.h"
#include "PhotonTransport/sampling/WideVectors.h"

#include <algorithm>
#include <cstring>

namespace PhotonTransport
{

PhotonSequence::PhotonSequence(const SequenceKey& key, std::uint64_t photonIndex)
{
  this->Key = key;
  this->Index = photonIndex;
  this->StartSequence();
}

void PhotonSequence::StartSequence()
{
  if (this->Key.sampling == Sampling::Random)
  {
    this->DrawNumbers();
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
  this->Scramble();
}

void PhotonSequence::DrawNumbers()
{
  // Blocks that no scattering order reaches.
  const auto low = PhotonRandom(this->Key, this->Index, 0xfffffffeu);
  const auto high = PhotonRandom(this->Key, this->Index, 0xffffffffu);
  for (unsigned d = 0; d < 4; ++d)
  {
    this->Numbers[d] = low[d];
    this->Numbers[d + 4] = high[d];
  }
  FindPointsOnDisk(this, 1);
}

void PhotonSequence::Scramble()
{
  for (unsigned d = 0; d < SobolDimensions; ++d)
  {
    this->Numbers[d] = OwenScramble(this->Point[d], this->Scrambles[d]);
  }
  FindPointsOnDisk(this, 1);
}

void PhotonSequence::Advance()
{
  const auto position = static_cast<std::uint32_t>(this->Index);
  ++this->Index;
  if (this->Key.sampling == Sampling::Random)
  {
    this->DrawNumbers();
  }
  else if (position == 0xffffffffu)
  {
    this->StartSequence();
  }
  else
  {
    AdvanceSobolPoint(this->Point, position);
    this->Scramble();
  }
}

void PhotonSequence::Take(PhotonSample* samples, std::size_t count)
{
  const bool isWithinSequence = static_cast<std::uint32_t>(this->Index) <= 0xffffffffu - count;
  if (this->Key.sampling == Sampling::Sobol && isWithinSequence)
  {
    WithWideVectors([&] { this->TakeFromSequence(samples, count); });
    return;
  }
  for (std::size_t i = 0; i < count; ++i, this->Advance())
  {
    samples[i] = *this;
  }
}

/// All dimensions of a point are one vector.
inline void PhotonSequence::TakeFromSequence(PhotonSample* samples, std::size_t count)
{
  using Eight = std::uint32_t __attribute__((vector_size(4 * SobolDimensions)));
  Eight point, seeds, step, numbers;
  std::memcpy(&point, this->Point.data(), sizeof point);
  std::memcpy(&seeds, this->Scrambles.data(), sizeof seeds);
  for (std::size_t i = 0; i < count; ++i)
  {
    numbers = point;
    OwenScrambleInPlace(numbers, seeds);
    samples[i].Key = this->Key;
    samples[i].Index = this->Index;
    std::memcpy(samples[i].Numbers.data(), &numbers, sizeof numbers);
    std::memcpy(&step, SobolStep(static_cast<std::uint32_t>(this->Index++)).data(), sizeof step);
    point ^= step;
  }
  std::memcpy(this->Point.data(), &point, sizeof point);
  OwenScrambleInPlace(point, seeds);
  std::memcpy(this->Numbers.data(), &point, sizeof point);
  FindPointsOnDisk(samples, count);
  FindPointsOnDisk(this, 1);
}

/// Warps the first two numbers of each photon onto the disk, and the next two.
inline void PhotonSequence::FindPointsOnDisk(PhotonSample* samples, std::size_t count)
{
  constexpr std::size_t Together = 32;
  constexpr std::size_t Pairs = 4;
  alignas(64) std::array<float, Together * Pairs> numbers;
  for (std::size_t first = 0; first < count; first += Together)
  {
    const std::size_t number = std::min(Together, count - first);
    for (std::size_t i = 0; i < number; ++i)
    {
      for (unsigned d = 0; d < Pairs; ++d)
      {
        numbers[Pairs * i + d] = samples[first + i].Emission(d);
      }
    }
    // Simple enough to become vector operations.
    for (std::size_t i = 0; i < number * Pairs; i += Pairs)
    {
      const glm::vec2 a = ConcentricDisk(numbers[i], numbers[i + 1]);
      const glm::vec2 b = ConcentricDisk(numbers[i + 2], numbers[i + 3]);
      numbers[i] = a.x;
      numbers[i + 1] = a.y;
      numbers[i + 2] = b.x;
      numbers[i + 3] = b.y;
    }
    for (std::size_t i = 0; i < number; ++i)
    {
      std::memcpy(&samples[first + i].PointsOnDisk, &numbers[Pairs * i], Pairs * sizeof(float));
    }
  }
}

} // namespace PhotonTransport
