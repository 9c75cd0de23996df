// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

/// Warps of the unit square. All but UniformTriangle start from the concentric map to the disk,
/// which keeps well spread points well spread; the squared radius then is the uniform number that
/// decides the polar angle. Only PowerCosineCone with an exponent calls the mathematical library
/// for more than a square root.

namespace PhotonTransport
{

/// Uniform on the unit disk, density 1/pi by area. Shirley and Chiu, "A Low Distortion Map Between
/// Disk and Square", 1997.
inline glm::vec2 ConcentricDisk(float u, float v)
{
  const float a = 2.0f * u - 1.0f;
  const float b = 2.0f * v - 1.0f;
  const bool wide = std::fabs(a) > std::fabs(b);
  const float radius = wide ? a : b;
  // Where both are zero any divisor but zero will do.
  const float ratio = (wide ? b : a) / (radius == 0.0f ? 1.0f : radius);
  const float angle = 0.78539816339744831f * ratio; // within +-pi/4
  // Taylor, error below 3e-8 within +-pi/4.
  const float s = angle * angle;
  const float sine =
    angle * (1.0f + s * (-1.0f / 6 + s * (1.0f / 120 + s * (-1.0f / 5040 + s * (1.0f / 362880)))));
  const float cosine = 1.0f + s * (-0.5f + s * (1.0f / 24 + s * (-1.0f / 720 + s / 40320)));
  const float along = radius * cosine;
  const float across = radius * sine;
  return { wide ? along : across, wide ? across : along };
}

/// The place in the unit square that ConcentricDisk maps to a point of the unit disk.
inline glm::vec2 SquareOfDisk(const glm::vec2& p)
{
  constexpr float FourByPi = 1.27323954473516269f;
  const bool wide = std::fabs(p.x) > std::fabs(p.y);
  const float radius = std::copysign(std::sqrt(p.x * p.x + p.y * p.y), wide ? p.x : p.y);
  if (radius == 0.0f)
  {
    return { 0.5f, 0.5f };
  }
  const float other = radius * FourByPi * std::atan(wide ? p.y / p.x : p.x / p.y);
  const glm::vec2 both = wide ? glm::vec2(radius, other) : glm::vec2(other, radius);
  return { 0.5f + 0.5f * both.x, 0.5f + 0.5f * both.y };
}

inline float SquaredRadius(const glm::vec2& p)
{
  return std::min(1.0f, p.x * p.x + p.y * p.y);
}

/// The direction of CosineHemisphere that belongs to a point of the unit disk.
inline glm::vec3 CosineHemisphereAbove(const glm::vec2& p)
{
  return { p.x, p.y, std::sqrt(1.0f - SquaredRadius(p)) };
}

/// Directions about +z with density cos(theta)/pi by solid angle (Malley's method).
inline glm::vec3 CosineHemisphere(float u, float v)
{
  return CosineHemisphereAbove(ConcentricDisk(u, v));
}

/// The direction of UniformSphere that belongs to a point of the unit disk.
inline glm::vec3 UniformSphereAbove(const glm::vec2& p)
{
  const float r2 = SquaredRadius(p);
  const float stretch = 2.0f * std::sqrt(1.0f - r2);
  return { stretch * p.x, stretch * p.y, 1.0f - 2.0f * r2 };
}

/// Directions with density 1/(4 pi) by solid angle.
inline glm::vec3 UniformSphere(float u, float v)
{
  return UniformSphereAbove(ConcentricDisk(u, v));
}

/// The direction of PowerCosineCone that belongs to a point of the unit disk.
inline glm::vec3 PowerCosineConeAbove(const glm::vec2& p, float exponent, float cosMax)
{
  const float r2 = SquaredRadius(p);
  const float cosine = exponent == 0.0f
    ? 1.0f - r2 * (1.0f - cosMax)
    : std::pow(1.0f - r2 * (1.0f - std::pow(cosMax, exponent + 1.0f)), 1.0f / (exponent + 1.0f));
  // sin(theta) / r; both vanish on the axis.
  const float sine2 = (1.0f - cosine) * (1.0f + cosine);
  const float stretch = r2 > 0.0f ? std::sqrt(std::max(0.0f, sine2) / r2) : 0.0f;
  return { stretch * p.x, stretch * p.y, cosine };
}

/// Directions about +z within theta <= thetaMax whose density is proportional to cos^n(theta) by
/// solid angle: (n + 1) cos^n(theta) / (2 pi (1 - cos^(n+1)(thetaMax))).
/// @param exponent n >= 0; above 0, cosMax must not be negative.
inline glm::vec3 PowerCosineCone(float u, float v, float exponent, float cosMax)
{
  return PowerCosineConeAbove(ConcentricDisk(u, v), exponent, cosMax);
}

/// Barycentric coordinates (of the second and third corner) uniform over a triangle, by folding
/// the square along its diagonal.
inline glm::vec2 UniformTriangle(float u, float v)
{
  // Either way without rounding, and without a branch, which would go either way by chance.
  const auto end = static_cast<float>(u + v >= 1.0f);
  return { std::fabs(end - u), std::fabs(end - v) };
}

} // namespace PhotonTransport
