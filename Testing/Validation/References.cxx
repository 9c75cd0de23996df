// SPDX-License-Identifier: BSD-3-Clause
#include "References.h"

#include "PhotonTransport/lights/CieSkyLuminance.h"

#include <boost/math/quadrature/gauss.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace References
{

double ConfigurationFactor(
  const glm::dvec3& point, const glm::dvec3& normal, const std::vector<glm::dvec3>& polygon)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const glm::dvec3 a = glm::normalize(polygon[i] - point);
    const glm::dvec3 b = glm::normalize(polygon[(i + 1) % polygon.size()] - point);
    const double angle = std::acos(std::clamp(glm::dot(a, b), -1.0, 1.0));
    sum += angle * glm::dot(normal, glm::normalize(glm::cross(a, b)));
  }
  return std::fabs(sum) / (2.0 * Pi);
}

double RectangleSolidAngle(double a, double b, double h)
{
  return 4.0 * std::asin(a * b / std::sqrt((a * a + h * h) * (b * b + h * h)));
}

double SheetTransmittance(double cosine, double index)
{
  const double sine = std::sqrt(1.0 - cosine * cosine);
  const double inside = std::sqrt(1.0 - sine * sine / (index * index));
  const double s = (cosine - index * inside) / (cosine + index * inside);
  const double p = (index * cosine - inside) / (index * cosine + inside);
  return 0.5 * ((1.0 - s * s) / (1.0 + s * s) + (1.0 - p * p) / (1.0 + p * p));
}

double Integral(const std::function<double(double)>& f, double from, double to)
{
  return boost::math::quadrature::gauss<double, 20>::integrate(f, from, to);
}

double FloorIntegral(double half, const Opening& opening, const Luminance& sky, double index,
  const std::function<double(double x, double y)>& g,
  const std::function<double(double y)>& upperEnd, double lastLit)
{
  // dE = L cos(at the floor) cos(at the opening) / distance^2 dA, times the sheet's transmittance.
  const auto illuminance = [&](const glm::dvec3& p)
  {
    const double end = upperEnd ? std::min(opening.v1, upperEnd(p.y)) : opening.v1;
    const auto strip = [&](double v)
    {
      return Integral(
        [&](double x)
        {
          const glm::dvec3 there =
            opening.standing ? glm::dvec3(x, opening.height, v) : glm::dvec3(x, v, opening.height);
          const glm::dvec3 ray = there - p;
          const double distance2 = glm::dot(ray, ray);
          const glm::dvec3 direction = ray / std::sqrt(distance2);
          const double cosine = opening.standing ? direction.y : direction.z;
          const double sheet = index > 1.0 ? SheetTransmittance(cosine, index) : 1.0;
          return sky(direction) * direction.z * cosine / distance2 * sheet;
        },
        opening.x0, opening.x1);
    };
    return end > opening.v0 ? Integral(strip, opening.v0, end) : 0.0;
  };
  const auto row = [&](double y) {
    return Integral([&](double x) { return g(x, y) * illuminance({ x, y, 0.0 }); }, -half, half);
  };
  return Integral(row, -half, std::min(half, lastLit));
}

Luminance CieSkyLuminance(int type, const glm::dvec3& sun, double horizontalIlluminance)
{
  const double sunAngle = std::acos(sun.z);
  const auto relative = [=](const glm::dvec3& direction)
  {
    return PhotonTransport::RelativeSkyLuminance(type, std::acos(std::clamp(direction.z, 0.0, 1.0)),
      sunAngle, std::acos(std::clamp(glm::dot(direction, sun), -1.0, 1.0)));
  };
  // Of the relative luminance times cos(z) over the hemisphere. In polar coordinates about the sun
  // the cusp there is at an end of the interval; what lies below the horizon is left out.
  const auto ring = [&](double zenithAngle)
  {
    const auto at = [&](double azimuth)
    {
      const double s = std::sin(zenithAngle);
      return relative({ s * std::cos(azimuth), s * std::sin(azimuth), std::cos(zenithAngle) });
    };
    const double towardsSun = std::atan2(sun.y, sun.x);
    // In pieces that end at the sun's azimuth and get finer towards it.
    double sum = 0.0;
    for (const auto& [from, to] :
      { std::pair(0.0, 0.05), std::pair(0.05, 0.4), std::pair(0.4, Pi) })
    {
      sum += 2.0 * Integral([&](double a) { return at(towardsSun + a); }, from, to);
    }
    return sum * std::sin(zenithAngle) * std::cos(zenithAngle);
  };
  double whole = 0.0;
  for (const auto& [from, to] : { std::pair(0.0, 0.5 * sunAngle),
         std::pair(0.5 * sunAngle, sunAngle), std::pair(sunAngle, 0.5 * (sunAngle + 0.5 * Pi)),
         std::pair(0.5 * (sunAngle + 0.5 * Pi), 0.5 * Pi) })
  {
    whole += Integral(ring, from, to);
  }
  const double zenith = horizontalIlluminance / whole;
  return [=](const glm::dvec3& direction) { return zenith * relative(direction); };
}

} // namespace References
