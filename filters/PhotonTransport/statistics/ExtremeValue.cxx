// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/statistics/ExtremeValue.h"

#include "PhotonTransport/geometry/Pi.h"
#include "PhotonTransport/sampling/Philox.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numeric>

namespace PhotonTransport
{
namespace
{

/// Of w; each is used with both signs.
constexpr std::size_t Draws = 32;
/// No normal number of NormalNumbers is larger: sqrt(2 ln 2^32).
constexpr double LargestNormal = 6.67;
/// Standard errors that are added to the values among which the least is found.
constexpr double Caution = 5.0;

/// Four independent normal numbers, by Box and Muller's method.
std::array<double, 4> NormalNumbers(std::uint64_t point, std::uint32_t block)
{
  constexpr std::uint32_t Stream = 0x45787472u;
  const std::array<std::uint32_t, 4> bits =
    Philox({ static_cast<std::uint32_t>(point), static_cast<std::uint32_t>(point >> 32), block, 0 },
      { 0, Stream });
  std::array<double, 4> numbers{};
  for (std::size_t i = 0; i < 4; i += 2)
  {
    const double length = std::sqrt(-2.0 * std::log((bits[i] + 1.0) * 0x1p-32));
    const double angle = 2.0 * Pi * bits[i + 1] * 0x1p-32;
    numbers[i] = length * std::cos(angle);
    numbers[i + 1] = length * std::sin(angle);
  }
  return numbers;
}

/// The point whose value is the least, the first one of equals.
class LeastPoint
{
public:
  void Offer(std::size_t point, double value)
  {
    if (value < this->Value)
    {
      this->Point = point;
      this->Value = value;
    }
  }
  std::size_t Point = 0;
  double Value = HUGE_VAL;
};

/// Sums over the halves.
struct Found
{
  double values = 0.0;
  double squaredErrors = 0.0;
  double halves = 0.0;

  void Add(double value, double standardError)
  {
    this->values += value;
    this->squaredErrors += standardError * standardError;
    this->halves += 1.0;
  }
};

double Mean(const GroupValues& groups)
{
  return std::accumulate(groups.begin(), groups.end(), 0.0) / double{ Groups };
}

/// By the spread of the groups.
double StandardErrorOf(const GroupValues& groups)
{
  const double mean = Mean(groups);
  double squares = 0.0;
  for (const double value : groups)
  {
    squares += (value - mean) * (value - mean);
  }
  return std::sqrt(squares / double{ Groups * (Groups - 1) });
}

/// [point] Errors, by the groups where nothing else tells them.
std::vector<double> ErrorsOf(const NoisyValues& noisy)
{
  std::vector<double> errors = noisy.standardErrors;
  if (errors.empty())
  {
    std::transform(
      noisy.groups.begin(), noisy.groups.end(), std::back_inserter(errors), StandardErrorOf);
  }
  return errors;
}

/// Each pair of groups finds a point, and the other pair tells its value.
Found ByGroups(const std::vector<GroupValues>& groups, double sign,
  const std::vector<double>& errors, const std::function<bool()>& goOn)
{
  Found found;
  for (std::size_t a = 0; a < Groups; ++a)
  {
    for (std::size_t b = a + 1; b < Groups && goOn(); ++b)
    {
      LeastPoint least;
      for (std::size_t p = 0; p < groups.size(); ++p)
      {
        const double half = (groups[p][a] + groups[p][b]) / 2.0;
        least.Offer(p, sign * half + Caution * errors[p]);
      }
      const GroupValues& there = groups[least.Point];
      const double others = double{ Groups } * Mean(there) - there[a] - there[b];
      found.Add(others / double{ Groups - 2 }, errors[least.Point]);
    }
  }
  return found;
}

/// The points of which one may become the least by the noise that is added.
std::vector<std::size_t> Candidates(
  const std::vector<double>& values, double sign, const std::vector<double>& errors)
{
  double limit = HUGE_VAL;
  for (std::size_t p = 0; p < values.size(); ++p)
  {
    limit = std::min(limit, sign * values[p] + (Caution + LargestNormal) * errors[p]);
  }
  std::vector<std::size_t> candidates;
  for (std::size_t p = 0; p < values.size(); ++p)
  {
    if (sign * values[p] + (Caution - LargestNormal) * errors[p] <= limit)
    {
      candidates.push_back(p);
    }
  }
  return candidates;
}

Found ByAddedNoise(const std::vector<double>& values, double sign,
  const std::vector<double>& errors, const std::function<bool()>& goOn)
{
  const std::vector<std::size_t> candidates = Candidates(values, sign, errors);
  Found found;
  for (std::uint32_t block = 0; block < Draws / 4 && goOn(); ++block)
  {
    std::array<LeastPoint, 8> least; // [draw and its sign]
    for (const std::size_t p : candidates)
    {
      const std::array<double, 4> numbers = NormalNumbers(p, block);
      for (std::size_t i = 0; i < 8; ++i)
      {
        const double noise = (i % 2 == 0 ? 1.0 : -1.0) * errors[p] * numbers[i / 2];
        least[i].Offer(p, sign * (values[p] + noise) + Caution * errors[p]);
      }
    }
    for (const LeastPoint& one : least)
    {
      const double finding = sign * (one.Value - Caution * errors[one.Point]); // y + s w
      found.Add(2.0 * values[one.Point] - finding, errors[one.Point]);
    }
  }
  return found;
}

} // namespace

Estimate ExtremeValue(const NoisyValues& noisy, Extreme which, const std::function<bool()>& goOn)
{
  const double sign = which == Extreme::Minimum ? 1.0 : -1.0;
  LeastPoint plain;
  for (std::size_t p = 0; p < noisy.values.size(); ++p)
  {
    plain.Offer(p, sign * noisy.values[p]);
  }
  const double extreme = noisy.values[plain.Point];
  if (!noisy.KnowNoise())
  {
    return { extreme, 0.0 };
  }
  const std::vector<double> errors = ErrorsOf(noisy);
  const Found found = noisy.groups.empty() ? ByAddedNoise(noisy.values, sign, errors, goOn)
                                           : ByGroups(noisy.groups, sign, errors, goOn);
  if (found.halves == 0.0) // stopped
  {
    return { extreme, 0.0 };
  }
  const double value = std::max(0.0, found.values / found.halves);
  return { value,
    std::hypot(std::sqrt(found.squaredErrors / found.halves), 0.5 * (value - extreme)) };
}

} // namespace PhotonTransport
