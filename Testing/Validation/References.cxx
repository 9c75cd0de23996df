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

double ReceiverIntegral(const Rectangle& receiver, const Rectangle& opening, const Luminance& sky,
  double index, const std::function<double(const glm::dvec3& point)>& g,
  const std::function<double(const glm::dvec3& point)>& end)
{
  const glm::dvec3 receiverArea = glm::cross(receiver.u, receiver.v);
  const glm::dvec3 openingArea = glm::cross(opening.u, opening.v);
  const glm::dvec3 openingNormal = glm::normalize(openingArea);
  // dE dA = L cos(at the receiver) cos(at the opening) / distance^2 dA dA, times the sheet's
  // transmittance; the areas' lengths, cosines and distance are in the products.
  const auto between = [&](const glm::dvec3& from, const glm::dvec3& to)
  {
    const glm::dvec3 ray = to - from;
    const double distance2 = glm::dot(ray, ray);
    const glm::dvec3 direction = ray / std::sqrt(distance2);
    const double sheet =
      index > 1.0 ? SheetTransmittance(std::fabs(glm::dot(direction, openingNormal)), index) : 1.0;
    return sky(direction) * sheet *
      std::fabs(glm::dot(direction, receiverArea) * glm::dot(direction, openingArea)) / distance2;
  };
  const auto at = [&](const glm::dvec3& p)
  {
    const auto strip = [&](double t)
    {
      return Integral([&](double s)
        { return between(p, opening.corner + s * opening.u + t * opening.v); },
        0.0, 1.0);
    };
    return g(p) * Integral(strip, 0.0, end ? std::clamp(end(p), 0.0, 1.0) : 1.0);
  };
  const auto row = [&](double t)
  {
    return Integral(
      [&](double s) { return at(receiver.corner + s * receiver.u + t * receiver.v); }, 0.0, 1.0);
  };
  return Integral(row, 0.0, 1.0);
}

Luminance CieSkyLuminance(int type, const glm::dvec3& sun, double horizontalIlluminance)
{
  const double sunAngle = std::acos(sun.z);
  const auto relative = [=](const glm::dvec3& direction)
  {
    return PhotonTransport::RelativeSkyLuminance(type, std::acos(std::clamp(direction.z, 0.0, 1.0)),
      sunAngle, std::acos(std::clamp(glm::dot(direction, sun), -1.0, 1.0)));
  };
  // Of the relative luminance times cos(z) over the hemisphere. The cusp at the sun is a corner of
  // the pieces, which Gauss's points come closest to.
  const auto ring = [&](double zenithAngle)
  {
    const auto at = [&](double azimuth)
    {
      const double s = std::sin(zenithAngle);
      return relative({ s * std::cos(azimuth), s * std::sin(azimuth), std::cos(zenithAngle) });
    };
    const double towardsSun = std::atan2(sun.y, sun.x);
    // In pieces that get finer towards the sun's azimuth; the other half is the same.
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
