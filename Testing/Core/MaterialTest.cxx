// SPDX-License-Identifier: BSD-3-Clause
// Boundaries of dielectrics, and panes, against the same formulas in double precision.
#include "PhotonTransport/materials/Fresnel.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace PhotonTransport;

namespace
{

/// Rounding of one operation in single precision.
constexpr double Epsilon = 0x1p-24;

constexpr float Indices[] = { 1.0f, 1.1f, 1.33f, 1.52f, 2.42f, 4.0f };

std::vector<float> Cosines()
{
  std::vector<float> cosines{ 1e-6f, 1e-4f, 1e-3f, 1e-2f };
  for (int i = 1; i <= 50; ++i)
  {
    cosines.push_back(0.02f * static_cast<float>(i));
  }
  cosines.back() = 1.0f;
  return cosines;
}

struct Exact
{
  double perpendicular = 1.0, parallel = 1.0, cosine = 0.0;

  Exact(double cosIn, double index)
  {
    const double sine = std::sqrt(1.0 - cosIn * cosIn) / index;
    if (sine < 1.0)
    {
      this->cosine = std::sqrt(1.0 - sine * sine);
      const double s = (cosIn - index * this->cosine) / (cosIn + index * this->cosine);
      const double p = (index * cosIn - this->cosine) / (index * cosIn + this->cosine);
      this->perpendicular = s * s;
      this->parallel = p * p;
    }
  }
};

/// Of a reflectance in single precision. The refracted cosine's square is a difference whose
/// condition is that of c^2 + n^2 - 1; it and the other products are off by 8 roundings at most
/// before the quotient s of difference and sum, so s by 17 and r = s^2 by 34.
double ReflectanceError(double cosIn, double index)
{
  const double difference = std::fabs(cosIn * cosIn + index * index - 1.0);
  const double condition = (cosIn * cosIn + std::fabs(index * index - 1.0)) / difference;
  return Epsilon * (34.0 + 8.0 * condition);
}

} // namespace

TEST(Fresnel, AtNormalIncidence)
{
  for (const float n : Indices)
  {
    const double expected = std::pow((n - 1.0) / (n + 1.0), 2);
    for (const float index : { n, 1.0f / n })
    {
      const FresnelReflectances r(1.0f, index);
      EXPECT_NEAR(r.perpendicular, expected, ReflectanceError(1.0, index)) << index;
      EXPECT_NEAR(r.parallel, expected, ReflectanceError(1.0, index)) << index;
      EXPECT_EQ(r.cosine, 1.0f);
    }
  }
}

TEST(Fresnel, AgreesWithDoublePrecision)
{
  for (const float n : Indices)
  {
    for (const float index : { n, 1.0f / n })
    {
      for (const float cosIn : Cosines())
      {
        const FresnelReflectances r(cosIn, index);
        const Exact exact(cosIn, index);
        const double error = ReflectanceError(cosIn, index);
        EXPECT_NEAR(r.perpendicular, exact.perpendicular, error) << cosIn << ' ' << index;
        EXPECT_NEAR(r.parallel, exact.parallel, error) << cosIn << ' ' << index;
      }
    }
  }
}

TEST(Fresnel, ReflectsNoParallelLightAtBrewstersAngle)
{
  for (const float n : { 1.1f, 1.52f, 2.42f, 1.0f / 1.52f })
  {
    const double angle = std::atan(double{ n });
    const FresnelReflectances r(static_cast<float>(std::cos(angle)), n);
    EXPECT_LE(r.parallel, std::pow(0.5 * ReflectanceError(std::cos(angle), n), 2)) << n;
    const double s = (1.0 - double{ n } * n) / (1.0 + double{ n } * n);
    EXPECT_NEAR(r.perpendicular, s * s, ReflectanceError(std::cos(angle), n)) << n;
  }
}

