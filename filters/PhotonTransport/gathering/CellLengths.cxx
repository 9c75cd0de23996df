// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/gathering/CellLengths.h"

#include "PhotonTransport/materials/DiffuseReflection.h"
#include "PhotonTransport/sampling/PhotonSample.h"
#include "PhotonTransport/sampling/Sobol.h"
#include "PhotonTransport/scene/HitPoint.h"
#include "PhotonTransport/threads/Threads.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace PhotonTransport
{
namespace
{

/// Length of cells in mean lengths of rays.
constexpr float PerDistance = 1.0f / 14.0f;

/// Rays on both sides of a facet, at most and at least.
constexpr std::size_t MostRays = 64;
constexpr std::size_t FewRays = 8;

/// What cells without anything to see, and all cells, are no longer than, in diagonals of the
/// scene.
constexpr float PerDiagonal = 1.0f / 48.0f;

struct Bounds
{
  glm::vec3 low{ 1.0f }, high{ -1.0f };
  float Diagonal() const { return glm::distance(this->low, this->high); }
};

Bounds BoundsOf(const Scene& scene)
{
  Bounds bounds;
  for (const Facet& facet : scene.Facets())
  {
    for (int c = 0; c < 3; ++c)
    {
      const glm::vec3& p = scene.Vertices()[facet.vertices[c]].position;
      bounds.low = glm::min(bounds.low, p);
      bounds.high = glm::max(bounds.high, p);
    }
  }
  return bounds;
}

float LongestEdge(const Scene& scene, std::uint32_t facet)
{
  const glm::uvec3& ids = scene.Facets()[facet].vertices;
  const auto corner = [&](int i) { return scene.Vertices()[ids[i]].position; };
  return std::max({ glm::distance(corner(0), corner(1)), glm::distance(corner(1), corner(2)),
    glm::distance(corner(2), corner(0)) });
}

/// The points of the sequence that all facets use, each in an order of its own.
std::array<SobolPoint, MostRays / 2> Points()
{
  std::array<SobolPoint, MostRays / 2> points{};
  for (std::uint32_t i = 0; i < points.size(); ++i)
  {
    points[i] = SobolPointAt(i);
  }
  return points;
}

Ray RayFromFacet(const Scene& scene, std::uint32_t facet, const SobolPoint& point, bool front)
{
  const auto number = [&](unsigned d) { return UnitFloat(OwenScramble(point[d], facet * 8 + d)); };
  const glm::vec2 b = UniformTriangle(number(0), number(1));
  const glm::vec3 barycentric(std::max(0.0f, 1.0f - b.x - b.y), b.x, b.y);
  const glm::vec3& normal = scene.Facets()[facet].normal;
  return { scene.SafeOrigin(facet, barycentric, front),
    ReflectDiffusely(front ? normal : -normal, number(2), number(3)) };
}

/// The mean length of rays from points all over a facet, on the side where that is shorter, or on
/// the front. Those that meet nothing count as `most`. @param rays On both sides, at most MostRays.
float MeanDistance(
  const Scene& scene, std::uint32_t facet, std::size_t rays, float most, bool bothSides)
{
  static const std::array<SobolPoint, MostRays / 2> points = Points();
  std::array<Ray, MostRays> all;
  std::array<Hit, MostRays> hits;
  for (std::size_t i = 0; i < rays; ++i)
  {
    all[i] = RayFromFacet(scene, facet, points[i / 2], i % 2 == 0);
  }
  scene.Intersect(all.data(), hits.data(), rays);
  std::array<float, 2> sums{};
  for (std::size_t i = 0; i < rays; ++i)
  {
    sums[i % 2] += std::min(most, DistanceTo(scene, all[i], hits[i]));
  }
  return (bothSides ? std::min(sums[0], sums[1]) : sums[0]) / (0.5f * static_cast<float>(rays));
}

/// Few for a facet that is no longer than a cell, and as many times more as there will be cells
/// along and across a longer one, whose light depends on their length.
std::size_t RaysFor(float edgeInCells)
{
  const float wanted = static_cast<float>(FewRays) * std::ceil(edgeInCells * edgeInCells);
  return static_cast<std::size_t>(
    std::clamp(wanted, static_cast<float>(FewRays), static_cast<float>(MostRays)));
}

} // namespace

std::vector<float> CellLengths(const Scene& scene, bool bothSides)
{
  const float diagonal = BoundsOf(scene).Diagonal();
  const float longest = PerDiagonal * diagonal;
  std::vector<float> lengths(scene.Facets().size(), longest);
  constexpr std::uint64_t Grain = 16;
  ForEach(
    lengths.size(),
    [&](std::size_t f)
    {
      // A facet that is nearly as short as a useful cell needs no rays.
      constexpr float Short = 1.0f / 6.0f;
      constexpr float Shortest = 1.0f / 16.0f;
      const auto facet = static_cast<std::uint32_t>(f);
      const float edge = LongestEdge(scene, facet);
      if (edge > Short * longest)
      {
        const float distance =
          MeanDistance(scene, facet, RaysFor(edge / longest), diagonal, bothSides);
        lengths[f] = std::max(Shortest * longest, std::min(longest, PerDistance * distance));
      }
    },
    Grain);
  return lengths;
}

} // namespace PhotonTransport
