// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/refinement/EdgeCurves.h"

#include "PhotonTransport/refinement/OpenEdges.h"
#include "PhotonTransport/threads/Threads.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace PhotonTransport
{
namespace
{

/// Where the curve of an edge leaves it, as the normals of one facet tell.
struct Rise
{
  glm::dvec3 direction; ///< Unit, normal to the edge.
  double height;        ///< Of the curve's middle over the edge's, in the direction.
  double versine;       ///< See EdgeCurve.
};

/// The rise of an arc that is normal to `n0` and `n1` at its ends: with the chord d of length L and
/// s = (n1 - n0).d / 2L, half the angle it turns by has the sine s, and the height is
/// (L / 2) tan(half that angle) = (L / 2) s / (1 + sqrt(1 - s^2)). It is the quadratic curve of
/// Nagata, "Simple local interpolation of surfaces using normal vectors" (2005), and Vlachos et
/// al., "Curved PN triangles" (2001), but exact at the middle of each circular arc. Nothing if the
/// normals contradict each other or the facet.
/// @param area The facet's area vector.
std::optional<Rise> RiseOf(
  const glm::dvec3& along, const glm::dvec3& n0, const glm::dvec3& n1, const glm::dvec3& area)
{
  const double length = glm::length(along);
  const double tilt0 = glm::dot(n0, area), tilt1 = glm::dot(n1, area);
  if (!(tilt0 * tilt1 > 0.0) || !(glm::length(area) > EdgeCurves::LeastSlimness * length * length))
  {
    return std::nullopt;
  }
  const glm::dvec3 d = along / length;
  const glm::dvec3 sum = n0 + n1;
  const glm::dvec3 across = sum - glm::dot(sum, d) * d;
  const double size = glm::length(across);
  if (!(size > 0.0))
  {
    return std::nullopt;
  }
  const double s = std::clamp(0.5 * glm::dot(n1 - n0, d), -1.0, 1.0);
  const double cosine = std::clamp(glm::dot(n0, n1), -1.0, 1.0);
  return Rise{ across / size, 0.5 * length * s / (1.0 + std::sqrt(1.0 - s * s)),
    1.0 - std::sqrt(0.5 * (1.0 + cosine)) };
}

/// The shortest offset that has all the facets' heights in their directions, as nearly as it can:
/// a round rim between two surfaces becomes round, and a straight one stays straight. It is
/// Nagata's rule for sharp edges.
class OffsetFit
{
public:
  void Add(const Rise& rise)
  {
    this->Directions += glm::outerProduct(rise.direction, rise.direction);
    this->Heights += rise.height * rise.direction;
    this->Number += 1.0;
  }

  glm::dvec3 Offset(double edgeLength) const
  {
    if (this->Heights == glm::dvec3(0.0))
    {
      return glm::dvec3(0.0);
    }
    constexpr double Damping = 1e-4; // gives directions that no facet tells no height
    const glm::dvec3 offset =
      glm::inverse(this->Directions + glm::dmat3(Damping * this->Number)) * this->Heights;
    const double length = glm::length(offset), most = edgeLength / 4.0;
    return length > most ? offset * (most / length) : offset;
  }

private:
  glm::dmat3 Directions{ 0.0 };
  glm::dvec3 Heights{ 0.0 };
  double Number = 0.0;
};

/// A normal at unit length, or zero where it is zero or not finite.
glm::dvec3 Unit(const glm::dvec3& normal)
{
  const double length = glm::length(normal);
  return length > 0.0 && std::isfinite(length) ? normal / length : glm::dvec3(0.0);
}

} // namespace

EdgeCurves::EdgeCurves(const TriangleMesh& mesh, const MeshEdges& edges)
  : Mesh(mesh)
  , Edges(edges)
  , Curves(edges.Number())
{
  if (mesh.normals.empty())
  {
    return;
  }
  ForEach(
    edges.Number(), [&](std::size_t edge) { this->Curves[edge] = this->CurveByNormals(edge); });
  for (const std::uint32_t edge : EdgesWithPointsOnThem(mesh, edges))
  {
    this->Curves[edge] = {};
  }
}

void EdgeCurves::Divide(const RefinementLimits& limits)
{
  ForEach(this->Curves.size(), [&](std::size_t edge) { this->Divide(edge, limits); });
}

void EdgeCurves::Straighten(std::uint32_t edge, const RefinementLimits& limits)
{
  if (this->Curves[edge].offset != glm::dvec3(0.0) || this->Curves[edge].versine != 0.0)
  {
    this->Straightened.emplace_back(edge, this->Curves[edge]);
  }
  this->Curves[edge] = {};
  this->Divide(edge, limits);
}

void EdgeCurves::Restore()
{
  for (const auto& [edge, curve] : this->Straightened)
  {
    this->Curves[edge] = curve;
  }
  this->Straightened.clear();
}

glm::dvec3 EdgeCurves::Along(std::size_t edge) const
{
  const PointPair& pair = this->Edges.FirstPair(edge);
  return this->Mesh.points[pair.to] - this->Mesh.points[pair.from];
}

EdgeCurve EdgeCurves::CurveByNormals(std::size_t edge) const
{
  const glm::dvec3 along = this->Along(edge);
  OffsetFit fit;
  EdgeCurve curve;
  this->Edges.ForEachSide(edge,
    [&](const FacetEdge& side)
    {
      const PointPair& pair = this->Edges.Pairs()[this->Edges.PairOf(side.facet, side.side)];
      const glm::uvec3& ids = this->Mesh.facets[side.facet];
      const glm::dvec3& a = this->Mesh.points[ids.x];
      const glm::dvec3 area =
        0.5 * glm::cross(this->Mesh.points[ids.y] - a, this->Mesh.points[ids.z] - a);
      const std::optional<Rise> rise =
        RiseOf(along, Unit(this->Mesh.normals[pair.from]), Unit(this->Mesh.normals[pair.to]), area);
      if (rise)
      {
        fit.Add(*rise);
        curve.versine = std::max(curve.versine, rise->versine);
      }
    });
  curve.offset = fit.Offset(glm::length(along));
  return curve;
}

void EdgeCurves::Divide(std::size_t edge, const RefinementLimits& limits)
{
  EdgeCurve& curve = this->Curves[edge];
  double length = glm::length(this->Along(edge)), sagitta = glm::length(curve.offset);
  // The sagitta of an arc is its radius times its versine.
  const double versine = 1.0 - std::cos(0.5 * std::min(limits.turn, glm::pi<double>()));
  const double byTurn = curve.versine > versine
    ? std::max(sagitta * versine / curve.versine, Straight * length)
    : RefinementLimits::None;
  const double most = std::min(limits.sagitta, byTurn);
  curve.halvings = 0;
  while (curve.halvings < MostHalvings && (length > limits.length || sagitta > most))
  {
    length *= 0.5;
    sagitta *= 0.25;
    ++curve.halvings;
  }
}

} // namespace PhotonTransport
