// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/CieSkyLuminance.h"

#include <cmath>

namespace PhotonTransport
{
namespace
{

/// Of one type: gradation from zenith to horizon (a, b), scattering about the sun (c, d, e).
struct Sky
{
  double a, b, c, d, e;
};

/// ISO 15469:2004, table 1.
constexpr Sky Skies[15] = {
  { 4.0, -0.70, 0.0, -1.0, 0.00 },   // 1 overcast, steep gradation, azimuthal uniformity
  { 4.0, -0.70, 2.0, -1.5, 0.15 },   // 2 overcast, steep gradation, slight brightening to the sun
  { 1.1, -0.80, 0.0, -1.0, 0.00 },   // 3 overcast, moderately graded, azimuthal uniformity
  { 1.1, -0.80, 2.0, -1.5, 0.15 },   // 4 overcast, moderately graded, slight brightening
  { 0.0, -1.00, 0.0, -1.0, 0.00 },   // 5 uniform luminance
  { 0.0, -1.00, 2.0, -1.5, 0.15 },   // 6 partly cloudy, no gradation, slight brightening
  { 0.0, -1.00, 5.0, -2.5, 0.30 },   // 7 partly cloudy, no gradation, brighter circumsolar region
  { 0.0, -1.00, 10.0, -3.0, 0.45 },  // 8 partly cloudy, no gradation, distinct solar corona
  { -1.0, -0.55, 2.0, -1.5, 0.15 },  // 9 partly cloudy, obscured sun
  { -1.0, -0.55, 5.0, -2.5, 0.30 },  // 10 partly cloudy, brighter circumsolar region
  { -1.0, -0.55, 10.0, -3.0, 0.45 }, // 11 white-blue, distinct solar corona
  { -1.0, -0.32, 10.0, -3.0, 0.45 }, // 12 CIE standard clear sky, low turbidity
  { -1.0, -0.32, 16.0, -3.0, 0.30 }, // 13 CIE standard clear sky, polluted atmosphere
  { -1.0, -0.15, 16.0, -3.0, 0.30 }, // 14 cloudless turbid, broad solar corona
  { -1.0, -0.15, 24.0, -2.8, 0.15 }, // 15 white-blue turbid, broad solar corona
};

constexpr double HalfPi = 1.57079632679489661923;

} // namespace

double RelativeSkyLuminance(int type, double zenithAngle, double sunZenithAngle, double angleToSun)
{
  if (type == 16)
  {
    return (1.0 + 2.0 * std::cos(zenithAngle)) / 3.0; // clause 5, Moon and Spencer's sky
  }
  const Sky& sky = Skies[type - 1];
  const auto gradation = [&](double angle) // 1 + a exp(b / cos), whose limit at the horizon is 1
  {
    const double cosine = std::cos(angle);
    return cosine > 0.0 ? 1.0 + sky.a * std::exp(sky.b / cosine) : 1.0;
  };
  const auto indicatrix = [&](double angle)
  {
    const double cosine = std::cos(angle);
    return 1.0 + sky.c * (std::exp(sky.d * angle) - std::exp(sky.d * HalfPi)) +
      sky.e * cosine * cosine;
  };
  return indicatrix(angleToSun) * gradation(zenithAngle) /
    (indicatrix(sunZenithAngle) * gradation(0.0));
}

} // namespace PhotonTransport
