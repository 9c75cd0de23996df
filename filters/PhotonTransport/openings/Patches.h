// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/refinement/MeshEdges.h"

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// Facets that hang together by edges and face about alike, beside each other.
struct Patch
{
  std::vector<std::uint32_t> facets;
  bool flat = true;
};

/// Divides some facets into patches, in the order of their first facets.
/// @param facets Those to divide, ascending; those without an area are left out.
/// @param turn Sine of the angle up to which facets of a patch may face otherwise than the first.
/// 0: flat patches only.
std::vector<Patch> PatchesOf(
  const TriangleMesh& mesh, const std::vector<std::uint32_t>& facets, double turn = 0.0);

} // namespace PhotonTransport
