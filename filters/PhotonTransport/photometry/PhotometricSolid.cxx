// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/photometry/PhotometricSolid.h"

#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{

namespace
{

/// A place between two neighbours of a list that rises.
struct Place
{
  std::size_t before;
  double fraction;
};

/// @param value Within the list's first and last.
Place Find(const std::vector<double>& list, double value)
{
  const auto after = std::upper_bound(list.begin() + 1, list.end() - 1, value);
  const double last = *(after - 1);
  return { static_cast<std::size_t>(after - list.begin()) - 1, (value - last) / (*after - last) };
}

/// The integral of I(p) sin p over all p, I linear in between the given angles.
double PolarIntegral(const std::vector<double>& polar, const double* candela)
{
  double sum = 0.0;
  for (std::size_t j = 0; j + 1 < polar.size(); ++j)
  {
    // The interval is [m - h, m + h]:
    //   integral of (c + s t) sin(m + t) for t in [-h, h]
    //     = 2 c sin m sin h + 2 s cos m (sin h - h cos h),
    // which does not lose digits in narrow intervals as the antiderivative's differences would.
    const double m = glm::radians(0.5 * (polar[j] + polar[j + 1]));
    const double h = glm::radians(0.5 * (polar[j + 1] - polar[j]));
    const double sinc = h > 0.0 ? std::sin(h) / h : 1.0;
    sum += (candela[j] + candela[j + 1]) * std::sin(m) * std::sin(h) +
      (candela[j + 1] - candela[j]) * std::cos(m) * (sinc - std::cos(h));
  }
  return sum;
}

} // namespace

double Flux(const PhotometricSolid& solid)
{
  double flux = 0.0;
  double before = 0.0;
  for (std::size_t i = 0; i < solid.azimuth.size(); ++i)
  {
    const double plane = PolarIntegral(solid.polar, &solid.candela[i * solid.polar.size()]);
    if (i > 0)
    {
      flux += glm::radians(solid.azimuth[i] - solid.azimuth[i - 1]) * 0.5 * (before + plane);
    }
    before = plane;
  }
  return flux;
}

double Intensity(const PhotometricSolid& solid, double polar, double azimuth)
{
  const double first = solid.azimuth.front();
  const double last = solid.azimuth.back();
  double turn = std::fmod(azimuth - first, 360.0);
  turn += turn < 0.0 ? 360.0 : 0.0;
  // The turn, not the angle, is compared: for the last azimuth it has the same rounding.
  if (!(polar >= solid.polar.front() && polar <= solid.polar.back() && turn <= last - first))
  {
    return 0.0;
  }
  const Place p = Find(solid.polar, polar);
  const Place z = Find(solid.azimuth, std::min(first + turn, last));
  const double* plane = &solid.candela[z.before * solid.polar.size() + p.before];
  const double* next = plane + solid.polar.size();
  const double a = plane[0] * (1.0 - p.fraction) + plane[1] * p.fraction;
  const double b = next[0] * (1.0 - p.fraction) + next[1] * p.fraction;
  return a * (1.0 - z.fraction) + b * z.fraction;
}

glm::dvec3 PhotometricDirection(PhotometricSolid::Type type, double polar, double azimuth)
{
  const double cosP = std::cos(glm::radians(polar));
  const double sinP = std::sin(glm::radians(polar));
  const double c = sinP * std::cos(glm::radians(azimuth));
  const double s = sinP * std::sin(glm::radians(azimuth));
  switch (type)
  {
    case PhotometricSolid::Type::A:
      return { s, cosP, -c };
    case PhotometricSolid::Type::B:
      return { cosP, s, -c };
    case PhotometricSolid::Type::C:
      break;
  }
  return { c, s, -cosP };
}

} // namespace PhotonTransport
