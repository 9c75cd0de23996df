// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/refinement/MeshEdges.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace PhotonTransport
{

/// What parts of a refined surface must keep to. An edge that does not is halved.
struct RefinementLimits
{
  static constexpr double None = std::numeric_limits<double>::infinity();
  /// Length of an edge at most, in the mesh's unit, > 0.
  double length = None;
  /// Distance at most between the middle of an edge and the curve it stands for, in the mesh's
  /// unit, > 0.
  double sagitta = None;
  /// Angle at most by which the normal turns from end to end of an edge that is curved, radians,
  /// > 0.
  double turn = None;
};

/// The curve of an edge.
struct EdgeCurve
{
  glm::dvec3 offset{ 0.0 }; ///< From the middle of the edge to the curve's; zero: straight.
  double versine = 0.0;     ///< 1 - cos of half the angle by which the normal turns along it.
  int halvings = 0;         ///< How often the edge is halved.
};

/// @param t 0 at `from`, 1 at `to`.
inline glm::dvec3 PointOnCurve(
  const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& offset, double t)
{
  const double s = 1.0 - t;
  return s * from + t * to + 4.0 * s * t * offset;
}

/// The curve that stands for each edge: quadratic, through the edge's ends and through its middle
/// plus an offset. All facets of an edge have the one curve, so no gap opens between them.
class EdgeCurves
{
public:
  /// An edge has 2^10 parts at most.
  static constexpr int MostHalvings = 10;
  /// Where the sagitta is less than this share of the edge, though the normal turns about the edge,
  /// there is nothing to follow.
  static constexpr double Straight = 1e-5;
  /// A facet whose area is less than this share of its longest edge squared has no direction to
  /// speak of.
  static constexpr double LeastSlimness = 1e-9;

  /// All edges whole. @param mesh, edges Must outlive it.
  EdgeCurves(const TriangleMesh& mesh, const MeshEdges& edges);

  /// Halves edges until they keep to limits.
  void Divide(const RefinementLimits& limits);

  const EdgeCurve& operator[](std::uint32_t edge) const { return this->Curves[edge]; }
  void Straighten(std::uint32_t edge, const RefinementLimits& limits);
  /// Curves again what was straightened.
  void Restore();

private:
  glm::dvec3 Along(std::size_t edge) const;
  EdgeCurve CurveByNormals(std::size_t edge) const;
  void Divide(std::size_t edge, const RefinementLimits& limits);

  const TriangleMesh& Mesh;
  const MeshEdges& Edges;
  std::vector<EdgeCurve> Curves;
  std::vector<std::pair<std::uint32_t, EdgeCurve>> Straightened; ///< What was there before.
};

} // namespace PhotonTransport
