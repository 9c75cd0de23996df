// SPDX-License-Identifier: BSD-3-Clause
#include "ValidationCase.h"

#include "Comparison.h"
#include "TracedMap.h"

#include "PhotonTransport/statistics/ReplicateStatistics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numeric>

using namespace PhotonTransport;

namespace
{

constexpr std::uint32_t Runs = 32;

std::string Text(const char* format, double value)
{
  char text[64];
  std::snprintf(text, sizeof(text), format, value);
  return text;
}

/// What was found worst over the quantities of a case.
struct Worst
{
  double deviation = 0.0, standardError = 0.0, ratio = 0.0; ///< The first two over the exact value.

  void Take(double exact, double mean, double error)
  {
    this->deviation = std::max(this->deviation, std::fabs(mean - exact) / exact);
    this->standardError = std::max(this->standardError, error / exact);
    this->ratio = std::max(this->ratio, std::fabs(mean - exact) / error);
  }
};

void Record(const ValidationCase& known, const Worst& worst, double photons)
{
  static int number = 0; // a test may have several cases
  const std::string suffix = std::to_string(++number);
  const auto record = [&](const char* name, const std::string& value)
  { testing::Test::RecordProperty(name + suffix, value); };
  record("case", known.name);
  record("quantities", std::to_string(known.quantities.size()));
  record("exact", Text("%.5g", known.quantities.front().exact));
  record("deviation", Text("%.3f", 100.0 * worst.deviation));
  record("standardError", Text("%.3f", 100.0 * worst.standardError));
  record("ratio", Text("%.1f", worst.ratio));
  record("photons", Text("%.1f", photons * 1e-6));
}

} // namespace

void ExpectExact(const ValidationCase& known)
{
  const Scene scene(known.surface);
  std::vector<ReplicateStatistics> found(known.quantities.size());
  double photons = 0.0;
  for (std::uint32_t run = 0; run < Runs; ++run)
  {
    TraceSettings settings = known.settings;
    settings.seed = 1 + run;
    settings.replicates = 2;
    const TracedMap map(
      scene, known.lighting, settings, static_cast<std::uint64_t>(known.photons / Runs));
    const PhotonBalance& balance = map.balance;
    EXPECT_EQ(balance.emitted, balance.absorbed + balance.escaped + balance.cutOff);
    photons += static_cast<double>(balance.emitted);
    const std::vector<double> total = Total(map.front);
    for (std::size_t q = 0; q < found.size(); ++q)
    {
      const Quantity& quantity = known.quantities[q];
      const std::vector<double>& lux = quantity.indirectOnly ? map.front.indirect : total;
      found[q].Add(std::inner_product(lux.begin(), lux.end(), quantity.weights.begin(), 0.0), 1.0);
    }
  }
  Worst worst;
  for (std::size_t q = 0; q < found.size(); ++q)
  {
    const double exact = known.quantities[q].exact;
    const double mean = found[q].Mean();
    const double error = found[q].StandardError();
    constexpr double Rounding = 1e-6; // of weights, which are floats
    EXPECT_LE(std::fabs(mean - exact), 3.0 * error + Rounding * exact)
      << known.name << ", quantity " << q << ": " << mean << ", exact " << exact;
    EXPECT_LE(error, 0.005 * exact) << known.name << ", quantity " << q;
    worst.Take(exact, mean, error + Rounding * exact);
  }
  Record(known, worst, photons);
}

std::vector<double> IntegralWeights(
  const Surface& surface, const std::vector<bool>& counts, const std::vector<double>& g)
{
  const Scene scene(surface);
  std::vector<double> weights(surface.points.size(), 0.0);
  for (std::size_t v = 0; v < weights.size(); ++v)
  {
    weights[v] = counts[v] ? scene.VertexAreas()[v] * g[v] : 0.0;
  }
  return weights;
}

std::vector<double> PointWeights(const Surface& surface, std::size_t point)
{
  std::vector<double> weights(surface.points.size(), 0.0);
  weights[point] = 1.0;
  return weights;
}
