// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/refinement/CurvedPatch.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

namespace PhotonTransport
{
namespace
{

/// The edge of the facet on which all the points lie.
template <class... Points>
std::optional<std::size_t> FacetEdgeOf(const Points&... points)
{
  for (int i = 0; i < 3; ++i)
  {
    if (((points[i] == 0.0f) && ...))
    {
      return static_cast<std::size_t>(i);
    }
  }
  return std::nullopt;
}

/// In barycentric coordinates.
const float ShortestEdge = std::ldexp(1.0f, -EdgeCurves::MostHalvings);

bool IsBefore(const glm::dvec3& p, const glm::dvec3& q)
{
  return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
}

} // namespace

CurvedPatch::CurvedPatch(const TriangleMesh& mesh, const MeshEdges& edges, const EdgeCurves& curves,
  const RefinementLimits& limits, std::size_t facet)
  : Limits(limits)
{
  const glm::uvec3& ids = mesh.facets[facet];
  this->Order = { 0, 1, 2 };
  std::sort(this->Order.begin(), this->Order.end(),
    [&](int a, int b) { return IsBefore(mesh.points[ids[a]], mesh.points[ids[b]]); });
  for (std::size_t i = 0; i < 3; ++i)
  {
    const auto side = static_cast<std::size_t>(this->Order[i]);
    const PointPair& pair = edges.Pairs()[edges.PairOf(facet, side)];
    const std::size_t next = (i + 1) % 3;
    this->Corners[i] = mesh.points[ids[this->Order[i]]];
    this->Offsets[i] = curves[pair.edge].offset;
    this->Halvings[i] = curves[pair.edge].halvings;
    const double cosine = 1.0 - curves[pair.edge].versine; // of half the turn
    this->Turns2[i] = 4.0 * (1.0 - cosine * cosine);
    this->From[i] = pair.from == ids[this->Order[next]] ? next : 3 - i - next;
  }
}

FacetTriangle CurvedPatch::InFacet(const FacetTriangle& part) const
{
  FacetTriangle inFacet;
  for (std::size_t corner = 0; corner < 3; ++corner)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      inFacet[corner][this->Order[i]] = part[corner][static_cast<int>(i)];
    }
  }
  if (!this->IsOrdered())
  {
    std::swap(inFacet[1], inFacet[2]);
  }
  return inFacet;
}

glm::dvec3 CurvedPatch::At(const glm::vec3& b) const
{
  return this->AtOrdered({ b[this->Order[0]], b[this->Order[1]], b[this->Order[2]] });
}

glm::dvec3 CurvedPatch::AtOrdered(const glm::vec3& barycentric) const
{
  const glm::dvec3 b(barycentric);
  if (const std::optional<std::size_t> edge = FacetEdgeOf(barycentric))
  {
    // All facets of an edge go along it the same way.
    const std::size_t from = this->From[*edge], to = 3 - *edge - from;
    return PointOnCurve(
      this->Corners[from], this->Corners[to], this->Offsets[*edge], b[static_cast<int>(to)]);
  }
  return b.x * this->Corners[0] + b.y * this->Corners[1] + b.z * this->Corners[2] +
    4.0 *
    (b.y * b.z * this->Offsets[0] + b.z * b.x * this->Offsets[1] + b.x * b.y * this->Offsets[2]);
}

bool CurvedPatch::Halves(const glm::vec3& p, const glm::vec3& q) const
{
  const glm::vec3 way = glm::abs(q - p);
  const float extent = std::max({ way.x, way.y, way.z });
  // An edge inside the facet that all but runs along one of the facet's is halved as that one is:
  // where a short edge stays whole, triangles on it would otherwise be divided without end.
  const std::size_t along = FacetEdgeOf(p, q).value_or(way.x <= std::min(way.y, way.z) ? 0
      : way.y <= way.z                                                                 ? 1
                                                                                       : 2);
  if (way[static_cast<int>(along)] < ShortestEdge)
  {
    return extent > std::ldexp(1.0f, -this->Halvings[along]);
  }
  // From the middle of the edge to the patch there: second differences of a quadratic form.
  const glm::dvec3 d(q - p);
  const auto middle = [&d](const auto& ofEdges)
  { return -(d.y * d.z * ofEdges[0] + d.z * d.x * ofEdges[1] + d.x * d.y * ofEdges[2]); };
  const double length = glm::length(this->AtOrdered(q) - this->AtOrdered(p));
  const double sagitta = glm::length(middle(this->Offsets));
  // Normals in between are linear: their squared differences are such a form, too.
  const double most = 2.0 * std::sin(0.5 * std::min(this->Limits.turn, glm::pi<double>()));
  return length > this->Limits.length || sagitta > this->Limits.sagitta ||
    (middle(this->Turns2) > most * most && sagitta > EdgeCurves::Straight * length);
}

bool CurvedPatch::Turns() const
{
  const glm::dvec3 zero(0.0);
  if (this->Offsets[0] == zero && this->Offsets[1] == zero && this->Offsets[2] == zero)
  {
    return false;
  }
  const glm::dvec3 ab = this->Corners[1] - this->Corners[0];
  const glm::dvec3 ac = this->Corners[2] - this->Corners[0];
  const glm::dvec3 area = this->IsOrdered() ? glm::cross(ab, ac) : glm::cross(ac, ab);
  const double longest = std::max({ glm::length(ab), glm::length(ac), glm::length(ac - ab) });
  bool turns = !(glm::length(area) > EdgeCurves::LeastSlimness * longest * longest);
  const auto look = [&](const FacetTriangle& part)
  {
    const glm::dvec3 a = this->At(part[0]);
    turns =
      turns || !(glm::dot(glm::cross(this->At(part[1]) - a, this->At(part[2]) - a), area) > 0.0);
  };
  this->Subdivide(look);
  return turns;
}

} // namespace PhotonTransport
