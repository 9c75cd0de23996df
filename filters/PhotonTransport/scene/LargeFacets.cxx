// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/LargeFacets.h"

#include "PhotonTransport/threads/Threads.h"

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
  const LargeArray<Vertex>& vertices, const LargeArray<Facet>& facets, float leastReach)
{
  const auto halves = [leastReach](const glm::vec3& a, const glm::vec3& b)
  {
    const glm::vec3 along = b - a;
    const float length = glm::length(along);
    const float place = std::clamp(-glm::dot(a, along) / (length * length), 0.0f, 1.0f);
    return length > 1.5f * std::max(glm::length(a + place * along), leastReach);
  };
  constexpr std::size_t Chunk = 4096;
  std::vector<std::vector<FacetPart>> chunks((facets.size() + Chunk - 1) / Chunk);
  const auto look = [&](std::size_t chunk)
  {
    const auto end = static_cast<std::uint32_t>(std::min((chunk + 1) * Chunk, facets.size()));
    for (auto f = static_cast<std::uint32_t>(chunk * Chunk); f < end; ++f)
    {
      const glm::vec3& a = vertices[facets[f].vertices.x].position;
      const glm::vec3& b = vertices[facets[f].vertices.y].position;
      const glm::vec3& c = vertices[facets[f].vertices.z].position;
      if (!IsFarForItsSize(a, b, c)) // as nearly all are
      {
        AppendParts(f, { a, b, c }, halves, chunks[chunk]);
      }
    }
  };
  ForEach(chunks.size(), look, 1);
  std::vector<FacetPart> parts;
  for (const std::vector<FacetPart>& chunk : chunks)
  {
    parts.insert(parts.end(), chunk.begin(), chunk.end());
  }
  return parts;
}

} // namespace

std::vector<FacetPart> PartsOfLargeFacets(
  const LargeArray<Vertex>& vertices, const LargeArray<Facet>& facets, float& leastReach)
{
  std::vector<FacetPart> parts = Parts(vertices, facets, leastReach);
  const std::size_t most = MostParts(facets.size());
  while (parts.size() > most) // where thousands of large facets meet next to the origin
  {
    leastReach *= 16.0f;
    parts = Parts(vertices, facets, leastReach);
  }
  return parts;
}

} // namespace PhotonTransport
