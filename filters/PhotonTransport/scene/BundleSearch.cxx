// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/BundleSearch.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

namespace PhotonTransport
{
namespace
{

/// Groups of so few facets are looked through pair by pair.
constexpr std::size_t Few = 64;

/// See ForEachOverlap.
constexpr double NearIfSingle = 1024.0;

const glm::vec3& CornerOf(const FacetPlaces& places, std::uint32_t facet, int corner)
{
  return places.points[places.facets[facet].vertices[corner]];
}

/// By how much the data's rounding may widen what a facet has in common with a neighbour. That of a
/// small facet is limited to a part of it, since slivers that it has in common with its neighbours
/// are narrower than itself.
float RoundingOf(const FacetPlaces& places, const PlaneTriangle& triangle)
{
  constexpr double PartOfFacet = 1.0 / 32.0;
  const DataRounding& rounding = places.rounding;
  if (!(rounding.relative > 0.0))
  {
    return 0.0f;
  }
  const glm::dvec2 size(triangle.high - triangle.low);
  glm::dvec3 farthest(0.0);
  for (int corner = 0; corner < 3; ++corner)
  {
    const glm::dvec3 point(CornerOf(places, triangle.facet, corner));
    farthest = glm::max(farthest, glm::abs(point - rounding.origin));
  }
  return static_cast<float>(
    std::min(rounding.relative * glm::length(farthest), PartOfFacet * std::min(size.x, size.y)));
}

PlaneTriangle TriangleOf(const FacetPlaces& places, std::uint32_t facet, int axis)
{
  PlaneTriangle triangle(facet, CornerOf(places, facet, 0), CornerOf(places, facet, 1),
    CornerOf(places, facet, 2), axis);
  triangle.rounding = RoundingOf(places, triangle);
  return triangle;
}

/// Whether two facets have the same corners.
bool AreCopies(const FacetPlaces& places, const PlaneTriangle& one, const PlaneTriangle& other)
{
  if (one.low != other.low || one.high != other.high) // as nearly all
  {
    return false;
  }
  const auto has = [&](const glm::vec3& place)
  {
    return CornerOf(places, other.facet, 0) == place || CornerOf(places, other.facet, 1) == place ||
      CornerOf(places, other.facet, 2) == place;
  };
  return has(CornerOf(places, one.facet, 0)) && has(CornerOf(places, one.facet, 1)) &&
    has(CornerOf(places, one.facet, 2));
}

/// False for nearly all pairs that don't overlap.
bool MayOverlap(const FacetPlaces& places, const PlaneTriangle& one, const PlaneTriangle& other)
{
  return one.low.x <= other.high.x && other.low.x <= one.high.x && one.low.y <= other.high.y &&
    other.low.y <= one.high.y && FaceTheSameWay(places.planes, one.facet, other.facet) &&
    (AreCopies(places, one, other) || Meet(one, other));
}

} // namespace

bool IsPairApart(const FacetPlaces& places, const PlaneMember* first, const PlaneMember* last)
{
  if (last - first != 2 || !FaceTheSameWay(places.planes, first[0].facet, first[1].facet))
  {
    return last - first == 2;
  }
  const int axis = BestAxis(places.planes[first->facet].normal);
  return !MayOverlap(
    places, TriangleOf(places, first[0].facet, axis), TriangleOf(places, first[1].facet, axis));
}

BundleSearch::BundleSearch(const FacetPlaces& places, const Bundle& bundle)
  : Places(places)
  , Axis(BestAxis(bundle.normal))
{
  this->Triangles.reserve(bundle.facets.size());
  for (const std::uint32_t f : bundle.facets)
  {
    this->Triangles.push_back(TriangleOf(places, f, this->Axis));
  }
}

bool BundleSearch::MayHaveAny(Outline& outline) const
{
  if (this->Triangles.size() > Few)
  {
    return this->AnyMeetAt(outline.TrianglesAt(this->Triangles));
  }
  for (std::uint32_t i = 1; i < this->Triangles.size(); ++i)
  {
    for (std::uint32_t j = 0; j < i; ++j)
    {
      if (MayOverlap(this->Places, this->Triangles[j], this->Triangles[i]))
      {
        return true;
      }
    }
  }
  return false;
}

void BundleSearch::ForEach(const std::function<void(const FacetOverlap&)>& f) const
{
  std::vector<std::uint32_t> all(this->Triangles.size());
  std::iota(all.begin(), all.end(), 0u);
  TriangleGrid grid(this->Triangles, all);
  std::vector<std::uint32_t> near;
  for (std::uint32_t i = 1; i < this->Triangles.size(); ++i)
  {
    near.clear();
    grid.AnyNear(this->Triangles[i],
      [&](std::uint32_t j)
      {
        if (j < i)
        {
          near.push_back(j);
        }
        return false;
      });
    std::sort(near.begin(), near.end()); // the same order whatever the grid
    for (const std::uint32_t j : near)
    {
      this->Report(j, i, f);
    }
  }
}

/// Whether one of the triangles meets any other, in one plane or beside it.
bool BundleSearch::AnyMeetAt(const std::vector<std::uint32_t>& some) const
{
  TriangleGrid grid(this->Triangles, some);
  for (std::uint32_t i = 0; i < this->Triangles.size(); ++i)
  {
    const PlaneTriangle& triangle = this->Triangles[i];
    if (grid.AnyNear(triangle,
          [&](std::uint32_t j)
          {
            return j != i &&
              (Meet(triangle, this->Triangles[j]) ||
                AreCopies(this->Places, triangle, this->Triangles[j]));
          }))
    {
      return true;
    }
  }
  return false;
}

/// Calls f if two triangles overlap. @param i, j In ascending order.
void BundleSearch::Report(
  std::uint32_t i, std::uint32_t j, const std::function<void(const FacetOverlap&)>& f) const
{
  const PlaneTriangle& one = this->Triangles[i];
  const PlaneTriangle& other = this->Triangles[j];
  if (!MayOverlap(this->Places, one, other))
  {
    return;
  }
  const bool copies = AreCopies(this->Places, one, other);
  const CommonPart common = Intersection(one, other);
  const glm::vec3& normal = this->Places.planes[one.facet].normal;
  const double cosine = std::fabs(double{ normal[this->Axis] });
  FacetOverlap overlap{ one.facet, other.facet, common.area / cosine, copies, 0.0, 0.0, 0.0 };
  if (copies || (common.area > 0.0 && this->AreNear(one, other, common, overlap)))
  {
    f(overlap);
  }
}

/// Measures how far two facets are apart where they have a part in common.
/// @return Whether that is little.
bool BundleSearch::AreNear(const PlaneTriangle& one, const PlaneTriangle& other,
  const CommonPart& common, FacetOverlap& overlap) const
{
  const glm::dvec3 a(CornerOf(this->Places, one.facet, 0)),
    b(CornerOf(this->Places, other.facet, 0));
  const glm::dvec3 m = this->ExactNormal(one.facet), n = this->ExactNormal(other.facet);
  const FacetPlane& plane = this->Places.planes[one.facet];
  const double corners = double{ CornerGap } * double{ std::max(one.reach, other.reach) } +
    (double{ plane.rounding } + double{ this->Places.planes[other.facet].rounding });
  const int u = (this->Axis + 1) % 3, v = (this->Axis + 2) % 3, w = this->Axis;
  const double upwards = std::copysign(m[w], double{ plane.normal[w] });
  const DataRounding single{ this->Places.rounding.origin, SingleHalfUnit };
  bool isSingle = true;
  overlap.low = std::numeric_limits<double>::max();
  overlap.high = std::numeric_limits<double>::lowest();
  for (const glm::dvec2& p : common.corners)
  {
    const double first = a[w] - (m[u] * (p.x - a[u]) + m[v] * (p.y - a[v])) / m[w];
    const double second = b[w] - (n[u] * (p.x - b[u]) + n[v] * (p.y - b[v])) / n[w];
    const double reach = std::max({ std::fabs(p.x), std::fabs(p.y), std::fabs(first) });
    const double height = (second - first) * upwards;
    overlap.low = std::min(overlap.low, height);
    overlap.high = std::max(overlap.high, height);
    overlap.excess =
      std::max(overlap.excess, std::fabs(height) / (double{ SheetGap } * reach + corners));
    glm::dvec3 place;
    place[u] = p.x;
    place[v] = p.y;
    place[w] = first;
    isSingle = isSingle && std::fabs(height) <= 2.0 * single.Along(m, place);
  }
  return overlap.excess <= (isSingle ? NearIfSingle : MostExcess);
}

glm::dvec3 BundleSearch::ExactNormal(std::uint32_t facet) const
{
  const glm::dvec3 a(CornerOf(this->Places, facet, 0));
  return glm::normalize(glm::cross(glm::dvec3(CornerOf(this->Places, facet, 1)) - a,
    glm::dvec3(CornerOf(this->Places, facet, 2)) - a));
}

} // namespace PhotonTransport
