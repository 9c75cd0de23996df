// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/geometry/Frame.h"
#include "PhotonTransport/materials/DiffuseReflection.h"
#include "PhotonTransport/sampling/Philox.h"
#include "PhotonTransport/sampling/PhotonSample.h"
#include "PhotonTransport/sampling/Warps.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

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

/// The most draws for the direction of a photon that microfacets have passed on to each other.
constexpr std::uint32_t MostDirectionDraws = 64;

/// The direction in which light leaves that microfacets pass on to each other. With E(mu) as the
/// mean of ReflectGlossily's probability at a cosine mu, and E_avg as its mean by Lambert's law,
/// the lobe from i to o is (1 - E(i)) (1 - E(o)) / (pi (1 - E_avg)) (Kulla and Conty, "Revisiting
/// Physically Based Shading at Imageworks", 2017). It loses nothing, and it is the same from o to
/// i, so rays that are followed against the light find the light that photons bring.
///
/// No table of E is needed: a direction by Lambert's law is accepted if a photon from there would
/// be passed on, too. Light by Lambert's law takes one draw a photon on average. What is left after
/// MostDirectionDraws, E_avg^MostDirectionDraws of the lobe, is mirrored, which is as reciprocal.
/// That is at most 0.6 % of glossily reflected light by Lambert's law (at roughness 0.26), and 5 %
/// of light at a cosine of 0.1 (at roughness 0.2).
/// @param sample Of the photon; its numbers are not uniform among those that get here, and only
/// tell them apart.
[[gnu::noinline]] inline glm::vec3 LeaveMicrofacets(
  const glm::vec3& towards, const glm::vec3& normal, float alpha, const ScatteringSample& sample)
{
  constexpr std::uint32_t GlossyStream = 0x476c6f73u;
  for (std::uint32_t draw = 0; draw < MostDirectionDraws; ++draw)
  {
    const std::array<std::uint32_t, 4> fresh =
      Philox({ sample.survival, static_cast<std::uint32_t>(sample.u * 0x1p24f),
               static_cast<std::uint32_t>(sample.v * 0x1p24f), draw },
        { GlossyStream, 0 });
    const glm::vec3 leaving = ReflectDiffusely(normal, UnitFloat(fresh[0]), UnitFloat(fresh[1]));
    const GlossyDirection lobe =
      ReflectGlossily(leaving, normal, alpha, UnitFloat(fresh[2]), UnitFloat(fresh[3]));
    // UnitFloat leaves 8 bits of each number, which make a fifth.
    const std::uint32_t fifth = (fresh[0] & 0xffu) << 24 | (fresh[1] & 0xffu) << 16 |
      (fresh[2] & 0xffu) << 8 | (fresh[3] & 0xffu);
    if (fifth * 0x1p-32 >= double{ lobe.probability })
    {
      return leaving;
    }
  }
  return glm::normalize(2.0f * glm::dot(towards, normal) * normal - towards);
}

/// The direction in which glossily reflected light leaves; none of it is lost. The law is
/// reciprocal.
/// @param place A uniform number in [0, 1), independent of the sample's u and v.
inline glm::vec3 ReflectFromMicrofacets(const glm::vec3& towards, const glm::vec3& normal,
  float alpha, const ScatteringSample& sample, double place)
{
  const GlossyDirection lobe = ReflectGlossily(towards, normal, alpha, sample.u, sample.v);
  return place < double{ lobe.probability } ? lobe.direction
                                            : LeaveMicrofacets(towards, normal, alpha, sample);
}

} // namespace PhotonTransport
