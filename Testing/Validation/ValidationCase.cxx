// SPDX-License-Identifier: BSD-3-Clause
#include "ValidationCase.h"

#include "Comparison.h"
#include "TracedMap.h"

#include "PhotonTransport/statistics/ReplicateStatistics.h"
#include "PhotonTransport/transport/SkyOpenings.h"

#include <gtest/gtest.h>

#include <algorithm>
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

constexpr double Rounding = 1e-6; ///< Of weights, which are floats; relative.

/// What the runs say of each quantity.
struct Measured
{
  std::vector<ReplicateStatistics> quantities;
  double photons = 0.0;
};

double Deviation(const Quantity& known, const ReplicateStatistics& found)
{
  return std::fabs(found.Mean() - known.exact) / known.exact;
}

double StandardError(const Quantity& known, const ReplicateStatistics& found)
{
  return found.StandardError() / known.exact;
}

/// Deviation in standard errors.
double Ratio(const Quantity& known, const ReplicateStatistics& found)
{
  return Deviation(known, found) / (StandardError(known, found) + Rounding / 3.0);
}

double Largest(const ValidationCase& known, const Measured& measured,
  double (*of)(const Quantity&, const ReplicateStatistics&))
{
  return std::transform_reduce(
    known.quantities.begin(), known.quantities.end(), measured.quantities.begin(), 0.0,
    [](double a, double b) { return std::max(a, b); }, of);
}

void Record(const ValidationCase& known, const Measured& measured)
{
  static int number = 0; // a test may have several cases
  const std::string suffix = std::to_string(++number);
  const auto record = [&](const char* name, const std::string& value)
  { testing::Test::RecordProperty(name + suffix, value); };
  record("case", known.name);
  record("quantities", std::to_string(known.quantities.size()));
  record("exact", Text("%.5g", known.quantities.front().exact));
  record("measured", Text("%.5g", measured.quantities.front().Mean()));
  record("deviation", Text("%.3f", 100.0 * Largest(known, measured, Deviation)));
  record("standardError", Text("%.3f", 100.0 * Largest(known, measured, StandardError)));
  record("ratio", Text("%.1f", Largest(known, measured, Ratio)));
  record("photons", Text(measured.photons < 1e6 ? "%.2f" : "%.1f", measured.photons * 1e-6));
}

Measured Measure(const ValidationCase& known, double photons, std::uint32_t firstSeed)
{
  const Scene scene(known.surface);
  const Openings openings = known.withoutOpenings
    ? Openings()
    : OpeningsToSkies(known.surface, scene, known.lighting, known.settings).openings;
  Measured measured;
  measured.quantities.resize(known.quantities.size());
  for (std::uint32_t run = 0; run < Runs; ++run)
  {
    TraceSettings settings = known.settings;
    settings.seed = firstSeed + run;
    settings.replicates = 2;
    const TracedMap map(
      scene, known.lighting, settings, static_cast<std::uint64_t>(photons / Runs), openings);
    const PhotonBalance& balance = map.balance;
    EXPECT_EQ(balance.emitted,
      balance.absorbed + balance.escaped + balance.cutOff + balance.handedOver + balance.blocked);
    measured.photons += static_cast<double>(balance.emitted);
    const std::vector<double> total = Total(map.front);
    for (std::size_t q = 0; q < known.quantities.size(); ++q)
    {
      const Quantity& quantity = known.quantities[q];
      const std::vector<double>& lux = quantity.indirectOnly ? map.front.indirect : total;
      measured.quantities[q].Add(
        std::inner_product(lux.begin(), lux.end(), quantity.weights.begin(), 0.0), 1.0);
    }
  }
  return measured;
}

} // namespace

void ExpectExact(const ValidationCase& known)
{
  Measured measured = Measure(known, known.photons, 1);
  if (Largest(known, measured, Ratio) > 3.0)
  {
    measured = Measure(known, 4.0 * known.photons, 1 + Runs);
  }
  for (std::size_t q = 0; q < known.quantities.size(); ++q)
  {
    const Quantity& quantity = known.quantities[q];
    const ReplicateStatistics& found = measured.quantities[q];
    EXPECT_LE(Ratio(quantity, found), 3.0)
      << known.name << ", quantity " << q << ": " << found.Mean() << ", exact " << quantity.exact;
    EXPECT_LE(StandardError(quantity, found), 0.005) << known.name << ", quantity " << q;
  }
  Record(known, measured);
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
