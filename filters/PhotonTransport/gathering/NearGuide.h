// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/Guide.h"
#include "PhotonTransport/geometry/Frame.h"
#include "PhotonTransport/sampling/Warps.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>

namespace PhotonTransport
{

/// How rays go on from diffuse facets close to a receiver. Light comes there from about where it
/// comes to the receiver from, so that some of the rays follow the receiver's guide and the others
/// the cosine. The weight is by the density of both together (the one-sample model of Veach and
/// Guibas, "Optimally Combining Sampling Techniques for Monte Carlo Rendering", 1995, section 4.1),
/// so that it stays bounded where the guide knows nothing.
class NearGuide
{
public:
  struct Way
  {
    glm::vec3 direction;
    float weight; ///< The density of the cosine over that of the direction; 0 if it leads inside.
  };

  /// @param guide Of the receiver; must outlive this. @param frame In which it knows directions.
  NearGuide(const Guide& guide, const Frame& frame)
    : Directions(guide)
    , Axes(frame)
  {
  }

  /// @param normal Unit, of the facet on the side that the ray leaves. @param u, v In [0, 1).
  Way At(const glm::vec3& normal, float u, float v) const
  {
    const bool guided = u >= ByCosine;
    const float place = (guided ? u - ByCosine : u) / (guided ? 1.0f - ByCosine : ByCosine);
    const float first = std::min(place, 1.0f - 0x1p-24f); // it may have rounded up to 1
    glm::vec3 direction;
    if (guided)
    {
      const glm::vec2 square = this->Directions.At(first, v).place;
      direction = this->Axes.ToWorld(CosineHemisphere(square.x, square.y));
    }
    else
    {
      direction = Frame(normal).ToWorld(CosineHemisphere(first, v));
    }
    const float cosine = glm::dot(direction, normal);
    if (!(cosine > 0.0f))
    {
      return { direction, 0.0f };
    }
    const float density = ByCosine * cosine + (1.0f - ByCosine) * this->DensityOf(direction);
    return { direction, cosine / density };
  }

private:
  static constexpr float ByCosine = 0.7f; ///< Share of the rays.

  /// That of the guide by solid angle, times pi.
  float DensityOf(const glm::vec3& direction) const
  {
    const float cosine = glm::dot(direction, this->Axes.normal);
    if (!(cosine > 0.0f))
    {
      return 0.0f;
    }
    const glm::vec2 square = SquareOfDisk(
      { glm::dot(direction, this->Axes.tangent), glm::dot(direction, this->Axes.bitangent) });
    return cosine * this->Directions.DensityAt(square);
  }

  const Guide& Directions;
  Frame Axes;
};

} // namespace PhotonTransport
