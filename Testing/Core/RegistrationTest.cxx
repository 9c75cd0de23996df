// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/geometry/Frame.h"
#include "PhotonTransport/registration/Registrar.h"
#include "PhotonTransport/sampling/PhotonSample.h"
#include "PhotonTransport/sampling/Warps.h"

#include "Shapes.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

const glm::vec3 Middle(1.0f / 3.0f);

template <Registration RegistrationKind>
glm::vec3 WeightsOf(const Scene& scene, const RegisteredPlace& place, const glm::vec3& facetNormal,
  const glm::vec3& towards)
{
  const Four weights = HitWeights<RegistrationKind>(scene, place, facetNormal, towards);
  return { weights[0], weights[1], weights[2] };
}

float Total(const glm::vec3& weights)
{
  return weights.x + weights.y + weights.z;
}

} // namespace

TEST(FixedPoint, KeepsWeightsToTheLastPromisedBit)
{
  for (const float weight : { 0.0f, 0x1p-28f, 0.1f, 1.0f, 16.0f, 1024.0f })
  {
    EXPECT_NEAR(FromFixedPoint(ToFixedPoint(weight)), double{ weight }, 0x1p-29);
  }
  EXPECT_EQ(FromCoarseFixedPoint(ToCoarseFixedPoint(0x1p20f)), 0x1p20);
}

// On a flat surface with its own normals nothing is to be compensated.
TEST(HitWeights, AreBarycentricOnAFlatSurface)
{
  const Scene scene(Shapes::Rectangle(glm::dvec3(0.0), { 1, 0, 0 }, { 0, 1, 0 }, 3));
  PhotonSequence sample({ 1, 0, Sampling::Random }, 0);
  for (int i = 0; i < 1000; ++i, sample.Advance())
  {
    const glm::vec3 towards = CosineHemisphere(sample.Emission(0), sample.Emission(1));
    for (const Facet& facet : scene.Facets())
    {
      const glm::vec3 b(0.2f, 0.3f, 0.5f);
      const auto ratio =
        WeightsOf<Registration::FacetRatio>(scene, { facet.vertices, b }, facet.normal, towards);
      const auto vertex = WeightsOf<Registration::VertexNormalised>(
        scene, { facet.vertices, b }, facet.normal, towards);
      EXPECT_EQ(
        (WeightsOf<Registration::Flat>(scene, { facet.vertices, b }, facet.normal, towards)), b);
      for (int corner = 0; corner < 3; ++corner)
      {
        EXPECT_NEAR(ratio[corner], b[corner], 1e-5f);
        EXPECT_NEAR(vertex[corner], b[corner], 1e-5f);
      }
    }
  }
}

// Formula (2): m is the quotient of the two cosines.
TEST(HitWeights, FacetRatioIsTheQuotientOfCosines)
{
  const Scene scene(Shapes::Icosphere(1, Facing::Outward));
  const Facet& facet = scene.Facets()[0];
  // At the facet's middle the smooth normal is the facet's; tilt by hand at a corner.
  const glm::vec3 corner(1.0f, 0.0f, 0.0f);
  const glm::vec3 smooth = scene.Vertices()[facet.vertices.x].normal;
  const glm::vec3 towards = glm::normalize(facet.normal + 0.5f * smooth);
  const float m = glm::dot(towards, smooth) / glm::dot(towards, facet.normal);
  EXPECT_NEAR(Total(WeightsOf<Registration::FacetRatio>(
                scene, { facet.vertices, corner }, facet.normal, towards)),
    m, 1e-5f);
  EXPECT_GT(std::fabs(m - 1.0f), 0.01f);
}

// Where the fast path may be taken it equals the walk round the ring.
TEST(ShownArea, FastPathEqualsTheRing)
{
  const Scene scene(Shapes::UvSphere(16, 8, Facing::Outward));
  PhotonSequence sample({ 2, 0, Sampling::Random }, 0);
  int fast = 0;
  for (int i = 0; i < 2000; ++i, sample.Advance())
  {
    const glm::vec3 towards = UniformSphere(sample.Emission(0), sample.Emission(1));
    for (std::uint32_t v = 0; v < scene.Vertices().size(); ++v)
    {
      const Vertex& vertex = scene.Vertices()[v];
      if (glm::dot(towards, vertex.normal) >= vertex.sinTilt)
      {
        ++fast;
        EXPECT_NEAR(ShownArea(scene, v, towards), glm::dot(towards, vertex.shownArea), 1e-6f);
      }
    }
  }
  EXPECT_GT(fast, 10000);
}

// With n_i along a_i the weight is at most 1 / |a_i|, in units of A_i.
TEST(HitWeights, VertexNormalisedIsBoundedWhereNormalsFollowTheRing)
{
  Surface surface = Shapes::Icosphere(2, Facing::Outward);
  surface.normals.assign(surface.points.size(), glm::dvec3(0.0)); // the scene takes the ring's
  const Scene scene(surface);
  PhotonSequence sample({ 3, 0, Sampling::Random }, 0);
  for (int i = 0; i < 2000; ++i, sample.Advance())
  {
    const glm::vec3 towards = UniformSphere(sample.Emission(0), sample.Emission(1));
    for (const Facet& facet : scene.Facets())
    {
      if (glm::dot(towards, facet.normal) <= 0.0f)
      {
        continue;
      }
      const auto w = WeightsOf<Registration::VertexNormalised>(
        scene, { facet.vertices, Middle }, facet.normal, towards);
      for (int corner = 0; corner < 3; ++corner)
      {
        const Vertex& vertex = scene.Vertices()[facet.vertices[corner]];
        const float cosine = glm::dot(towards, vertex.normal);
        // Numerator and denominator are each rounded to a few 2^-24.
        const float rounding = 8.0f * 0x1p-24f / std::max(cosine, 1e-3f);
        const float bound = Middle[corner] / glm::length(vertex.shownArea);
        if (cosine > 1e-3f)
        {
          EXPECT_LE(w[corner], bound * (1.0f + rounding));
        }
      }
    }
  }
}

