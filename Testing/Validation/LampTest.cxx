// SPDX-License-Identifier: BSD-3-Clause
// Direct light against closed forms.
#include "Comparison.h"
#include "Shapes.h"
#include "TracedMap.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <cmath>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

constexpr double Pi = 3.14159265358979323846;

Surface Floor(int cells)
{
  return Shapes::Rectangle({ -1, -1, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, cells);
}

TracedMap Traced(const Scene& scene, const Lamp& lamp, Sampling sampling)
{
  TraceSettings settings;
  settings.sampling = sampling;
  return TracedMap(scene, lamp, settings, 2'000'000);
}

/// The error must be what the standard error says: the mean of error^2 equals the mean of SE^2 in
/// expectation. With V vertices and 8 replicates the quotient spreads by sqrt(2/V + 2/(7 V)); the
/// vertices share photons, so V counts half.
void ExpectErrorIsNoise(const Comparison& comparison, std::size_t vertices)
{
  const double spread = std::sqrt((2.0 + 2.0 / 7.0) / (0.5 * static_cast<double>(vertices)));
  EXPECT_NEAR(comparison.squaredError / comparison.squaredNoise, 1.0, 4.0 * spread);
}

/// Share of the lamp's light that lands on the surface, whose every photon ends at its first hit.
double CaughtShare(const Surface& surface, const Lamp& lamp)
{
  const Scene scene(surface);
  const TracedMap map = Traced(scene, lamp, Sampling::Random);
  return static_cast<double>(map.balance.absorbed) / static_cast<double>(map.balance.emitted);
}

/// A share p of N independent photons spreads by sqrt(p (1 - p) / N); 4 of that.
double ShareTolerance(double share)
{
  return 4.0 * std::sqrt(share * (1.0 - share) / 2e6);
}

} // namespace

// E = I cos(theta) / d^2 for each kind of point-like lamp, vertex by vertex.
class PointLikeLamp : public testing::TestWithParam<Sampling>
{
};
INSTANTIATE_TEST_SUITE_P(Validation, PointLikeLamp,
  testing::Values(Sampling::Random, Sampling::Sobol),
  [](const auto& instance) { return instance.param == Sampling::Random ? "Random" : "Sobol"; });

TEST_P(PointLikeLamp, FollowsTheInverseSquareLaw)
{
  const Surface floor = Floor(20);
  const Scene scene(floor);
  const glm::dvec3 position(0.3, -0.2, 0.7);
  const glm::dvec3 axis = glm::normalize(glm::dvec3(0.2, 0.1, -1.0));
  const double flux = 1000.0;
  const double halfAngle = 1.1;
  const double exponent = 3.0;
  const double spotIntensity =
    flux * (exponent + 1.0) / (2.0 * Pi * (1.0 - std::pow(std::cos(halfAngle), exponent + 1.0)));

  const auto expectIntensity = [&](const Lamp& lamp, const auto& intensity)
  {
    const std::vector<double> exact = RingMeans(floor,
      [&](const glm::dvec3& point, const glm::dvec3& normal)
      {
        const glm::dvec3 ray = point - position;
        const double distance = glm::length(ray);
        return intensity(glm::dot(ray, axis) / distance) * std::max(0.0, -glm::dot(ray, normal)) /
          (distance * distance * distance);
      });
    const TracedMap map = Traced(scene, lamp, GetParam());
    ExpectErrorIsNoise(
      Compare(scene, map.front.direct, map.front.standardError, exact), exact.size());
  };
  expectIntensity(PointLamp{ position, flux }, [&](double) { return flux / (4.0 * Pi); });
  expectIntensity(LambertianPointLamp{ position, axis, flux },
    [&](double cosine) { return flux / Pi * std::max(0.0, cosine); });
  expectIntensity(SpotLamp{ position, axis, halfAngle, exponent, flux },
    [&](double cosine)
    { return cosine >= std::cos(halfAngle) ? spotIntensity * std::pow(cosine, exponent) : 0.0; });
}

// A spot over a disk that it overshines: the share within the angle beta.
TEST(Spot, FluxWithinAnAngle)
{
  for (const double exponent : { 0.0, 2.0, 20.0 })
  {
    const double edge = std::pow(std::cos(1.2), exponent + 1.0);
    const double height = 1.5;
    const double within = std::pow(std::cos(std::atan(1.0 / height)), exponent + 1.0);
    const double share = (1.0 - within) / (1.0 - edge);
    const SpotLamp spot{ { 0, 0, height }, { 0, 0, -1 }, 1.2, exponent, 1.0 };
    // A disk of 720 corners misses 1 - sin(a)/a = 1.3e-5 of its area.
    EXPECT_NEAR(
      CaughtShare(Shapes::Disk(1.0, 0.0, 720, 1, true), spot), share, ShareTolerance(share) + 2e-5);
  }
}

