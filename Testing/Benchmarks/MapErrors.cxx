// SPDX-License-Identifier: BSD-3-Clause
#include "MapErrors.h"

#include "Measurement.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace
{

constexpr double MostRelativeError = 0.1;
constexpr double LitLux = 1.0;

double Square(double x)
{
  return x * x;
}

double Root(double meanSquare)
{
  return std::sqrt(std::max(0.0, meanSquare));
}

} // namespace

std::vector<std::size_t> ComparablePoints(const StoredReference& reference, bool onlyLit)
{
  std::vector<std::size_t> points;
  for (std::size_t i = 0; i < reference.estimates.size(); ++i)
  {
    const PointEstimate& e = reference.estimates[i];
    const bool known = e.standardError <= MostRelativeError * e.illuminance;
    if (onlyLit ? known && e.illuminance > LitLux : true)
    {
      points.push_back(i);
    }
  }
  return points;
}

std::vector<std::size_t> InnerPoints(const PhotonTransport::Surface& surface,
  const StoredReference& reference, const std::vector<std::size_t>& points)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> facetsOfEdge;
  for (const glm::uvec3& facet : surface.facets)
  {
    for (int k = 0; k < 3; ++k)
    {
      ++facetsOfEdge[std::minmax({ facet[k], facet[(k + 1) % 3] })];
    }
  }
  std::vector<bool> onBorder(surface.points.size(), false);
  for (const auto& [edge, facets] : facetsOfEdge)
  {
    if (facets == 1)
    {
      onBorder[edge.first] = onBorder[edge.second] = true;
    }
  }
  std::vector<std::size_t> inner;
  std::copy_if(points.begin(), points.end(), std::back_inserter(inner),
    [&](std::size_t i) { return !onBorder[reference.vertices[i]]; });
  return inner;
}

ReferenceQuality QualityOf(const StoredReference& reference, const std::vector<std::size_t>& points)
{
  ReferenceQuality quality;
  const auto count = static_cast<double>(points.size());
  std::vector<double> relative;
  for (const std::size_t i : points)
  {
    const PointEstimate& e = reference.estimates[i];
    quality.mean += e.illuminance / count;
    quality.rms += Square(e.standardError) / count;
    relative.push_back(e.illuminance > 0.0 ? 100.0 * e.standardError / e.illuminance : 0.0);
    quality.relativeRms += Square(relative.back()) / count;
    quality.most = std::max(quality.most, relative.back());
  }
  quality.rms = 100.0 * Root(quality.rms) / quality.mean;
  quality.relativeRms = Root(quality.relativeRms);
  quality.median = Measurement::Median(relative);
  return quality;
}

MapErrors ErrorsOf(const std::vector<MeasuredMap>& maps, const StoredReference& reference,
  const std::vector<std::size_t>& points)
{
  MapErrors errors;
  errors.points = points.size();
  const auto count = static_cast<double>(points.size() * maps.size());
  double mean = 0.0, comparable = 0.0;
  std::vector<double> relative;
  for (const MeasuredMap& map : maps)
  {
    for (const std::size_t i : points)
    {
      const PointEstimate& e = reference.estimates[i];
      const std::uint32_t v = reference.vertices[i];
      const double off = map.lux[v] - e.illuminance;
      const double known = Square(e.standardError);
      mean += e.illuminance / count;
      errors.bias += off / count;
      errors.rms += (off * off - known) / count;
      errors.told += Square(map.standardError[v]) / count;
      if (e.illuminance > 0.0)
      {
        relative.push_back(100.0 * std::fabs(off) / e.illuminance);
        errors.rmsRelative += (off * off - known) / Square(e.illuminance);
      }
      const double told = Square(map.standardError[v]) + known;
      if (told > 0.0)
      {
        comparable += 1.0;
        errors.rmsOfUnits += off * off / told;
        errors.within2 += off * off <= 4.0 * told ? 1.0 : 0.0;
        errors.within3 += off * off <= 9.0 * told ? 1.0 : 0.0;
      }
    }
  }
  errors.bias *= 100.0 / mean;
  errors.rms = 100.0 * Root(errors.rms) / mean;
  errors.told = 100.0 * Root(errors.told) / mean;
  errors.rmsRelative = 100.0 * Root(errors.rmsRelative / static_cast<double>(relative.size()));
  errors.medianRelative = Measurement::Median(relative);
  errors.rmsOfUnits = Root(errors.rmsOfUnits / comparable);
  errors.within2 *= 100.0 / comparable;
  errors.within3 *= 100.0 / comparable;
  return errors;
}