namespace
{

/// Mean of min(m, bound)^2 over hits of light from all sides at a point of a coarse sphere's facet,
/// m the compensating factor: the integral of cos/pi over the hemisphere, by the midpoint rule in
/// azimuth and in the logarithm of the cosine.
template <Registration RegistrationKind>
double SecondMoment(const Scene& scene, const glm::vec3& barycentric, float bound)
{
  const Facet& facet = scene.Facets()[0];
  const Frame frame(facet.normal);
  constexpr int Rings = 4000;
  constexpr int Around = 64;
  constexpr double Decades = 11.5; // cosines down to 1e-5
  double sum = 0.0;
  for (int i = 0; i < Rings * Around; ++i)
  {
    const double cosine = std::exp(-Decades * (i / Around + 0.5) / Rings);
    const double azimuth = 6.283185307179586 * (i % Around + 0.5) / Around;
    const double sine = std::sqrt(1.0 - cosine * cosine);
    const glm::vec3 towards =
      frame.ToWorld(glm::dvec3(sine * std::cos(azimuth), sine * std::sin(azimuth), cosine));
    const double m = std::min(bound,
      Total(WeightsOf<RegistrationKind>(
        scene, { facet.vertices, barycentric }, facet.normal, towards)));
    sum += m * m * 2.0 * cosine * cosine * Decades / (Rings * Around);
  }
  return sum;
}

} // namespace

// With light from all sides FacetRatio's factor has no second moment. Under a bound W
// it grows by the same step each time W is multiplied by 8, without end; a step is sin^2(a)/2
// ln(8), a the tilt of the smooth normal. VertexNormalised's has one: no step.
TEST(HitWeights, OnlyFacetRatioLacksAVariance)
{
  const Scene scene(Shapes::Icosphere(0, Facing::Outward));
  const glm::vec3 barycentric(0.6f, 0.3f, 0.1f);
  const Facet& facet = scene.Facets()[0];
  glm::vec3 smooth(0.0f);
  for (int corner = 0; corner < 3; ++corner)
  {
    smooth += barycentric[corner] * scene.Vertices()[facet.vertices[corner]].normal;
  }
  const double cosTilt = glm::dot(glm::normalize(smooth), facet.normal);
  const double step = 0.5 * (1.0 - cosTilt * cosTilt) * std::log(8.0);
  constexpr auto Ratio = SecondMoment<Registration::FacetRatio>;
  for (const float bound : { 16.0f, 128.0f })
  {
    // m = cos(a) + sin(a) cos(phi) / cos(theta): the first term adds a part in bound, twice.
    EXPECT_NEAR(Ratio(scene, barycentric, 8.0f * bound) - Ratio(scene, barycentric, bound), step,
      step * 2.0 / bound);
  }
  constexpr auto Vertex = SecondMoment<Registration::VertexNormalised>;
  EXPECT_EQ(Vertex(scene, barycentric, 1024.0f), Vertex(scene, barycentric, 16.0f));
}

// The back of a surface is the front of the surface turned round.
TEST(HitWeights, TreatBothSidesAlike)
{
  const Scene outward(Shapes::Icosphere(1, Facing::Outward));
  const Scene inward(Shapes::Icosphere(1, Facing::Inward));
  for (std::size_t f = 0; f < outward.Facets().size(); ++f)
  {
    const Facet& out = outward.Facets()[f];
    const Facet& in = inward.Facets()[f];
    const glm::vec3 towards = glm::normalize(glm::vec3(0.3f, 0.2f, -0.1f) - out.normal);
    const auto back = WeightsOf<Registration::VertexNormalised>(
      outward, { out.vertices, Middle }, out.normal, -towards);
    const auto front = WeightsOf<Registration::VertexNormalised>(
      inward, { in.vertices, Middle }, in.normal, towards);
    EXPECT_NEAR(Total(back), Total(front), 1e-5f);
  }
}

// Grazing light on a coarse sphere: what the bound cuts off is counted, nothing is lost or
// infinite.
TEST(Registrar, CutsAtTheBoundAndReportsTheRest)
{
  const Scene scene(Shapes::Icosphere(0, Facing::Outward));
  const std::uint32_t f = 0;
  const Facet& facet = scene.Facets()[f];
  const glm::vec3 along = Frame(facet.normal).tangent;
  const glm::vec3 barycentric(1.0f, 0.0f, 0.0f);
  const glm::vec3 smooth = scene.Vertices()[facet.vertices.x].normal;
  const glm::vec3 lean = glm::dot(along, smooth) > 0.0f ? along : -along;
  const Ray ray{ glm::vec3(0.0f), -glm::normalize(lean + 0.001f * facet.normal) };
  const float m = glm::dot(-ray.direction, smooth) / glm::dot(-ray.direction, facet.normal);
  ASSERT_GT(m, 100.0f);

  IlluminationSums sums(scene.Vertices().size(), false);
  const float startWeight = 1.0f;
  const Registrar<Registration::FacetRatio, false> registrar(scene, 16.0f, sums, &startWeight);
  registrar(ray, { f, barycentric }, true, PhotonOrigin());
  EXPECT_NEAR(FromFixedPoint(sums.front[facet.vertices.x].direct), 16.0, 1e-4);
  EXPECT_NEAR(FromCoarseFixedPoint(sums.cutByWeightBound.front()), m - 16.0, 1e-3 * m);
  EXPECT_EQ(sums.front[facet.vertices.x].hits, 1u);
}
