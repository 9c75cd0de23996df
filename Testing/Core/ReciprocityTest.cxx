// SPDX-License-Identifier: BSD-3-Clause
// Gloss from one direction to another and back.
#include "PhotonTransport/materials/GlossyReflection.h"

#include "RandomNumbers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

using namespace PhotonTransport;

namespace
{

constexpr double Pi = 3.14159265358979323846;

/// How many of the photons that arrive by Lambert's law go from which directions to which: by bands
/// of the cosines in and out, and by the angle between the azimuths.
struct Exchange
{
  static constexpr int Photons = 500'000;
  static constexpr std::size_t Bands = 6, Turns = 6;
  static constexpr std::array<float, Bands> Lower{ 0.0f, 0.1f, 0.2f, 0.4f, 0.6f, 0.8f };

  std::vector<double> counts = std::vector<double>(Bands * Bands * Turns, 0.0);
  std::array<double, Bands> leaving{};

  explicit Exchange(float roughness)
  {
    RandomNumbers random(17);
    for (int i = 0; i < Photons; ++i)
    {
      const float u = random.Unit();
      const glm::vec3 in = CosineHemisphere(u, random.Unit());
      ScatteringSample sample{ random.Bits(), random.Unit(), 0.0f };
      sample.v = random.Unit();
      const glm::vec3 out = ReflectFromMicrofacets(
        in, { 0.0f, 0.0f, 1.0f }, roughness * roughness, sample, sample.survival * 0x1p-32);
      const double turn =
        std::fabs(std::atan2(in.x * out.y - in.y * out.x, in.x * out.x + in.y * out.y));
      const auto cell = static_cast<std::size_t>(turn / Pi * Turns);
      this->counts[Index(BandOf(in.z), BandOf(out.z), std::min(Turns - 1, cell))] += 1.0;
      this->leaving[BandOf(out.z)] += 1.0;
    }
  }

  template <class Call>
  void ForEachPair(const Call& call) const
  {
    for (std::size_t a = 0; a < Bands; ++a)
    {
      for (std::size_t b = 0; b < a; ++b)
      {
        for (std::size_t turn = 0; turn < Turns; ++turn)
        {
          call(this->counts[Index(a, b, turn)], this->counts[Index(b, a, turn)]);
        }
      }
    }
  }

  static double LambertsShare(std::size_t band)
  {
    const double above = band + 1 < Bands ? double{ Lower[band + 1] } : 1.0;
    return above * above - double{ Lower[band] } * double{ Lower[band] };
  }

private:
  static std::size_t BandOf(float cosine)
  {
    const auto* above = std::upper_bound(Lower.begin(), Lower.end(), std::max(cosine, 0.0f));
    return static_cast<std::size_t>(above - Lower.begin()) - 1;
  }
  static std::size_t Index(std::size_t in, std::size_t out, std::size_t turn)
  {
    return (in * Bands + out) * Turns + turn;
  }
};

} // namespace

// Among photons that arrive by Lambert's law as many go from one direction to another as back: of n
// that go either way, half, with variance n / 4.
TEST(Glossy, IsReciprocal)
{
  for (const float roughness : { 0.1f, 0.2f, 0.3f, 0.6f, 1.0f })
  {
    const Exchange exchange(roughness);
    double chi2 = 0.0;
    int used = 0;
    exchange.ForEachPair(
      [&](double there, double back)
      {
        if (there + back >= 20.0)
        {
          chi2 += std::pow(there - back, 2) / (there + back);
          ++used;
        }
      });
    EXPECT_GE(used, 10) << roughness;
    EXPECT_LE(chi2, used + 4.0 * std::sqrt(2.0 * used)) << roughness;
  }
}

// Light that arrives by Lambert's law leaves by Lambert's law: a furnace.
TEST(Glossy, CannotBeSeenInAFurnace)
{
  for (const float roughness : { 0.1f, 0.2f, 0.3f, 0.6f, 1.0f })
  {
    const Exchange exchange(roughness);
    for (std::size_t band = 0; band < Exchange::Bands; ++band)
    {
      const double share = Exchange::LambertsShare(band);
      const double deviation = std::sqrt(Exchange::Photons * share * (1.0 - share));
      EXPECT_NEAR(exchange.leaving[band], Exchange::Photons * share, 4.0 * deviation)
        << roughness << ' ' << band;
    }
  }
}
