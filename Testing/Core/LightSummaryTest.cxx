// SPDX-License-Identifier: BSD-3-Clause
// Statistics of noisy maps: closed forms of linear fields, and what errors promise, by simulation.
#include "PhotonTransport/statistics/LightSummary.h"
#include "PhotonTransport/geometry/Pi.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace PhotonTransport;

namespace
{

const auto GoOn = [] { return true; };

NoisyValues WithoutNoise(const std::vector<double>& values)
{
  return { values, {}, {} };
}

/// The right triangle (0, 0), (1, 0), (0, 1) with reflectance 0.6.
SummarisedFacets UnitTriangle()
{
  return { { { 0, 1, 2 } }, { 0.5 }, { 0.6 } };
}

/// A fan of n triangles around a point; the i-th has the area i + 1.
SummarisedFacets Fan(unsigned n)
{
  SummarisedFacets fan;
  for (unsigned i = 0; i < n; ++i)
  {
    fan.corners.emplace_back(0, 1 + i, 2 + i);
    fan.areas.push_back(i + 1.0);
    fan.reflectance.push_back(0.5);
  }
  return fan;
}

/// True values, their noise, and how many estimates of them are wanted.
struct Field
{
  const char* name;
  std::vector<double> values;
  double relativeError;
};

std::vector<Field> Fields()
{
  constexpr std::size_t Points = 500;
  std::vector<double> even(Points, 100.0);
  std::vector<double> bowl;
  std::vector<double> slope;
  std::vector<double> dip(Points, 100.0);
  dip[Points / 2] = 80.0;
  for (std::size_t p = 0; p < Points; ++p)
  {
    const double x = 2.0 * static_cast<double>(p) / (Points - 1) - 1.0;
    bowl.push_back(100.0 * (1.0 + x * x));
    slope.push_back(100.0 * (1.5 + 0.5 * x));
  }
  return { { "even", even, 0.05 }, { "bowl", bowl, 0.05 }, { "slope", slope, 0.05 },
    { "resolved dip", dip, 0.02 }, { "dip lost in noise", dip, 0.1 } };
}

/// A field with normal noise, as four groups or with standard errors.
NoisyValues Noisy(const Field& field, bool groups, std::mt19937& engine)
{
  std::normal_distribution<double> normal;
  NoisyValues noisy;
  for (const double value : field.values)
  {
    const double error = field.relativeError * value;
    GroupValues ofPoint{};
    double mean = 0.0;
    for (double& group : ofPoint)
    {
      group = value + std::sqrt(double{ Groups }) * error * normal(engine);
      mean += group / double{ Groups };
    }
    noisy.values.push_back(mean);
    noisy.standardErrors.push_back(error);
    if (groups)
    {
      noisy.groups.push_back(ofPoint);
    }
  }
  return noisy;
}

/// Mean and its standard error.
struct Trials
{
  double sum = 0.0, squares = 0.0, number = 0.0;
  void Add(double x)
  {
    this->sum += x;
    this->squares += x * x;
    this->number += 1.0;
  }
  double Mean() const { return this->sum / this->number; }
  double Rms() const { return std::sqrt(this->squares / this->number); }
  double ErrorOfMean() const
  {
    const double mean = this->Mean();
    return std::sqrt((this->squares / this->number - mean * mean) / (this->number - 1.0));
  }
};

} // namespace

TEST(LightSummary, LinearFieldsAreIntegratedExactly)
{
  // E = 30 x + 60 y + 10 on the unit triangle: mean 10 + (30 + 60) / 3.
  const LightSummary summary =
    Summarise(WithoutNoise({ 10.0, 40.0, 70.0 }), UnitTriangle(), 40.0, GoOn);
  EXPECT_DOUBLE_EQ(summary.mean.value, 40.0);
  EXPECT_DOUBLE_EQ(summary.flux.value, 20.0);
  EXPECT_DOUBLE_EQ(summary.luminance.value, 0.6 * 40.0 / Pi);
  EXPECT_DOUBLE_EQ(summary.uniformity.value, 0.25);
  EXPECT_DOUBLE_EQ(summary.diversity.value, 1.0 / 7.0);
  EXPECT_DOUBLE_EQ(summary.area, 0.5);
  EXPECT_EQ(summary.points, 3u);
  // E >= 40 is the triangle between (1, 0), (0, 1) and (0, 1/2): half of the whole.
  EXPECT_DOUBLE_EQ(summary.shareAtTarget.value, 0.5);
}

