// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/sampling/Philox.h"
#include "PhotonTransport/sampling/Sampling.h"
#include "PhotonTransport/sampling/Sobol.h"

#include <glm/vec2.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace PhotonTransport
{

/// A number in [0, 1) from the 24 leading bits, which a float holds exactly.
inline float UnitFloat(std::uint32_t bits)
{
  // Processors convert signed numbers faster, many at a time.
  return static_cast<float>(static_cast<std::int32_t>(bits >> 8)) * 0x1p-24f;
}

/// Which of the independent sequences of photons. Everything that is random is a function of this
/// and of the photon's index.
struct SequenceKey
{
  std::uint32_t seed = 1;
  std::uint32_t replicate = 0;
  Sampling sampling = Sampling::Sobol;
};

/// Block number `block` of a photon's random numbers. @param low, high Of the photon's index.
inline std::array<std::uint32_t, 4> PhotonRandom(
  const SequenceKey& key, std::uint32_t low, std::uint32_t high, std::uint32_t block)
{
  constexpr std::uint32_t PhotonStream = 0x50686f74u; // apart from the scrambling seeds
  return Philox({ low, high, block, key.replicate }, { key.seed, PhotonStream });
}
inline std::array<std::uint32_t, 4> PhotonRandom(
  const SequenceKey& key, std::uint64_t photonIndex, std::uint32_t block)
{
  return PhotonRandom(key, static_cast<std::uint32_t>(photonIndex),
    static_cast<std::uint32_t>(photonIndex >> 32), block);
}

/// Two numbers in [0, 1) for photons that are kept or not.
inline std::array<float, 2> KeepingNumbers(const SequenceKey& key, std::uint64_t photonIndex)
{
  constexpr std::uint32_t KeepingBlock = 0xfffffffcu; // that no scattering order reaches
  const std::array<std::uint32_t, 4> bits = PhotonRandom(key, photonIndex, KeepingBlock);
  return { UnitFloat(bits[0]), UnitFloat(bits[1]) };
}

/// The numbers that decide one scattering.
struct ScatteringSample
{
  std::uint32_t survival; ///< Compared with shares of 2^32: what the facet does with the photon.
  float u, v;             ///< Direction, each in [0, 1).
};

/// The numbers that decide all the scatterings of one photon.
struct ScatteringNumbers
{
  SequenceKey key;
  std::uint64_t photonIndex;
  ScatteringSample first;

  /// In [0, 1): whether a photon is kept that was traced back to where its light comes from.
  float KeepingNumber() const { return KeepingNumbers(this->key, this->photonIndex)[1]; }

  /// Of scattering `order`; 0 is the photon's first.
  ScatteringSample At(std::uint32_t order) const
  {
    if (order == 0)
    {
      return this->first;
    }
    const std::array<std::uint32_t, 4> bits = PhotonRandom(this->key, this->photonIndex, order);
    return { bits[0], UnitFloat(bits[1]), UnitFloat(bits[2]) };
  }
};

/// All the random numbers of a photon.
class PhotonSample
{
public:
  /// Dimension `d` of the emission, in [0, 1). What takes two numbers takes 0 and 1, or 2 and 3.
  float Emission(unsigned d) const { return UnitFloat(this->Numbers[d]); }
  static constexpr unsigned ChoiceDimension = 4; ///< Chooses the lamp, and the facet that shines.
  /// The same as a 32-bit fraction, for choosing among many.
  std::uint32_t EmissionBits(unsigned d) const { return this->Numbers[d]; }

  /// ConcentricDisk of dimensions 2 * pair and 2 * pair + 1 of the emission. Much starts with it,
  /// and it takes less time for many photons together.
  const glm::vec2& OnDisk(unsigned pair) const { return this->PointsOnDisk[pair]; }

  /// In [0, 1): decides whether a photon is kept that was drawn by a bound of its light.
  float KeepingNumber() const { return KeepingNumbers(this->Key, this->Index)[0]; }

  ScatteringNumbers Scatterings() const
  {
    ScatteringNumbers numbers; // by members, since to copy all would wait until each is there
    numbers.key.seed = this->Key.seed;
    numbers.key.replicate = this->Key.replicate;
    numbers.key.sampling = this->Key.sampling;
    numbers.photonIndex = this->Index;
    numbers.first.survival = this->Numbers[5];
    numbers.first.u = UnitFloat(this->Numbers[6]);
    numbers.first.v = UnitFloat(this->Numbers[7]);
    return numbers;
  }

private:
  friend class PhotonSequence;

  SequenceKey Key;
  std::uint64_t Index = 0;
  std::array<std::uint32_t, SobolDimensions> Numbers{};
  std::array<glm::vec2, 2> PointsOnDisk{};
};

/// Consecutive photons, one at a time.
class PhotonSequence : public PhotonSample
{
public:
  PhotonSequence(const SequenceKey& key, std::uint64_t photonIndex);

  /// Moves on to the photon with the next index.
  void Advance();

  /// Stores photons from the present one on, and moves on behind them. Many together take less
  /// time.
  void Take(PhotonSample* samples, std::size_t count);

private:
  void StartSequence();
  void DrawNumbers();
  void Scramble();
  void TakeFromSequence(PhotonSample* samples, std::size_t count);
  static void FindPointsOnDisk(PhotonSample* samples, std::size_t count);

  alignas(32) SobolPoint Point{};
  alignas(32) std::array<std::uint32_t, SobolDimensions> Scrambles{};
};

} // namespace PhotonTransport
