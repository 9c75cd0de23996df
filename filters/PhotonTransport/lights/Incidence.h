// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cmath>
#include <cstdint>
#include <limits>

namespace PhotonTransport
{

/// Light of one place of a lamp as it arrives at a point, if nothing stands between.
struct Incidence
{
  glm::vec3 towards{ 0.0f }; ///< Unit, from the point to the place on the lamp.
  float distance = 0.0f;     ///< Scene units; infinity from afar.
  /// Illuminance on a surface that faces it, for 1 lm of the lamp's flux (Prepared::flux), per
  /// scene unit squared; 0 if none arrives. Its mean over the numbers that choose the place, each
  /// uniform in [0, 1), is that of the whole lamp.
  double perLumen = 0.0;
  glm::dvec3 place{ 0.0 }; ///< On the lamp; unset from afar.

  Incidence() = default;
  Incidence(const glm::dvec3& point, const glm::dvec3& lampPlace, double illuminance)
    : place(lampPlace)
  {
    const glm::dvec3 way = lampPlace - point;
    const double length = glm::length(way);
    if (length > 0.0 && std::isfinite(illuminance))
    {
      this->towards = glm::vec3(way / length);
      this->distance = static_cast<float>(length);
      this->perLumen = illuminance;
    }
  }

  static Incidence FromAfar(const glm::vec3& direction, double illuminance)
  {
    Incidence incidence;
    incidence.towards = direction;
    incidence.distance = std::numeric_limits<float>::infinity();
    incidence.perLumen = illuminance;
    return incidence;
  }
};

/// How many numbers choose a place on a lamp.
enum class PlaceNumbers
{
  None, ///< The lamp is a point or far away.
  One,  ///< A line: the first number alone counts.
  Two
};

/// The bits of every second place of a number, from the lowest on.
inline std::uint32_t EvenBits(std::uint64_t x)
{
  x &= 0x5555555555555555u;
  x = (x | (x >> 1)) & 0x3333333333333333u;
  x = (x | (x >> 2)) & 0x0f0f0f0f0f0f0f0fu;
  x = (x | (x >> 4)) & 0x00ff00ff00ff00ffu;
  x = (x | (x >> 8)) & 0x0000ffff0000ffffu;
  return static_cast<std::uint32_t>(x | (x >> 16));
}

/// Two numbers in [0, 1) from one, along Morton's curve ("A Computer Oriented Geodetic Data Base",
/// 1966): intervals of equal length become cells of equal area that are about as long as wide, so
/// one stratified number gives stratified places.
inline glm::vec2 PlaceInSquare(double number)
{
  const auto bits = static_cast<std::uint64_t>(number * 0x1p48);
  return { static_cast<float>(EvenBits(bits >> 1)) * 0x1p-24f,
    static_cast<float>(EvenBits(bits)) * 0x1p-24f };
}

} // namespace PhotonTransport
