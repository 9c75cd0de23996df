// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/openings/SeenOpening.h"
#include "PhotonTransport/openings/Opening.h"

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace PhotonTransport;

namespace
{

/// The rectangle [-0.4, 0.6] x [-0.3, 0.2] in the plane z = 0, inwards -z, as an L with its notch
/// filled: three triangles of unlike sizes and two that make a square.
Opening Rectangle()
{
  const glm::vec3 a(-0.4f, -0.3f, 0), b(0.6f, -0.3f, 0), c(0.6f, 0.2f, 0), d(-0.4f, 0.2f, 0),
    e(0.1f, -0.1f, 0);
  return MakeOpening(
    { { a, e, b }, { b, e, c }, { c, e, d }, { d, e, a } }, { 0, 0, -1 }, OpeningKind::Hole);
}

/// The solid angle of the rectangle's part in a quarter plane of a point below the plane, and the
/// same for cosine-weighted light: both in closed form by corners, with signs.
double AngleOfCorner(double x, double y, double h)
{
  return std::atan(x * y / (h * std::sqrt(x * x + y * y + h * h)));
}

template <typename OfCorner>
double OfRectangle(const glm::dvec3& from, const OfCorner& corner)
{
  const double x0 = -0.4 - from.x, x1 = 0.6 - from.x, y0 = -0.3 - from.y, y1 = 0.2 - from.y;
  const double h = -from.z;
  return corner(x1, y1, h) - corner(x0, y1, h) - corner(x1, y0, h) + corner(x0, y0, h);
}

/// View factor times pi from an element parallel to the rectangle to the corner's rectangle (J.
/// Howell, "A Catalog of Radiation Heat Transfer Configuration Factors", B-4).
double CosineOfCorner(double x, double y, double h)
{
  const double a = std::sqrt(h * h + x * x), b = std::sqrt(h * h + y * y);
  return 0.5 * (x / a * std::atan(y / a) + y / b * std::atan(x / b));
}

} // namespace

TEST(SeenOpening, HasTheSolidAngleAndTheCosineIntegral)
{
  const Opening opening = Rectangle();
  EXPECT_NEAR(opening.Area(), 0.5, 1e-6);
  constexpr int Strata = 64;
  for (const glm::vec3 from :
    { glm::vec3(0.1f, 0.0f, -0.4f), glm::vec3(0.5f, 0.1f, -0.01f), glm::vec3(-1.5f, 2.0f, -0.7f),
      glm::vec3(10.0f, -20.0f, -30.0f), glm::vec3(0.1f, -0.1f, -1e-4f) })
  {
    const SeenOpening seen(opening, from);
    const double angle = OfRectangle(from, AngleOfCorner);
    EXPECT_NEAR(seen.SolidAngle(), angle, 1e-6 * angle + 1e-12);
    double sum = 0.0, cosines = 0.0, squares = 0.0;
    for (int i = 0; i < Strata * Strata; ++i)
    {
      const OpeningSample sample = seen.Sample((static_cast<float>(i % Strata) + 0.5f) / Strata,
        (static_cast<float>(i / Strata) + 0.5f) / Strata);
      const glm::vec3 place = from + sample.distance * sample.direction;
      EXPECT_NEAR(place.z, 0.0f, 1e-6f * (1.0f + sample.distance));
      EXPECT_GT(place.x, -0.4f - 1e-5f);
      EXPECT_LT(place.y, 0.2f + 1e-5f);
      sum += sample.weight;
      const double value = double{ sample.weight } * sample.direction.z;
      cosines += value;
      squares += value * value;
    }
    constexpr double Number = Strata * Strata;
    // A stratified mean errs by no more than one of as many random samples; 4 standard errors.
    const double mean = cosines / Number;
    const double error = std::sqrt(std::max(0.0, squares / Number - mean * mean) / Number);
    EXPECT_NEAR(sum / Number, angle, 2e-3 * angle);
    const double cosine = OfRectangle(from, CosineOfCorner);
    EXPECT_NEAR(mean, cosine, 4.0 * error + 1e-4 * cosine);
  }
}

TEST(SeenOpening, IsUniformBySolidAngle)
{
  // Shares of the samples in the four quarters around a point in front are as their solid angles.
  const Opening opening = Rectangle();
  const glm::vec3 from(0.3f, 0.05f, -0.15f);
  const SeenOpening seen(opening, from);
  constexpr int Strata = 256;
  double counts[2][2] = {};
  for (int i = 0; i < Strata * Strata; ++i)
  {
    const OpeningSample sample = seen.Sample((static_cast<float>(i % Strata) + 0.5f) / Strata,
      (static_cast<float>(i / Strata) + 0.5f) / Strata);
    ++counts[sample.direction.x > 0.0f][sample.direction.y > 0.0f];
  }
  const double x[2] = { 0.7, 0.3 }, y[2] = { 0.35, 0.15 };
  for (int i = 0; i < 2; ++i)
  {
    for (int j = 0; j < 2; ++j)
    {
      // Strata that a border cuts are counted to one side: each is about as long as 2 Strata.
      EXPECT_NEAR(counts[i][j] / (Strata * Strata),
        AngleOfCorner(x[i], y[j], 0.15) / seen.SolidAngle(), 2.0 * 2.0 / Strata);
    }
  }
}

