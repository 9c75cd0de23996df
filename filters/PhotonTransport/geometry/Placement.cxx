// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/geometry/Placement.h"

#include "PhotonTransport/threads/Threads.h"

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

  Box& operator+=(const Box& other)
  {
    this->low = glm::min(this->low, other.low);
    this->high = glm::max(this->high, other.high);
    return *this;
  }
};

double Largest(const glm::dvec3& v)
{
  return std::max({ v.x, v.y, v.z });
}

/// What f(first, last) says of facets [first, last), added up in their order, so that the result
/// does not depend on the threads.
template <typename Part, typename F>
Part SumOverFacets(std::size_t facets, const F& f)
{
  constexpr std::size_t Chunk = 8192;
  std::vector<Part> parts((facets + Chunk - 1) / Chunk);
  ForEach(
    parts.size(),
    [&](std::size_t i) { parts[i] = f(i * Chunk, std::min((i + 1) * Chunk, facets)); }, 1);
  Part sum;
  for (const Part& part : parts)
  {
    sum += part;
  }
  return sum;
}

Box BoundsOf(const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& facets)
{
  return SumOverFacets<Box>(facets.size(),
    [&](std::size_t first, std::size_t last)
    {
      Box box;
      for (std::size_t f = first; f < last; ++f)
      {
        for (int corner = 0; corner < 3; ++corner)
        {
          box.low = glm::min(box.low, points[facets[f][corner]]);
          box.high = glm::max(box.high, points[facets[f][corner]]);
        }
      }
      return box;
    });
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

/// The facets of a scene as details.
class Details
{
public:
  Details(
    const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& facets, double extent)
    : Points(points)
    , Facets(facets)
    , Extent(extent)
    , PerExtent(std::min(1.0 / extent, std::numeric_limits<double>::max()))
  {
  }

  /// Without a weight where a facet has no extent.
  Detail Of(std::size_t facet) const
  {
    // In units of the extent: no square overflows.
    const glm::uvec3& ids = this->Facets[facet];
    const glm::dvec3 a = this->Points[ids.x] / this->Extent, b = this->Points[ids.y] / this->Extent,
                     c = this->Points[ids.z] / this->Extent;
    const double longest = std::sqrt(
      std::max({ glm::dot(b - a, b - a), glm::dot(c - b, c - b), glm::dot(a - c, a - c) }));
    const double size = std::max(longest, SmallestDetail);
    return { this->Points[ids.x], longest > 0.0 ? 1.0 / (size * size) : 0.0 };
  }

  /// Those that have a weight.
  std::vector<Detail> All() const
  {
    std::vector<Detail> details;
    details.reserve(this->Facets.size());
    for (std::size_t f = 0; f < this->Facets.size(); ++f)
    {
      const Detail detail = this->Of(f);
      if (detail.weight > 0.0)
      {
        details.push_back(detail);
      }
    }
    return details;
  }

  /// Weights, their product with the place, relative to a centre in extents, and their product with
  /// its largest coordinate, which is the rounding that facets suffer with the origin there.
  struct Moments
  {
    double weights = 0.0;
    glm::dvec3 places{ 0.0 };
    double rounding = 0.0;

    Moments& operator+=(const Moments& other)
    {
      this->weights += other.weights;
      this->places += other.places;
      this->rounding += other.rounding;
      return *this;
    }
  };
  Moments About(const glm::dvec3& centre) const
  {
    return SumOverFacets<Moments>(this->Facets.size(),
      [&](std::size_t first, std::size_t last)
      {
        Moments moments;
        for (std::size_t f = first; f < last; ++f)
        {
          const double weight = this->WeightOf(f);
          const glm::dvec3& corner = this->Points[this->Facets[f].x];
          const glm::dvec3 place = (0.5 * corner - 0.5 * centre) * this->PerExtent;
          moments += { weight, weight * place, weight * Largest(glm::abs(place)) };
        }
        return moments;
      });
  }

private:
  /// The same as in Of but for rounding, in a third of the time.
  double WeightOf(std::size_t facet) const
  {
    const glm::uvec3& ids = this->Facets[facet];
    const glm::dvec3& a = this->Points[ids.x];
    const glm::dvec3 ab = (this->Points[ids.y] - a) * this->PerExtent;
    const glm::dvec3 ac = (this->Points[ids.z] - a) * this->PerExtent;
    const double longest =
      std::max({ glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(ac - ab, ac - ab) });
    return longest > 0.0 ? 1.0 / std::max(longest, SmallestDetail * SmallestDetail) : 0.0;
  }

  const std::vector<glm::dvec3>& Points;
  const std::vector<glm::uvec3>& Facets;
  double Extent;
  double PerExtent;
};

double WeightOf(std::vector<Detail>::const_iterator first, std::vector<Detail>::const_iterator last)
{
  double weight = 0.0;
  for (; first != last; ++first)
  {
    weight += first->weight;
  }
  return weight;
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

/// The origin's best place: the middle of the box, or the median of the details where that serves
/// them much better. A small building on a large site need not stand in the site's middle.
glm::dvec3 BestCentre(const Box& box, const std::vector<glm::dvec3>& points,
  const std::vector<glm::uvec3>& facets, double extent)
{
  const glm::dvec3 middle = box.Centre();
  const Details details(points, facets, extent);
  const Details::Moments aboutMiddle = details.About(middle);
  if (!(aboutMiddle.weights > 0.0))
  {
    return middle;
  }
  // Most scenes are done here: where the median is much better, the mean is at least somewhat.
  constexpr double SomewhatBetter = 0.6, MuchBetter = 0.25;
  const glm::dvec3 mean = middle + extent * (2.0 / aboutMiddle.weights * aboutMiddle.places);
  if (details.About(mean).rounding > SomewhatBetter * aboutMiddle.rounding)
  {
    return middle;
  }
  std::vector<Detail> all = details.All();
  glm::dvec3 median;
  for (int axis = 0; axis < 3; ++axis)
  {
    median[axis] = WeightedMedian(all, axis);
  }
  return details.About(median).rounding < MuchBetter * aboutMiddle.rounding ? median : middle;
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
