// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/LargeFacets.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cstdint>

namespace PhotonTransport
{
namespace
{

std::size_t MostParts(std::size_t facets)
{
  constexpr std::size_t Few = 16384;
  return std::max(Few, facets / 8);
}

/// Whether no edge can be longer than 1.5 times its distance from the origin: the nearest point of
/// the facet is nearer than a corner by the longest edge at most.
bool IsFarForItsSize(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
  const glm::vec3 ab = b - a, bc = c - b, ca = a - c;
  const float longest = std::max(std::max(glm::dot(ab, ab), glm::dot(bc, bc)), glm::dot(ca, ca));
  constexpr float Lengths = 1.75f; // > 1 + 1 / 1.5
  return Lengths * Lengths * longest < glm::dot(a, a);
}

std::vector<FacetPart> Parts(
  const std::vector<glm::vec3>& positions, const std::vector<glm::uvec3>& facets, float leastReach)
{
  const auto halves = [leastReach](const glm::vec3& a, const glm::vec3& b)
  {
    const glm::vec3 along = b - a;
    const float length = glm::length(along);
    const float place = std::clamp(-glm::dot(a, along) / (length * length), 0.0f, 1.0f);
    return length > 1.5f * std::max(glm::length(a + place * along), leastReach);
  };
  std::vector<FacetPart> parts;
  for (std::uint32_t f = 0; f < facets.size(); ++f)
  {
    const glm::vec3& a = positions[facets[f].x];
    const glm::vec3& b = positions[facets[f].y];
    const glm::vec3& c = positions[facets[f].z];
    if (!IsFarForItsSize(a, b, c)) // as nearly all are
    {
      AppendParts(f, { a, b, c }, halves, parts);
    }
  }
  return parts;
}

} // namespace

std::vector<FacetPart> PartsOfLargeFacets(
  const std::vector<glm::vec3>& positions, const std::vector<glm::uvec3>& facets, float& leastReach)
{
  std::vector<FacetPart> parts = Parts(positions, facets, leastReach);
  const std::size_t most = MostParts(facets.size());
  while (parts.size() > most) // where thousands of large facets meet next to the origin
  {
    leastReach *= 16.0f;
    parts = Parts(positions, facets, leastReach);
  }
  return parts;
}

} // namespace PhotonTransport