TEST(LightSummary, FacetsCountByTheirAreaAndPointsAlike)
{
  const LightSummary fan =
    Summarise(WithoutNoise({ 0.0, 6.0, 6.0, 12.0 }), Fan(2), 1e9, GoOn); // areas 1 and 2
  EXPECT_DOUBLE_EQ(fan.mean.value, (1.0 * 4.0 + 2.0 * 6.0) / 3.0);
  EXPECT_DOUBLE_EQ(fan.meanOfPoints.value, 6.0);
  EXPECT_DOUBLE_EQ(fan.flux.value, 16.0);
  EXPECT_EQ(fan.shareAtTarget.value, 0.0);
  const LightSummary points = Summarise(WithoutNoise({ 1.0, 2.0, 3.0, 6.0 }), {}, 2.0, GoOn);
  EXPECT_DOUBLE_EQ(points.mean.value, 3.0) << "without facets the mean is that of the points";
  EXPECT_DOUBLE_EQ(points.shareAtTarget.value, 0.75) << "at or above";
  EXPECT_EQ(points.area, 0.0);
  EXPECT_EQ(points.flux.value, 0.0);
  const LightSummary dark = Summarise(WithoutNoise({ 0.0, 0.0 }), {}, 1.0, GoOn);
  EXPECT_EQ(dark.uniformity.value, 0.0) << "and no NaN";
  EXPECT_EQ(Summarise({}, {}, 1.0, GoOn).points, 0u);
}

TEST(LightSummary, ShareAtATargetIsThatOfTheArea)
{
  // E = a + (b - a) x + (c - a) y at the middles of a fine grid of cells.
  const std::vector<std::vector<double>> fields{ { 1.0, 2.0, 5.0 }, { 5.0, 1.0, 2.0 },
    { 3.0, 3.0, 1.0 }, { 3.0, 1.0, 1.0 }, { 2.0, 2.0, 2.0 } };
  for (const std::vector<double>& corners : fields)
  {
    for (const double target : { 0.5, 1.0, 1.3, 2.0, 3.1, 5.0, 5.1 })
    {
      constexpr int Cells = 500;
      double inside = 0.0;
      double all = 0.0;
      for (int i = 0; i < Cells; ++i)
      {
        for (int j = 0; i + j < Cells; ++j)
        {
          const double x = (i + 1.0 / 3.0) / Cells;
          const double y = (j + 1.0 / 3.0) / Cells;
          all += 1.0;
          inside += corners[0] * (1.0 - x - y) + corners[1] * x + corners[2] * y >= target - 1e-12;
        }
      }
      const double share =
        Summarise(WithoutNoise(corners), UnitTriangle(), target, GoOn).shareAtTarget.value;
      // The contour crosses fewer than 2 Cells of the Cells^2 / 2 cells.
      EXPECT_NEAR(share, inside / all, 4.0 / Cells) << target;
    }
  }
}

TEST(LightSummary, ErrorsByGroupsAreThoseOfCorrelatedNoise)
{
  std::mt19937 engine(1);
  std::normal_distribution<double> normal;
  constexpr unsigned Points = 22;
  const SummarisedFacets fan = Fan(Points - 2);
  Trials deviation;
  Trials told;
  for (int trial = 0; trial < 4000; ++trial)
  {
    NoisyValues noisy{ std::vector<double>(Points, 0.0), {}, std::vector<GroupValues>(Points) };
    for (std::size_t g = 0; g < Groups; ++g)
    {
      const double common = 3.0 * normal(engine);
      for (unsigned p = 0; p < Points; ++p)
      {
        noisy.groups[p][g] = 100.0 + common + normal(engine);
        noisy.values[p] += noisy.groups[p][g] / double{ Groups };
      }
    }
    const LightSummary summary = Summarise(noisy, fan, 100.0, GoOn);
    const double d = summary.flux.value - 100.0 * fan.Area();
    deviation.Add(d * d);
    told.Add(summary.flux.error * summary.flux.error);
  }
  const double tolerance = 4.0 * std::hypot(deviation.ErrorOfMean(), told.ErrorOfMean());
  EXPECT_NEAR(told.Mean(), deviation.Mean(), tolerance) << "variance of the flux";
}

TEST(LightSummary, WithoutGroupsErrorsAreTheLargestThatTheyCanBe)
{
  const SummarisedFacets fan = Fan(3);
  const NoisyValues noisy{ { 10.0, 20.0, 30.0, 40.0, 50.0 }, { 1.0, 2.0, 3.0, 4.0, 5.0 }, {} };
  const LightSummary summary = Summarise(noisy, fan, 25.0, GoOn);
  EXPECT_NEAR(summary.mean.error, 0.1 * summary.mean.value, 1e-12)
    << "noise that is 10 % everywhere and moves all points together";
  EXPECT_NEAR(summary.meanOfPoints.error, 3.0, 1e-12);
  NoisyValues shifted = WithoutNoise(noisy.values);
  const auto shareOf = [&](double factor)
  {
    shifted.values = noisy.values;
    for (double& value : shifted.values)
    {
      value *= factor;
    }
    return Summarise(shifted, fan, 25.0, GoOn).shareAtTarget.value;
  };
  EXPECT_NEAR(summary.shareAtTarget.error, 0.5 * (shareOf(1.1) - shareOf(0.9)), 1e-12);
  EXPECT_GT(summary.shareAtTarget.error, 0.0);
  EXPECT_EQ(Summarise(WithoutNoise(noisy.values), fan, 25.0, GoOn).mean.error, 0.0);
}