// View factor of two unit squares, parallel, one apart (Howell, catalog C-11).
TEST(ViewFactor, OfParallelSquares)
{
  const double share = 2.0 / Pi *
    (std::log(std::sqrt(2.0 * 2.0 / 3.0)) + 2.0 * std::sqrt(2.0) * std::atan(1.0 / std::sqrt(2.0)) -
      2.0 * std::atan(1.0));
  EXPECT_NEAR(share, 0.1998, 1e-4);
  const Surface receiver = Shapes::Rectangle({ -0.5, -0.5, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 4);
  EXPECT_NEAR(CaughtShare(receiver, RectangleLamp{ { 0, 0, 1 }, { 0, 0, -1 }, 1.0, 1.0, 5.0 }),
    share, ShareTolerance(share));
  const Surface lamp =
    Shapes::WithExitance(Shapes::Rectangle({ -0.5, -0.5, 1 }, { 0, 1, 0 }, { 1, 0, 0 }, 3), 100.0f);
  EXPECT_NEAR(
    CaughtShare(Shapes::Together(receiver, lamp), EmittingFacets{}), share, ShareTolerance(share));
}

// View factor of two unit squares at a right angle with a common edge (Howell, catalog C-14).
TEST(ViewFactor, OfPerpendicularSquares)
{
  const double share = 1.0 / Pi *
    (2.0 * std::atan(1.0) - std::sqrt(2.0) * std::atan(1.0 / std::sqrt(2.0)) +
      0.25 * std::log(4.0 / 3.0 * 0.75 * 0.75));
  EXPECT_NEAR(share, 0.2000, 1e-4);
  const Surface receiver = Shapes::Rectangle({ 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, 4);
  EXPECT_NEAR(CaughtShare(receiver, RectangleLamp{ { 0, 0.5, 0.5 }, { 1, 0, 0 }, 1.0, 1.0, 5.0 }),
    share, ShareTolerance(share));
}

// View factor of two coaxial unit disks, one radius apart (Howell, catalog C-41).
TEST(ViewFactor, OfCoaxialDisks)
{
  const double x = 3.0; // 1 + (1 + R^2) / R^2 with R = r / h = 1
  const double share = 0.5 * (x - std::sqrt(x * x - 4.0));
  EXPECT_NEAR(CaughtShare(Shapes::Disk(1.0, 0.0, 720, 3, true),
                DiskLamp{ { 0, 0, 1 }, { 0, 0, -1 }, 1.0, 5.0 }),
    share, ShareTolerance(share) + 2e-5);
}

// Parallel light on a tilted plane: E = E_perpendicular cos(theta), everywhere and without noise
// beyond that of the photons' places.
TEST(Parallel, LightsAPlaneEvenly)
{
  const Surface floor = Floor(10);
  const Scene scene(floor);
  const glm::dvec3 direction(1.0, 0.5, -0.7);
  const double exact = 800.0 * 0.7 / glm::length(direction);
  const TracedMap map = Traced(scene, ParallelLight{ direction, 800.0 }, Sampling::Random);
  ExpectErrorIsNoise(Compare(scene, map.front.direct, map.front.standardError,
                       std::vector<double>(floor.points.size(), exact)),
    floor.points.size());
}

// Light from all sides gives pi L everywhere. Where a facet is tilted by a against the smooth
// surface FacetRatio registers only (1 + cos a) / 2 of it; VertexNormalised all of it.
TEST(WholeSky, IsSeenWholeByVertexNormalisedOnly)
{
  const Scene scene(Shapes::Icosphere(1, Facing::Outward));
  const std::vector<double> exact(scene.Vertices().size(), Pi * 100.0);
  TraceSettings settings;
  const auto mean = [&](Registration registration)
  {
    settings.registration = registration;
    const TracedMap map(scene, UniformSky{ { 0, 0, 1 }, 100.0, true }, settings, 4'000'000);
    return AreaMean(scene, map.front.direct) / (Pi * 100.0);
  };
  // Mean of (1 + cos a) / 2 over the facets.
  const Surface surface = Shapes::Icosphere(1, Facing::Outward);
  const std::vector<double> ring = RingMeans(surface,
    [](const glm::dvec3& point, const glm::dvec3& normal)
    { return 0.5 * (1.0 + glm::dot(glm::normalize(point), normal)); });
  const double expected = AreaMean(scene, ring);
  // 4e6 photons, all of which would have to be independent: 4 / sqrt(4e6).
  EXPECT_NEAR(mean(Registration::FacetRatio), expected, 0.002);
  EXPECT_NEAR(mean(Registration::VertexNormalised), 1.0, 0.002);
  EXPECT_LT(expected, 0.993);
}
