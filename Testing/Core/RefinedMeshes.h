// SPDX-License-Identifier: BSD-3-Clause
// Refined meshes, and what tests want to know of them.
#pragma once

#include "Shapes.h"

#include "PhotonTransport/refinement/Refinement.h"

#include <glm/vec3.hpp>

#include <cstddef>
#include <tuple>
#include <vector>

namespace RefinedMeshes
{

using PhotonTransport::RefinedMesh;
using PhotonTransport::RefinementLimits;
using PhotonTransport::Surface;
using PhotonTransport::TriangleMesh;

/// The limits by which tracing refines: parts of an arc turn by 7 degrees at most.
extern const RefinementLimits Fine;

TriangleMesh MeshOf(const Surface& surface);
RefinedMesh Refined(const Surface& surface, const RefinementLimits& limits = Fine);

/// A point as a key.
using Place = std::tuple<double, double, double>;

/// How many edges, as pieces of space, do not have as many facets that run along them one way as
/// the other way. A closed mesh has none.
std::size_t OpenEdges(const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& facets);
std::size_t OpenEdges(const RefinedMesh& mesh);

/// In how many places facets of a refined mesh meet otherwise than the facets they are parts of:
/// along an edge as many run each way as along the edge it is a part of, and along one inside a
/// facet one each way.
std::size_t Gaps(const Surface& surface, const RefinedMesh& mesh);

double Volume(const RefinedMesh& mesh);
glm::dvec3 AreaVector(const std::vector<glm::dvec3>& points, const glm::uvec3& facet);
/// How many parts face away from the facets that they are parts of.
std::size_t TurnedParts(const Surface& surface, const RefinedMesh& mesh);

/// Of radius 1, on z = 0. Each surface has points of its own at the rims, as VTK's filters make
/// them.
Surface CappedCylinder(int around, double height);

} // namespace RefinedMeshes
