// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/sampling/Philox.h"
#include "PhotonTransport/sampling/Sobol.h"

#include <array>
#include <cstdint>

namespace PhotonTransport
{

enum class Sampling : int
{
  Random = 0, ///< Independent numbers everywhere.
  Sobol = 1   ///< Owen-scrambled Sobol points for emission and first scattering.
};

/// A number in [0, 1) from the 24 leading bits, which a float holds exactly.
inline float UnitFloat(std::uint32_t bits)
{
  return static_cast<float>(bits >> 8) * 0x1p-24f;
}

/// The numbers that decide one scattering.
struct ScatteringSample
{
  std::uint32_t survival; ///< Compared with reflectance * 2^32.
  float u, v;             ///< Direction, each in [0, 1).
};

/// Which independent sequence of photons: everything that is random is a function of this and of
/// the photon's index.
struct SequenceKey
{
  std::uint32_t seed = 1;
  std::uint32_t replicate = 0;
  Sampling sampling = Sampling::Sobol;
};

/// All the random numbers of consecutive photons, one photon at a time.
class PhotonSample
{
public:
  PhotonSample(const SequenceKey& key, std::uint64_t photonIndex);

  /// Moves on to the photon with the next index.
  void Advance();

  /// Dimension `d` of the emission, in [0, 1): 0 and 1, 2 and 3 are the best stratified pairs.
  float Emission(unsigned d) const { return UnitFloat(this->Leading(d)); }
  static constexpr unsigned FacetDimension = 4;
  /// The same as a 32-bit fraction, for choosing among many.
  std::uint32_t EmissionBits(unsigned d) const { return this->Leading(d); }

  /// The numbers of scattering `order` (0 is the photon's first).
  ScatteringSample Scattering(std::uint32_t order) const
  {
    if (order == 0)
    {
      return { this->Leading(5), UnitFloat(this->Leading(6)), UnitFloat(this->Leading(7)) };
    }
    const std::array<std::uint32_t, 4> bits = this->Random(order);
    return { bits[0], UnitFloat(bits[1]), UnitFloat(bits[2]) };
  }

private:
  std::uint32_t Leading(unsigned dimension) const
  {
    return this->Key.sampling == Sampling::Sobol
      ? OwenScramble(this->Point[dimension], this->Scrambles[dimension])
      : this->Point[dimension];
  }
  std::array<std::uint32_t, 4> Random(std::uint32_t block) const
  {
    return Philox({ static_cast<std::uint32_t>(this->Index),
                    static_cast<std::uint32_t>(this->Index >> 32), block, this->Key.replicate },
      { this->Key.seed, PhotonStream });
  }
  void StartSequence();
  void DrawPoint();

  /// Second word of the Philox key: keeps photons' numbers apart from scrambling seeds.
  static constexpr std::uint32_t PhotonStream = 0x50686f74u;
  static constexpr std::uint32_t ScrambleStream = 0x4f77656eu;

  SequenceKey Key;
  std::uint64_t Index;
  SobolPoint Point{};
  std::array<std::uint32_t, SobolDimensions> Scrambles{};
};

} // namespace PhotonTransport
