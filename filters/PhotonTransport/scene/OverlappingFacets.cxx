// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/OverlappingFacets.h"

#include "PhotonTransport/scene/Outline.h"
#include "PhotonTransport/scene/PlaneTriangle.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace PhotonTransport
{
namespace
{

/// Groups of so few facets are looked through pair by pair.
constexpr std::size_t Few = 16;

/// Facets of a group that face about the same way.
struct Bundle
{
  glm::vec3 normal;
  std::vector<std::uint32_t> facets;
};

/// Facets with nearly the same normal are together in at least one bundle.
std::vector<Bundle> BundlesOf(
  const std::vector<FacetPlane>& planes, const PlaneMember* first, const PlaneMember* last)
{
  constexpr float Joins = 0.9f;
  constexpr float AtHome = 0.95f; // who is at home is joined by all that face the same way
  std::vector<Bundle> bundles;
  for (; first != last; ++first)
  {
    const glm::vec3& normal = planes[first->facet].normal;
    bool atHome = false;
    for (Bundle& bundle : bundles)
    {
      const float cosine = glm::dot(normal, bundle.normal);
      atHome = atHome || cosine > AtHome;
      if (cosine > Joins)
      {
        bundle.facets.push_back(first->facet);
      }
    }
    if (!atHome)
    {
      bundles.push_back({ normal, { first->facet } });
    }
  }
  return bundles;
}

/// Looks for overlaps within one bundle.
class BundleSearch
{
public:
  BundleSearch(const FacetPlaces& places, const Bundle& bundle)
    : Places(places)
    , Axis(BestAxis(bundle.normal))
  {
    this->Triangles.reserve(bundle.facets.size());
    for (const std::uint32_t f : bundle.facets)
    {
      this->Triangles.emplace_back(
        f, this->Corner(f, 0), this->Corner(f, 1), this->Corner(f, 2), this->Axis);
    }
  }

  void Search(Outline& outline, const std::function<void(const FacetOverlap&)>& f) const
  {
    if (this->Triangles.size() <= Few)
    {
      for (std::uint32_t i = 1; i < this->Triangles.size(); ++i)
      {
        for (std::uint32_t j = 0; j < i; ++j)
        {
          this->Report(j, i, f);
        }
      }
    }
    else if (this->AnyMeetAt(outline.TrianglesAt(this->Triangles)))
    {
      std::vector<std::uint32_t> all(this->Triangles.size());
      std::iota(all.begin(), all.end(), 0u);
      TriangleGrid grid(this->Triangles, all);
      for (std::uint32_t i = 1; i < this->Triangles.size(); ++i)
      {
        grid.AnyNear(this->Triangles[i],
          [&](std::uint32_t j)
          {
            if (j < i)
            {
              this->Report(j, i, f);
            }
            return false;
          });
      }
    }
  }

private:
  const glm::vec3& Corner(std::uint32_t facet, int corner) const
  {
    return this->Places.points[this->Places.facets[facet][corner]];
  }

  /// Whether one of the triangles meets any other, in one plane or beside it.
  bool AnyMeetAt(const std::vector<std::uint32_t>& some) const
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
                  this->AreCopies(triangle.facet, this->Triangles[j].facet));
            }))
      {
        return true;
      }
    }
    return false;
  }

  bool AreCopies(std::uint32_t f, std::uint32_t g) const
  {
    const auto has = [&](const glm::vec3& place)
    {
      return this->Corner(g, 0) == place || this->Corner(g, 1) == place ||
        this->Corner(g, 2) == place;
    };
    return has(this->Corner(f, 0)) && has(this->Corner(f, 1)) && has(this->Corner(f, 2));
  }

  /// Calls f if two triangles overlap. @param i, j In ascending order.
  void Report(
    std::uint32_t i, std::uint32_t j, const std::function<void(const FacetOverlap&)>& f) const
  {
    const PlaneTriangle& one = this->Triangles[i];
    const PlaneTriangle& other = this->Triangles[j];
    const glm::vec3& normal = this->Places.planes[one.facet].normal;
    if (glm::any(glm::lessThan(one.high, other.low)) ||
      glm::any(glm::lessThan(other.high, one.low)) ||
      !(glm::dot(normal, this->Places.planes[other.facet].normal) > SameSheet))
    {
      return;
    }
    const bool copies = this->AreCopies(one.facet, other.facet);
    if (copies || Meet(one, other))
    {
      const CommonPart common = Intersection(one, other);
      if (copies || (common.area > 0.0 && this->AreTogether(one, other, common)))
      {
        const double cosine = std::fabs(double{ normal[this->Axis] });
        f({ one.facet, other.facet, common.area / cosine, copies });
      }
    }
  }

  /// Whether two facets' planes are one where they have a part in common.
  bool AreTogether(
    const PlaneTriangle& one, const PlaneTriangle& other, const CommonPart& common) const
  {
    const glm::dvec3 a(this->Corner(one.facet, 0)), b(this->Corner(other.facet, 0));
    const glm::dvec3 m = this->ExactNormal(one.facet), n = this->ExactNormal(other.facet);
    const double corners = double{ CornerGap } * double{ std::max(one.reach, other.reach) };
    const int u = (this->Axis + 1) % 3, v = (this->Axis + 2) % 3, w = this->Axis;
    return std::all_of(common.corners.begin(), common.corners.end(),
      [&](const glm::dvec2& p)
      {
        const double first = a[w] - (m[u] * (p.x - a[u]) + m[v] * (p.y - a[v])) / m[w];
        const double second = b[w] - (n[u] * (p.x - b[u]) + n[v] * (p.y - b[v])) / n[w];
        const double reach = std::max({ std::fabs(p.x), std::fabs(p.y), std::fabs(first) });
        return std::fabs(first - second) * std::fabs(m[w]) <= double{ SheetGap } * reach + corners;
      });
  }

  glm::dvec3 ExactNormal(std::uint32_t facet) const
  {
    const glm::dvec3 a(this->Corner(facet, 0));
    return glm::normalize(
      glm::cross(glm::dvec3(this->Corner(facet, 1)) - a, glm::dvec3(this->Corner(facet, 2)) - a));
  }

  const FacetPlaces& Places;
  int Axis;
  std::vector<PlaneTriangle> Triangles;
};

} // namespace

void ForEachOverlap(const FacetPlaces& places, const std::function<void(const FacetOverlap&)>& f)
{
  Outline outline(places.points, places.facets);
  ForEachGroup(places.groups,
    [&](const PlaneMember* first, const PlaneMember* last)
    {
      for (const Bundle& bundle : BundlesOf(places.planes, first, last))
      {
        if (bundle.facets.size() > 1)
        {
          BundleSearch(places, bundle).Search(outline, f);
        }
      }
    });
}

} // namespace PhotonTransport