TEST(Fresnel, ReflectsEverythingBeyondTheCriticalAngle)
{
  for (const double n : { 1.1, 1.33, 1.52, 2.42, 4.0 })
  {
    const double critical = std::sqrt(1.0 - 1.0 / (n * n)); // cosine of asin(1 / n)
    const auto index = static_cast<float>(1.0 / n);
    for (const double within : { 0.999, 0.9, 0.5, 1e-3, 0.0 })
    {
      const FresnelReflectances r(static_cast<float>(within * critical), index);
      EXPECT_EQ(r.perpendicular, 1.0f) << n << ' ' << within;
      EXPECT_EQ(r.parallel, 1.0f) << n << ' ' << within;
      EXPECT_EQ(r.cosine, 0.0f) << n << ' ' << within;
    }
    const FresnelReflectances before(static_cast<float>(1.001 * critical), index);
    EXPECT_LT(before.Mean(), 1.0f) << n;
    EXPECT_GT(before.cosine, 0.0f) << n;
  }
}

// r(1 -> n, t) = r(n -> 1, t') with Snell's t': no light is made between a body's two sides.
TEST(Fresnel, IsReciprocal)
{
  for (const float n : Indices)
  {
    for (const float cosIn : Cosines())
    {
      const FresnelReflectances in(cosIn, n);
      const FresnelReflectances out(in.cosine, 1.0f / n);
      // The refracted cosine is handed on rounded: r at a difference of two roundings in c'^2.
      const double condition = 1.0 / std::max(1e-30, Exact(in.cosine, 1.0 / n).cosine);
      const double error = ReflectanceError(cosIn, n) + ReflectanceError(in.cosine, 1.0f / n) +
        4.0 * Epsilon * condition;
      EXPECT_NEAR(in.perpendicular, out.perpendicular, error) << cosIn << ' ' << n;
      EXPECT_NEAR(in.parallel, out.parallel, error) << cosIn << ' ' << n;
    }
  }
}

TEST(Fresnel, IndexOneReflectsNothingAtAnyAngle)
{
  for (const float cosIn : Cosines())
  {
    const FresnelReflectances r(cosIn, 1.0f);
    // s is half a difference of roundings over the cosine.
    EXPECT_LE(r.Mean(), 4.0 * Epsilon * Epsilon) << cosIn;
  }
}

TEST(Fresnel, IsSoundAtTheEdges)
{
  for (const float n : Indices)
  {
    for (const float index : { n, 1.0f / n })
    {
      for (const float cosIn : { 0.0f, 1e-45f, 1e-30f, 1e-20f, 1e-7f, 1.0f })
      {
        const FresnelReflectances r(cosIn, index);
        EXPECT_GE(r.Mean(), 0.0f);
        EXPECT_LE(r.Mean(), 1.0f);
        for (const float internal : { 0.0f, 1e-30f, 0.5f, 1.0f })
        {
          const ReflectedAndTransmitted pane = ThinPane({ cosIn, n }, internal);
          EXPECT_GE(pane.reflected, 0.0f);
          EXPECT_GE(pane.transmitted, 0.0f);
          EXPECT_LE(pane.reflected + pane.transmitted, 1.0 + 4.0 * Epsilon);
        }
      }
    }
  }
}

namespace
{

/// R and T are off by 2 dr, with dr above; squares and quotients add 8 roundings, and the body's
/// power 8, as x exp(-x) < 1 bounds what its exponent's rounding does.
double PaneError(double cosIn, double index)
{
  return 2.0 * ReflectanceError(cosIn, index) + 16.0 * Epsilon;
}

} // namespace

// Without absorption: T = (1 - r) / (1 + r) for each polarisation, and R + T = 1.
TEST(ThinPane, OfClearGlassLosesNothing)
{
  for (const float n : Indices)
  {
    for (const float cosIn : Cosines())
    {
      const Exact r(cosIn, n);
      const double transmitted = 0.5 *
        ((1.0 - r.perpendicular) / (1.0 + r.perpendicular) +
          (1.0 - r.parallel) / (1.0 + r.parallel));
      const ReflectedAndTransmitted pane = ThinPane({ cosIn, n }, 1.0f);
      EXPECT_NEAR(pane.transmitted, transmitted, PaneError(cosIn, n)) << cosIn << ' ' << n;
      EXPECT_NEAR(pane.reflected, 1.0 - transmitted, PaneError(cosIn, n)) << cosIn << ' ' << n;
    }
  }
}

