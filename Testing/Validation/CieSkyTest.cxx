// SPDX-License-Identifier: BSD-3-Clause
// The skies of ISO 15469:2004 against what is known of them from elsewhere. Lamp and reference of
// the cases of CIE 171 share the formula, so a wrong parameter would show here only.
#include "References.h"

#include "PhotonTransport/lights/CieSkyLuminance.h"

#include <gtest/gtest.h>

#include <cmath>

using PhotonTransport::RelativeSkyLuminance;
using References::Pi;

namespace
{

constexpr double SunAngle = 0.9; ///< From the zenith.

/// phi(Z) / phi(0): towards a point as far from the sun as the zenith is.
double Gradation(int type, double zenithAngle)
{
  return RelativeSkyLuminance(type, zenithAngle, SunAngle, SunAngle);
}

/// f(chi) / f(sun's zenith angle): at the zenith, were the sun that far from it.
double Indicatrix(int type, double angleToSun)
{
  return RelativeSkyLuminance(type, 0.0, SunAngle, angleToSun);
}

/// The clear sky as in CIE S 003:1996, Kittler's, with rounded constants.
double ClearSky(double zenithAngle, double angleToSun, double one, double c, double e)
{
  const auto towards = [&](double angle)
  { return one + c * std::exp(-3.0 * angle) + e * std::cos(angle) * std::cos(angle); };
  return (1.0 - std::exp(-0.32 / std::cos(zenithAngle))) * towards(angleToSun) /
    (0.27385 * towards(SunAngle));
}

} // namespace

TEST(CieSky, ClearSkiesFollowTheirEarlierFormula)
{
  // Half a unit of the last place of 0.91 and 0.856, over the least bracket, twice.
  const double rounding[] = { 0.005 / 0.91, 0.0005 / 0.856 };
  for (double zenith = 0.0; zenith < 1.57; zenith += 0.1)
  {
    for (double angle = std::fabs(zenith - SunAngle); angle < zenith + SunAngle; angle += 0.1)
    {
      const double low = ClearSky(zenith, angle, 0.91, 10.0, 0.45);
      EXPECT_NEAR(RelativeSkyLuminance(12, zenith, SunAngle, angle) / low, 1.0, 2.0 * rounding[0]);
      const double polluted = ClearSky(zenith, angle, 0.856, 16.0, 0.3);
      EXPECT_NEAR(
        RelativeSkyLuminance(13, zenith, SunAngle, angle) / polluted, 1.0, 2.0 * rounding[1]);
    }
  }
}

TEST(CieSky, OvercastSkiesAreOneThirdAtTheHorizon)
{
  for (const int type : { 1, 16 })
  {
    EXPECT_NEAR(RelativeSkyLuminance(type, 0.5 * Pi, SunAngle, 1.0), 1.0 / 3.0, 0.002);
    // Moon and Spencer's between the two: (1 + 2 / 2) / 3 at 60 degrees.
    EXPECT_NEAR(RelativeSkyLuminance(type, Pi / 3.0, SunAngle, 1.0), 2.0 / 3.0, 0.002);
  }
}

TEST(CieSky, UniformSkyIsUniform)
{
  for (double angle = 0.0; angle <= 0.5 * Pi; angle += 0.1)
  {
    EXPECT_DOUBLE_EQ(Gradation(5, angle), 1.0);
    EXPECT_DOUBLE_EQ(Indicatrix(5, angle), 1.0);
  }
}

// The standard's types are pairs of a gradation, I to VI, and an indicatrix, 1 to 6.
TEST(CieSky, TypesArePairsOfSixGradationsAndSixIndicatrices)
{
  constexpr double Gradations[6][2] = { { 4.0, -0.7 }, { 1.1, -0.8 }, { 0.0, -1.0 },
    { -1.0, -0.55 }, { -1.0, -0.32 }, { -1.0, -0.15 } };
  constexpr double Indicatrices[6][3] = { { 0.0, -1.0, 0.0 }, { 2.0, -1.5, 0.15 },
    { 5.0, -2.5, 0.3 }, { 10.0, -3.0, 0.45 }, { 16.0, -3.0, 0.3 }, { 24.0, -2.8, 0.15 } };
  constexpr int Pairs[15][2] = { { 1, 1 }, { 1, 2 }, { 2, 1 }, { 2, 2 }, { 3, 1 }, { 3, 2 },
    { 3, 3 }, { 3, 4 }, { 4, 2 }, { 4, 3 }, { 4, 4 }, { 5, 4 }, { 5, 5 }, { 6, 5 }, { 6, 6 } };
  for (int type = 1; type <= 15; ++type)
  {
    const auto& [a, b] = Gradations[Pairs[type - 1][0] - 1];
    const auto& [c, d, e] = Indicatrices[Pairs[type - 1][1] - 1];
    const auto phi = [a = a, b = b](double zenith)
    { return 1.0 + a * std::exp(b / std::cos(zenith)); };
    const auto f = [c = c, d = d, e = e](double angle)
    {
      return 1.0 + c * (std::exp(d * angle) - std::exp(0.5 * d * Pi)) +
        e * std::cos(angle) * std::cos(angle);
    };
    for (double angle = 0.0; angle < 1.57; angle += 0.1)
    {
      EXPECT_NEAR(Gradation(type, angle), phi(angle) / phi(0.0), 1e-12) << type;
      EXPECT_NEAR(Indicatrix(type, angle), f(angle) / f(SunAngle), 1e-12) << type;
    }
  }
}

TEST(CieSky, IsLightEverywhere)
{
  for (int type = 1; type <= 16; ++type)
  {
    for (double zenith = 0.0; zenith <= 0.5 * Pi; zenith += 0.01)
    {
      for (double angle = std::fabs(zenith - SunAngle); angle < zenith + SunAngle; angle += 0.1)
      {
        EXPECT_GT(RelativeSkyLuminance(type, zenith, SunAngle, angle), 0.0) << type;
      }
    }
  }
}
