// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/Guide.h"
#include "PhotonTransport/geometry/Frame.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// How rays go on from diffuse facets close to a receiver. Light from afar comes there from about
/// where it comes to the receiver from, so that some of the rays follow the receiver's guide, as
/// far as the facet faces its directions, and the others the cosine. Light from close by comes from
/// other directions: the more of it there is, the fewer rays follow the guide. The weight is by the
/// density of both together (the one-sample model of Veach and Guibas, "Optimally Combining
/// Sampling Techniques for Monte Carlo Rendering", 1995, section 4.1), so that it stays bounded
/// where the guide knows nothing.
class NearGuide
{
public:
  struct Way
  {
    glm::vec3 direction;
    float weight; ///< The density of the cosine over that of the direction; 0 if it leads inside.
  };

  /// @param guide Of a receiver. @param frame In which it knows directions. @param near [cell]
  /// Whether its light comes from close by, as far as is known.
  void Set(const Guide& guide, const Frame& frame, const std::vector<std::uint8_t>& near);

  /// @param normal Unit, of the facet on the side that the ray leaves. @param u, v In [0, 1).
  Way At(const glm::vec3& normal, float u, float v);

private:
  void Face(const glm::vec3& normal);
  glm::vec3 Guided(float u, float v) const;
  float DensityOf(const glm::vec3& direction) const;

  std::size_t Size = 0; ///< Cells of the guide along each side.
  Frame Axes{ glm::vec3(0.0f, 0.0f, 1.0f) };
  /// [cell] Of the square of directions, in the frame, by the solid angle of the cell.
  std::vector<glm::vec3> Middles;
  std::vector<float> Shares; ///< [cell] By which light comes from there to a facet.
  float MostGuided = 0.0f;   ///< Share of the rays that follow the guide.
  glm::vec3 Facing{ 0.0f };  ///< The normal of the facet for which Ends are.
  std::vector<float> Ends;   ///< [cell] Sums of what cells bring to the facet, with each cell.
};

} // namespace PhotonTransport
