// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/geometry/Frame.h"
#include "PhotonTransport/sampling/Warps.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{

/// Smith's lambda of the GGX distribution (Heitz, "Understanding the Masking-Shadowing Function in
/// Microfacet-Based BRDFs", JCGT 3(2), 2014, eq. 72).
inline float SmithLambda(float cosine, float alpha)
{
  const float cosine2 = cosine * cosine;
  const float tangent2 = std::max(0.0f, 1.0f - cosine2) / cosine2;
  return 0.5f * (std::sqrt(1.0f + alpha * alpha * tangent2) - 1.0f);
}

/// A direction from a lobe about the mirror direction, and the probability that the photon leaves
/// in it. Otherwise the photon meets another microfacet.
struct GlossyDirection
{
  glm::vec3 direction;
  float probability;
};

/// Reflection from microfacets of the GGX distribution that reflect everything (Walter et al.,
/// "Microfacet Models for Refraction through Rough Surfaces", 2007). Each microfacet is chosen in
/// proportion to what the photon sees of it (Heitz, "Sampling the GGX Distribution of Visible
/// Normals", JCGT 7(4), 2018), by a spherical cap (Dupuy and Benyoub, "Sampling Visible GGX Normals
/// with Spherical Caps", 2023). The probability is G2 / G1, at most 1.
/// @param towards Unit, back along the photon's ray. @param normal Unit, on the same side.
/// @param alpha Of the distribution, > 0.
inline GlossyDirection ReflectGlossily(
  const glm::vec3& towards, const glm::vec3& normal, float alpha, float u, float v)
{
  const Frame frame(normal);
  glm::vec3 in(glm::dot(towards, frame.tangent), glm::dot(towards, frame.bitangent),
    glm::dot(towards, normal));
  constexpr float Grazing = 1e-6f;
  in.z = std::max(in.z, Grazing);
  const glm::vec3 stretched = glm::normalize(glm::vec3(alpha * in.x, alpha * in.y, in.z));
  // The cap of directions about z with z > -stretched.z, uniformly.
  const glm::vec2 p = ConcentricDisk(u, v);
  const float r2 = SquaredRadius(p);
  const float z = 1.0f - r2 * (1.0f + stretched.z);
  const float radius = std::sqrt(std::max(0.0f, (1.0f - z) * (1.0f + z)) / std::max(r2, 1e-30f));
  const glm::vec3 half = glm::vec3(radius * p.x, radius * p.y, z) + stretched;
  const glm::vec3 microfacet =
    glm::normalize(glm::vec3(alpha * half.x, alpha * half.y, std::max(half.z, Grazing)));
  const glm::vec3 out = 2.0f * glm::dot(in, microfacet) * microfacet - in;
  if (!(out.z > Grazing))
  {
    return { normal, 0.0f };
  }
  const float lambdaIn = SmithLambda(in.z, alpha);
  const float lambdaOut = SmithLambda(out.z, alpha);
  // G2 / G1 with heights correlated (Heitz 2014, eq. 99).
  const float probability = (1.0f + lambdaIn) / (1.0f + lambdaIn + lambdaOut);
  return { glm::normalize(frame.ToWorld(out)), probability };
}

} // namespace PhotonTransport