// The reflections between the faces, one after the other.
TEST(ThinPane, LosesWhatItsBodyTakesFromEachWayThroughIt)
{
  for (const float n : Indices)
  {
    for (const float cosIn : Cosines())
    {
      for (const float internal : { 0.0f, 0.2f, 0.9f, 0.999f })
      {
        const Exact fresnel(cosIn, n);
        const double body = std::pow(double{ internal }, 1.0 / fresnel.cosine);
        double reflected = 0.0, transmitted = 0.0;
        for (const double r : { fresnel.perpendicular, fresnel.parallel })
        {
          reflected += 0.5 * r;
          double inside = 0.5 * (1.0 - r);
          for (int face = 0; inside > 1e-12; ++face)
          {
            inside *= body; // through the body to the other face
            (face % 2 == 0 ? transmitted : reflected) += inside * (1.0 - r);
            inside *= r;
          }
        }
        const ReflectedAndTransmitted pane = ThinPane({ cosIn, n }, internal);
        EXPECT_NEAR(pane.reflected, reflected, PaneError(cosIn, n)) << cosIn << ' ' << n;
        EXPECT_NEAR(pane.transmitted, transmitted, PaneError(cosIn, n)) << cosIn << ' ' << n;
      }
    }
  }
}

TEST(ThinPane, OfIndexOneOnlyAbsorbs)
{
  for (const float internal : { 0.0f, 0.3f, 0.9f, 1.0f })
  {
    const ReflectedAndTransmitted straight = ThinPane({ 1.0f, 1.0f }, internal);
    EXPECT_EQ(straight.reflected, 0.0f);
    EXPECT_EQ(straight.transmitted, internal);
    const ReflectedAndTransmitted slanted = ThinPane({ 0.5f, 1.0f }, internal); // twice the way
    EXPECT_NEAR(slanted.reflected, 0.0, 4.0 * Epsilon);
    EXPECT_NEAR(slanted.transmitted, internal * internal, 16.0 * Epsilon);
  }
}

TEST(Refract, ObeysSnellsLawInThePlaneOfIncidence)
{
  const glm::vec3 normal = glm::normalize(glm::vec3(0.3f, -0.5f, 0.8f));
  const glm::vec3 across = glm::normalize(glm::cross(normal, glm::vec3(1.0f, 0.2f, 0.0f)));
  for (const float n : Indices)
  {
    for (const float index : { n, 1.0f / n })
    {
      for (const float cosIn : Cosines())
      {
        const FresnelReflectances fresnel(cosIn, index);
        if (!(fresnel.cosine > 0.0f))
        {
          continue;
        }
        const float sinIn = std::sqrt((1.0f - cosIn) * (1.0f + cosIn));
        const glm::vec3 in = sinIn * across - cosIn * normal;
        const glm::vec3 out = Refract(in, normal, cosIn, index, fresnel.cosine);
        // 16 roundings of numbers up to 1 / index, and those of the cosine: see ReflectanceError.
        const double error = 16.0 * Epsilon / std::min(1.0f, index) +
          ReflectanceError(cosIn, index) / std::max(double{ fresnel.cosine }, Epsilon);
        EXPECT_NEAR(glm::length(out), 1.0, 4.0 * Epsilon);
        EXPECT_NEAR(glm::dot(out, across) * index, sinIn, index * error) << cosIn << ' ' << index;
        EXPECT_NEAR(glm::dot(out, normal), -fresnel.cosine, error) << cosIn << ' ' << index;
        EXPECT_NEAR(glm::dot(out, glm::cross(normal, across)), 0.0, error);
        EXPECT_LT(glm::dot(out, normal), 0.0f) << cosIn << ' ' << index;
      }
    }
  }
}
