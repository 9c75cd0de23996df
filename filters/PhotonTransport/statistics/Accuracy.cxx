// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/statistics/Accuracy.h"

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{
namespace
{

double Quantile(std::vector<double>& values, double share)
{
  if (values.empty())
  {
    return 0.0;
  }
  const auto rank = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

/// The p of error ~ photons^-p, from the last fourfold growth: 1/2 for independent photons, up to 1
/// where Sobol points pay.
double FallingPower(const Accuracy& now, const std::vector<Accuracy>& earlier)
{
  constexpr double Independent = 0.5;
  constexpr double Best = 1.0;
  const auto before = std::find_if(earlier.rbegin(), earlier.rend(),
    [&](const Accuracy& row) { return row.photons <= now.photons / 4; });
  if (before == earlier.rend() || !(before->relativeError > 0.0))
  {
    return Independent;
  }
  const double growth = static_cast<double>(now.photons) / static_cast<double>(before->photons);
  return std::clamp(
    std::log(before->relativeError / now.relativeError) / std::log(growth), Independent, Best);
}

/// Of the standard error, by area. The squares are of ratios, which neither vanish nor overflow
/// where the light is very weak or very strong.
double RelativeRms(
  const IlluminationMap& map, const std::vector<double>& areas, double meanIlluminance)
{
  double sumOfAreas = 0.0;
  double sumOfSquares = 0.0;
  for (std::size_t v = 0; v < areas.size(); ++v)
  {
    const double ratio = map.standardError[v] / meanIlluminance;
    sumOfAreas += areas[v];
    sumOfSquares += areas[v] * ratio * ratio;
  }
  return std::sqrt(sumOfSquares / sumOfAreas);
}

} // namespace

void MeasureErrors(Accuracy& accuracy, const IlluminationMap& map, const std::vector<double>& areas)
{
  double sumOfAreas = 0.0;
  double flux = 0.0;
  std::vector<double> relative;
  relative.reserve(areas.size());
  for (std::size_t v = 0; v < areas.size(); ++v)
  {
    const double total = map.direct[v] + map.indirect[v];
    sumOfAreas += areas[v];
    flux += areas[v] * total;
    if (total > 0.0)
    {
      relative.push_back(map.standardError[v] / total);
    }
  }
  // No hit yet: nothing is known, and 0 would end a run that has a target.
  accuracy.relativeError = flux > 0.0 ? RelativeRms(map, areas, flux / sumOfAreas) : 1.0;
  accuracy.medianRelativeError = Quantile(relative, 0.5);
  accuracy.percentile95RelativeError = Quantile(relative, 0.95);
}

void PredictCost(Accuracy& accuracy, const std::vector<Accuracy>& earlier, double target)
{
  const double growth =
    std::pow(accuracy.relativeError / target, 1.0 / FallingPower(accuracy, earlier));
  accuracy.predictedPhotons = static_cast<double>(accuracy.photons) * std::max(1.0, growth);
  accuracy.predictedSeconds = accuracy.seconds * std::max(1.0, growth);
}

} // namespace PhotonTransport
