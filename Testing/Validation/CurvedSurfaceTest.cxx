// SPDX-License-Identifier: BSD-3-Clause
// The paper's subject: coarse meshes of curved surfaces against the exact smooth surface.
#include "Comparison.h"
#include "Shapes.h"
#include "TracedMap.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <ostream>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

constexpr double Pi = 3.14159265358979323846;
const glm::dvec3 Slanted(0.3, 0.2, -1.0);

/// E = E_perpendicular (n . l)^+ on a convex surface that nothing shades.
std::vector<double> UnderParallelLight(const Surface& surface, const ParallelLight& light)
{
  std::vector<double> exact;
  for (const glm::dvec3& normal : surface.normals)
  {
    const double cosine = -glm::dot(normal, glm::normalize(light.direction));
    exact.push_back(light.illuminance * std::max(0.0, cosine));
  }
  return exact;
}

/// E = pi L (1 + cos(beta)) / 2, beta the angle between the normal and the zenith.
std::vector<double> UnderHalfSky(const Surface& surface, double luminance)
{
  std::vector<double> exact;
  for (const glm::dvec3& normal : surface.normals)
  {
    exact.push_back(Pi * luminance * 0.5 * (1.0 + normal.z));
  }
  return exact;
}

struct Case
{
  const char* name;
  Surface surface;
  Lamp lamp;
  std::vector<double> exact;
  double largestBias; ///< Of VertexNormalised, as the first prototype measured it.
  std::vector<bool> counts = {};
};

std::ostream& operator<<(std::ostream& os, const Case& c)
{
  return os << c.name;
}

Case Parallel(const char* name, const Surface& surface, const glm::dvec3& direction, double bias)
{
  const ParallelLight light{ direction, 1000.0 };
  return { name, surface, light, UnderParallelLight(surface, light), bias };
}

Case HalfSky(const char* name, const Surface& surface, double bias)
{
  return { name, surface, UniformSky{ { 0, 0, 1 }, 100.0, false }, UnderHalfSky(surface, 100.0),
    bias };
}

std::array<Comparison, 3> CompareRegistrations(const Case& c, std::uint64_t photons)
{
  const Scene scene(c.surface);
  std::array<Comparison, 3> results;
  for (const int kind : { 0, 1, 2 })
  {
    TraceSettings settings;
    settings.registration = static_cast<Registration>(kind);
    const TracedMap map(scene, c.lamp, settings, photons);
    results[static_cast<std::size_t>(kind)] =
      Compare(scene, map.front.direct, map.front.standardError, c.exact, c.counts);
  }
  return results;
}

class CurvedSurface : public testing::TestWithParam<Case>
{
};

} // namespace

INSTANTIATE_TEST_SUITE_P(Validation, CurvedSurface,
  testing::Values(
    Parallel("SphereUnderParallelLight", Shapes::UvSphere(16, 8, Facing::Outward), Slanted, 0.0005),
    Parallel("IcosphereUnderParallelLight", Shapes::Icosphere(2, Facing::Outward), Slanted, 0.0005),
    Parallel(
      "TorusUnderParallelLight", Shapes::Torus(24, 8, Facing::Outward), { 0, 0, -1 }, 0.0008),
    Parallel(
      "TubeUnderParallelLight", Shapes::Tube(12, 1, Facing::Outward), { 1.0, 0.1, 0 }, 0.0006),
    HalfSky("SphereUnderHalfSky", Shapes::UvSphere(16, 8, Facing::Outward), 0.001),
    HalfSky("CapWithRimUnderHalfSky", Shapes::Cap(16, 5, 95.0), 0.001)),
  [](const auto& instance) { return instance.param.name; });

TEST_P(CurvedSurface, VertexNormalisedHasNoBiasFromFacets)
{
  const auto [flat, ratio, vertex] = CompareRegistrations(GetParam(), 4'000'000);
  RecordProperty("bias of Flat", std::to_string(flat.Bias()));
  RecordProperty("bias of FacetRatio", std::to_string(ratio.Bias()));
  RecordProperty("bias of VertexNormalised", std::to_string(vertex.Bias()));
  std::printf("  bias: Flat %.4f, FacetRatio %.4f, VertexNormalised %.5f; its noise %.5f\n",
    flat.Bias(), ratio.Bias(), vertex.Bias(), std::sqrt(vertex.squaredNoise));
  EXPECT_LE(std::sqrt(vertex.squaredNoise), GetParam().largestBias); // or it would hide the bias
  EXPECT_LE(vertex.Bias(), GetParam().largestBias);
  EXPECT_LE(5.0 * vertex.Bias(), ratio.Bias());
  EXPECT_LT(ratio.Bias(), flat.Bias());
}
