// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/statistics/Accuracy.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// The part of the error that falls with the number of photons.
double RelativeNoise(const MapErrors& row)
{
  const double facets = row.relativeFacetError / std::max(row.relativeError, 1e-300);
  return row.relativeError * std::sqrt(std::max(0.0, 1.0 - facets * facets));
}

/// The p of noise ~ photons^-p, from the last fourfold growth: 1/2 for independent photons, up to 1
/// where Sobol points pay.
double FallingPower(const Accuracy& now, const std::vector<Accuracy>& earlier)
{
  constexpr double Independent = 0.5;
  constexpr double Best = 1.0;
  const auto before = std::find_if(earlier.rbegin(), earlier.rend(),
    [&](const Accuracy& row)
    { return row.photons <= now.photons / 4 && row.region.has_value() == now.region.has_value(); });
  if (before == earlier.rend() || !(RelativeNoise(before->Targeted()) > 0.0))
  {
    return Independent;
  }
  const double growth = static_cast<double>(now.photons) / static_cast<double>(before->photons);
  return std::clamp(
    std::log(RelativeNoise(before->Targeted()) / RelativeNoise(now.Targeted())) / std::log(growth),
    Independent, Best);
}

/// Of errors, by area. The squares are of ratios, which neither vanish nor overflow where the light
/// is very weak or very strong.
double RelativeRms(
  const std::vector<double>& errors, const std::vector<double>& areas, double meanIlluminance)
{
  double sumOfAreas = 0.0;
  double sumOfSquares = 0.0;
  for (std::size_t v = 0; v < errors.size(); ++v)
  {
    const double ratio = errors[v] / meanIlluminance;
    sumOfAreas += areas[v];
    sumOfSquares += areas[v] * ratio * ratio;
  }
  return std::sqrt(sumOfSquares / sumOfAreas);
}

} // namespace

MapErrors MeasureErrors(const IlluminationMap& map, const std::vector<double>& areas,
  const std::vector<double>& facetError)
{
  double sumOfAreas = 0.0;
  double flux = 0.0;
  std::vector<double> relative;
  relative.reserve(areas.size());
  for (std::size_t v = 0; v < areas.size(); ++v)
  {
    const double total = map.Total(v);
    sumOfAreas += areas[v];
    flux += areas[v] * total;
    if (total > 0.0 && areas[v] > 0.0)
    {
      relative.push_back(map.standardError[v] / total);
    }
  }
  // No hit yet: nothing is known, and 0 would end a run that has a target.
  MapErrors errors;
  errors.relativeError =
    flux > 0.0 ? RelativeRms(map.standardError, areas, flux / sumOfAreas) : 1.0;
  if (flux > 0.0 && !facetError.empty())
  {
    errors.relativeFacetError = RelativeRms(facetError, areas, flux / sumOfAreas);
    errors.relativeError = std::hypot(errors.relativeError, errors.relativeFacetError);
  }
  errors.medianRelativeError = Quantile(relative, 0.5);
  errors.percentile95RelativeError = Quantile(relative, 0.95);
  return errors;
}

bool FacetsAreTooLarge(const MapErrors& errors, double target)
{
  return errors.relativeFacetError >= std::max(target, RelativeNoise(errors));
}

void PredictCost(Accuracy& accuracy, const std::vector<Accuracy>& earlier, double target)
{
  const MapErrors& errors = accuracy.Targeted();
  const double facets = errors.relativeFacetError / target;
  if (facets >= 1.0)
  {
    accuracy.predictedPhotons = std::numeric_limits<double>::infinity();
    accuracy.predictedSeconds = std::numeric_limits<double>::infinity();
    return;
  }
  const double growth =
    std::pow(RelativeNoise(errors) / (target * std::sqrt(1.0 - facets * facets)),
      1.0 / FallingPower(accuracy, earlier));
  accuracy.predictedPhotons = static_cast<double>(accuracy.photons) * std::max(1.0, growth);
  accuracy.predictedSeconds = accuracy.seconds * std::max(1.0, growth);
}

} // namespace PhotonTransport
