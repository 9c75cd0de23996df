// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <vector>

namespace PhotonTransport
{

/// A triangulated surface as the user describes it.
struct Surface
{
  std::vector<glm::dvec3> points;  ///< In the data's length unit; finite where a facet uses them.
  std::vector<glm::dvec3> normals; ///< One a point, any length; they say which side is the front.
  std::vector<glm::uvec3> facets;  ///< Point indices.
  std::vector<float> reflectance;  ///< Diffuse, one a facet, in [0, 1]; the same on both sides.
  std::vector<float> exitance;     ///< lm/m^2 from the front, one a facet, >= 0; or empty.
  double metresPerUnit = 1.0;      ///< > 0.
};

/// Throws InvalidInput at the first value outside what Surface promises.
void Validate(const Surface& surface);

} // namespace PhotonTransport
