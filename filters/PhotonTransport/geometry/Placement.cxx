// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/geometry/Placement.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace PhotonTransport
{
namespace
{

struct Box
{
  glm::dvec3 low{ std::numeric_limits<double>::max() };
  glm::dvec3 high{ std::numeric_limits<double>::lowest() };

  // Halves first: the sum or difference of two huge coordinates could overflow.
  glm::dvec3 Centre() const { return 0.5 * this->low + 0.5 * this->high; }
  glm::dvec3 Half() const { return 0.5 * this->high - 0.5 * this->low; }
};

double Largest(const glm::dvec3& v)
{
  return std::max({ v.x, v.y, v.z });
}

Box BoundsOf(const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& facets)
{
  Box box;
  for (const glm::uvec3& facet : facets)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      box.low = glm::min(box.low, points[facet[corner]]);
      box.high = glm::max(box.high, points[facet[corner]]);
    }
  }
  return box;
}

/// A facet's place, and how much it asks for fine coordinates there.
struct Detail
{
  glm::dvec3 place; ///< One of its corners.
  double weight;    ///< (extent of the scene / its longest edge)^2.
};

/// Smaller facets count as if they were of this size, relative to the scene's extent, lest a single
/// one outweighs all others.
constexpr double SmallestDetail = 0x1p-14;

std::vector<Detail> DetailsOf(
  const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& facets, double extent)
{
  std::vector<Detail> details;
  details.reserve(facets.size());
  for (const glm::uvec3& facet : facets)
  {
    // In units of the extent: no square overflows.
    const glm::dvec3 a = points[facet.x] / extent, b = points[facet.y] / extent,
                     c = points[facet.z] / extent;
    const double longest = std::sqrt(
      std::max({ glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c) }));
    if (longest > 0.0)
    {
      const double size = std::max(longest, SmallestDetail);
      details.push_back({ points[facet.x], 1.0 / (size * size) });
    }
  }
  return details;
}

double WeightOf(std::vector<Detail>::const_iterator first, std::vector<Detail>::const_iterator last)
{
  double weight = 0.0;
  for (; first != last; ++first)
  {
    weight += first->weight;
  }
  return weight;
}

glm::dvec3 WeightedMean(const std::vector<Detail>& details)
{
  const double all = WeightOf(details.begin(), details.end());
  glm::dvec3 mean(0.0);
  for (const Detail& detail : details)
  {
    mean += detail.weight / all * detail.place;
  }
  return mean;
}

/// The coordinate at which half of the weight is reached. Reorders the details.
double WeightedMedian(std::vector<Detail>& details, int axis)
{
  const auto before = [axis](const Detail& a, const Detail& b)
  { return a.place[axis] < b.place[axis]; };
  double wanted = 0.5 * WeightOf(details.begin(), details.end());
  auto first = details.begin(), last = details.end();
  while (last - first > 1)
  {
    const auto middle = first + (last - first) / 2;
    std::nth_element(first, middle, last, before);
    const double lower = WeightOf(first, middle);
    if (wanted < lower)
    {
      last = middle;
    }
    else
    {
      wanted -= lower;
      first = middle;
    }
  }
  return first->place[axis];
}

/// Rounding that facets suffer, relative to their size, with the origin there.
double RoundingAbout(const glm::dvec3& centre, const std::vector<Detail>& details, double extent)
{
  double sum = 0.0;
  for (const Detail& detail : details)
  {
    sum += detail.weight * (Largest(glm::abs(0.5 * detail.place - 0.5 * centre)) / extent);
  }
  return sum;
}

/// The origin's best place: the middle of the box, or the median of the details where that serves
/// them much better. A small building on a large site need not stand in the site's middle.
glm::dvec3 BestCentre(const Box& box, const std::vector<glm::dvec3>& points,
  const std::vector<glm::uvec3>& facets, double extent)
{
  const glm::dvec3 middle = box.Centre();
  std::vector<Detail> details = DetailsOf(points, facets, extent);
  if (details.empty())
  {
    return middle;
  }
  const double rounding = RoundingAbout(middle, details, extent);
  // Most scenes are done here: where the median is much better, the mean is at least somewhat.
  constexpr double SomewhatBetter = 0.6, MuchBetter = 0.25;
  if (RoundingAbout(WeightedMean(details), details, extent) > SomewhatBetter * rounding)
  {
    return middle;
  }
  glm::dvec3 median;
  for (int axis = 0; axis < 3; ++axis)
  {
    median[axis] = WeightedMedian(details, axis);
  }
  return RoundingAbout(median, details, extent) < MuchBetter * rounding ? median : middle;
}

} // namespace

Placement FitPlacement(const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& facets)
{
  const Box box = BoundsOf(points, facets);
  Placement placement;
  placement.centre = box.Centre();
  const double half = Largest(box.Half());
  if (half > 0.0)
  {
    placement.centre = BestCentre(box, points, facets, half);
    const glm::dvec3 quarters =
      glm::max(0.5 * box.high - 0.5 * placement.centre, 0.5 * placement.centre - 0.5 * box.low);
    int exponent = 0;
    const double mantissa = std::frexp(Largest(quarters), &exponent); // in [0.5, 1)
    placement.scale = std::ldexp(1.0, mantissa > 0.5 ? -exponent - 1 : -exponent);
  }
  return placement;
}

} // namespace PhotonTransport