TEST(SeenOpening, IsNotSeenFromOutsideOrFromItsPlane)
{
  const Opening opening = Rectangle();
  for (const float z : { 0.0f, 1e-3f, 2.0f })
  {
    const SeenOpening seen(opening, { 0.2f, 0.0f, z });
    EXPECT_EQ(seen.SolidAngle(), 0.0);
    EXPECT_EQ(seen.Sample(0.3f, 0.6f).weight, 0.0f);
  }
  // Beside it, close to its plane: finite, and small.
  const SeenOpening grazing(opening, { 3.0f, 0.0f, -1e-6f });
  EXPECT_LT(grazing.Sample(0.3f, 0.6f).weight, 1e-6f);
  EXPECT_GE(grazing.Sample(0.3f, 0.6f).weight, 0.0f);
}

TEST(SeenOpening, IsCrossedByTheRaysTowardsIt)
{
  const Openings openings({ Rectangle() });
  const glm::vec3 from(0.9f, 0.5f, -0.3f);
  const SeenOpening seen(openings.List()[0], from);
  constexpr int Strata = 32;
  for (int i = 0; i < Strata * Strata; ++i)
  {
    const OpeningSample sample = seen.Sample((static_cast<float>(i % Strata) + 0.5f) / Strata,
      (static_cast<float>(i / Strata) + 0.5f) / Strata);
    const Ray outwards{ from, sample.direction };
    const auto crossing = openings.FirstCrossing(outwards, false);
    ASSERT_TRUE(crossing);
    EXPECT_EQ(crossing->opening, 0u);
    EXPECT_NEAR(crossing->distance, sample.distance, 1e-6f);
    EXPECT_FALSE(openings.FirstCrossing(outwards, true));
    EXPECT_FALSE(openings.FirstCrossing(outwards, false, 0.999f * sample.distance));
    const Ray back{ from + 2.0f * sample.distance * sample.direction, -sample.direction };
    EXPECT_TRUE(openings.FirstCrossing(back, true));
    EXPECT_FALSE(openings.FirstCrossing({ from, -sample.direction }, false));
  }
  EXPECT_FALSE(openings.FirstCrossing({ { 0.7f, 0.0f, -1.0f }, { 0, 0, 1 } }, false));
  EXPECT_FALSE(openings.FirstCrossing({ { 0.0f, 0.0f, -1.0f }, { 1, 0, 0 } }, false));
}

TEST(SeenOpening, HasNoGapsBetweenItsTriangles)
{
  const Openings openings({ Rectangle() });
  const Opening& opening = openings.List()[0];
  for (const glm::vec3 from : { glm::vec3(0.11f, -0.07f, -0.4f), glm::vec3(0.7f, 0.33f, -1.3f) })
  {
    for (const Opening::Triangle& t : opening.triangles)
    {
      for (int i = 0; i < 1000; ++i) // along the edges that two triangles share
      {
        const glm::vec3 to = t[1] + (static_cast<float>(i) / 1000.0f) * (t[0] - t[1]);
        EXPECT_TRUE(openings.FirstCrossing({ from, glm::normalize(to - from) }, false));
      }
    }
  }
}

TEST(SeenOpening, PointsAreUniformByArea)
{
  const Opening opening = Rectangle();
  constexpr int Strata = 256;
  glm::dvec2 mean(0.0), square(0.0);
  for (int i = 0; i < Strata * Strata; ++i)
  {
    const glm::dvec2 p(opening.PointAt((static_cast<float>(i % Strata) + 0.5f) / Strata,
      (static_cast<float>(i / Strata) + 0.5f) / Strata));
    mean += p / double{ Strata * Strata };
    square += p * p / double{ Strata * Strata };
  }
  // Midpoints of strata of width w err by some w^2 where they are not cut, and by w at the borders
  // between triangles, of which there are few.
  constexpr double Error = 2.0 / Strata;
  EXPECT_NEAR(mean.x, 0.1, Error);
  EXPECT_NEAR(mean.y, -0.05, Error);
  EXPECT_NEAR(square.x, 0.01 + 1.0 / 12.0, Error);
  EXPECT_NEAR(square.y, 0.0025 + 0.25 / 12.0, Error);
}
