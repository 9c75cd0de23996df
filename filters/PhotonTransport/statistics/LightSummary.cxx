// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/statistics/LightSummary.h"

#include "PhotonTransport/geometry/Pi.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace PhotonTransport
{
namespace
{

/// What follows from a map alone, without its noise.
struct Means
{
  enum Kind : std::size_t
  {
    OfPoints,
    OfArea,
    Share,
    Exitance, ///< Mean of reflectance times value.
    Kinds
  };
  std::array<double, Kinds> values{};
};

/// The share of a triangle where a linear function with these values at its corners is at least
/// `target`.
double ShareAtLeast(double target, std::array<double, 3> corners)
{
  std::sort(corners.begin(), corners.end());
  const auto [a, b, c] = corners;
  if (target <= a)
  {
    return 1.0;
  }
  if (target > c)
  {
    return 0.0;
  }
  return target <= b ? 1.0 - (target - a) / (b - a) * ((target - a) / (c - a))
                     : (c - target) / (c - b) * ((c - target) / (c - a));
}

/// Works on one set of facets and target.
class Measure
{
public:
  Measure(const SummarisedFacets& facets, double target)
    : Facets(facets)
    , Area(facets.Area())
    , Target(target)
  {
  }

  /// @param valueOf Called with a point.
  template <typename Value>
  Means Of(std::size_t points, const Value& valueOf) const
  {
    Means means;
    double atTarget = 0.0;
    for (std::size_t p = 0; p < points; ++p)
    {
      means.values[Means::OfPoints] += valueOf(p) / static_cast<double>(points);
      atTarget += valueOf(p) >= this->Target ? 1.0 : 0.0;
    }
    if (!(this->Area > 0.0))
    {
      means.values[Means::OfArea] = means.values[Means::OfPoints];
      means.values[Means::Share] = atTarget / static_cast<double>(points);
      return means;
    }
    for (std::size_t f = 0; f < this->Facets.corners.size(); ++f)
    {
      const glm::uvec3& corners = this->Facets.corners[f];
      const std::array<double, 3> at{ valueOf(corners.x), valueOf(corners.y), valueOf(corners.z) };
      const double share = this->Facets.areas[f] / this->Area;
      const double ofFacet = share * ((at[0] + at[1] + at[2]) / 3.0);
      means.values[Means::OfArea] += ofFacet;
      means.values[Means::Exitance] += this->Facets.reflectance[f] * ofFacet;
      means.values[Means::Share] += share * ShareAtLeast(this->Target, at);
    }
    means.values[Means::Share] = std::min(means.values[Means::Share], 1.0); // it was rounded
    return means;
  }

private:
  const SummarisedFacets& Facets;
  double Area;
  double Target;
};

/// sqrt((g - 1) / g sum (x_g - mean)^2) over the maps that lack one group each.
Means ErrorsByGroups(const NoisyValues& noisy, const Measure& measure)
{
  std::array<Means, Groups> without;
  for (std::size_t g = 0; g < Groups; ++g)
  {
    without[g] = measure.Of(noisy.values.size(),
      [&](std::size_t p)
      {
        const GroupValues& groups = noisy.groups[p];
        const double all = std::accumulate(groups.begin(), groups.end(), 0.0);
        return (all - groups[g]) / double{ Groups - 1 };
      });
  }
  Means errors;
  for (std::size_t kind = 0; kind < Means::Kinds; ++kind)
  {
    double mean = 0.0;
    for (const Means& one : without)
    {
      mean += one.values[kind] / double{ Groups };
    }
    double squares = 0.0;
    for (const Means& one : without)
    {
      squares += (one.values[kind] - mean) * (one.values[kind] - mean);
    }
    errors.values[kind] = std::sqrt(squares * double{ Groups - 1 } / double{ Groups });
  }
  return errors;
}

/// As if all points were one standard error off in the same direction.
Means LargestErrors(const NoisyValues& noisy, const Measure& measure)
{
  const auto shifted = [&](double sign)
  {
    return measure.Of(noisy.values.size(),
      [&](std::size_t p) { return noisy.values[p] + sign * noisy.standardErrors[p]; });
  };
  const Means high = shifted(1.0);
  const Means low = shifted(-1.0);
  Means errors;
  for (std::size_t kind = 0; kind < Means::Kinds; ++kind)
  {
    errors.values[kind] = 0.5 * (high.values[kind] - low.values[kind]);
  }
  return errors;
}

Means ErrorsOf(const NoisyValues& noisy, const Measure& measure)
{
  if (!noisy.groups.empty())
  {
    return ErrorsByGroups(noisy, measure);
  }
  return noisy.KnowNoise() ? LargestErrors(noisy, measure) : Means();
}

Estimate Quotient(const Estimate& part, const Estimate& whole)
{
  if (!(whole.value > 0.0))
  {
    return {};
  }
  const double quotient = part.value / whole.value;
  return { quotient, std::hypot(part.error, quotient * whole.error) / whole.value };
}

} // namespace

double SummarisedFacets::Area() const
{
  return std::accumulate(this->areas.begin(), this->areas.end(), 0.0);
}

LightSummary Summarise(const NoisyValues& noisy, const SummarisedFacets& facets, double target,
  const std::function<bool()>& goOn)
{
  LightSummary summary;
  summary.points = noisy.values.size();
  if (summary.points == 0)
  {
    return summary;
  }
  const Measure measure(facets, target);
  const Means means = measure.Of(summary.points, [&](std::size_t p) { return noisy.values[p]; });
  const Means errors = ErrorsOf(noisy, measure);
  const auto scaled = [&](Means::Kind kind, double factor) {
    return Estimate{ factor * means.values[kind], factor * errors.values[kind] };
  };
  summary.area = facets.Area();
  summary.mean = scaled(Means::OfArea, 1.0);
  summary.meanOfPoints = scaled(Means::OfPoints, 1.0);
  summary.shareAtTarget = scaled(Means::Share, 1.0);
  summary.flux = scaled(Means::OfArea, summary.area);
  summary.luminance = scaled(Means::Exitance, 1.0 / Pi);
  summary.minimum = ExtremeValue(noisy, Extreme::Minimum, goOn);
  summary.maximum = ExtremeValue(noisy, Extreme::Maximum, goOn);
  summary.uniformity = Quotient(summary.minimum, summary.mean);
  summary.diversity = Quotient(summary.minimum, summary.maximum);
  return summary;
}

} // namespace PhotonTransport