TEST(ExtremeValue, IsNotBiasedByNoiseAndTellsItsError)
{
  std::mt19937 engine(2);
  for (const bool groups : { true, false })
  {
    for (const Field& field : Fields())
    {
      const double truth = *std::min_element(field.values.begin(), field.values.end());
      Trials deviation;
      Trials plain;
      Trials told;
      for (int trial = 0; trial < 200; ++trial)
      {
        const NoisyValues noisy = Noisy(field, groups, engine);
        const Estimate minimum = ExtremeValue(noisy, Extreme::Minimum, GoOn);
        deviation.Add(minimum.value - truth);
        plain.Add(*std::min_element(noisy.values.begin(), noisy.values.end()) - truth);
        told.Add(minimum.error);
      }
      SCOPED_TRACE(std::string(field.name) + (groups ? ", groups" : ", standard errors"));
      EXPECT_GT(deviation.Mean(), -4.0 * deviation.ErrorOfMean())
        << "on average no lower than it is";
      if (std::string(field.name) == "even")
      {
        EXPECT_LT(deviation.Mean(), 4.0 * deviation.ErrorOfMean())
          << "nor higher, where all are alike";
        EXPECT_LT(plain.Mean(), -2.5 * field.relativeError * truth)
          << "but the plain minimum is low";
      }
      // The root mean square of 200 trials has an error of 1 / sqrt(400).
      EXPECT_LT(deviation.Rms(), told.Rms() * (1.0 + 3.0 / std::sqrt(400.0)))
        << "the error is told";
      RecordProperty(field.name, std::to_string(deviation.Mean()));
    }
  }
}

// Few photons, or a wide blur: a tenth of the points is known to half of the light only.
TEST(ExtremeValue, IsThatOfPointsWhoseLightIsKnown)
{
  constexpr std::size_t Points = 500;
  std::mt19937 engine(4);
  std::normal_distribution<double> normal;
  for (const Extreme which : { Extreme::Minimum, Extreme::Maximum })
  {
    Trials deviation;
    Trials told;
    for (int trial = 0; trial < 50; ++trial)
    {
      NoisyValues noisy;
      for (std::size_t p = 0; p < Points; ++p)
      {
        noisy.standardErrors.push_back(p % 10 == 0 ? 50.0 : 1.0);
        noisy.values.push_back(std::max(0.0, 100.0 + noisy.standardErrors[p] * normal(engine)));
      }
      const Estimate extreme = ExtremeValue(noisy, which, GoOn);
      deviation.Add(extreme.value - 100.0);
      told.Add(extreme.error);
    }
    EXPECT_LT(deviation.Rms(), 3.0) << "of the noise of the other points";
    EXPECT_LT(deviation.Rms(), told.Rms());
  }
}

TEST(ExtremeValue, OfTheMaximumIsThatOfTheMirroredMinimum)
{
  std::mt19937 engine(3);
  const Field slope = Fields()[2];
  Trials deviation;
  Trials plain;
  for (int trial = 0; trial < 200; ++trial)
  {
    const NoisyValues noisy = Noisy(slope, false, engine);
    const Estimate maximum = ExtremeValue(noisy, Extreme::Maximum, GoOn);
    deviation.Add(maximum.value - 200.0);
    plain.Add(*std::max_element(noisy.values.begin(), noisy.values.end()) - 200.0);
  }
  EXPECT_LT(deviation.Mean(), 4.0 * deviation.ErrorOfMean());
  EXPECT_GT(plain.Mean(), 10.0) << "the noise is 10 lx at the maximum";
  const Estimate exact = ExtremeValue({ { 3.0, 9.0, 9.0, 1.0 }, {}, {} }, Extreme::Maximum, GoOn);
  EXPECT_EQ(exact.value, 9.0);
  EXPECT_EQ(exact.error, 0.0);
  const NoisyValues noiseless{ { 3.0, 9.0, 1.0 }, { 0.0, 0.0, 0.0 }, {} };
  EXPECT_EQ(ExtremeValue(noiseless, Extreme::Minimum, GoOn).value, 1.0);
}
