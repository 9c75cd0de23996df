// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/adaptive/AdaptiveMesh.h"
#include "PhotonTransport/adaptive/LightSamples.h"
#include "PhotonTransport/adaptive/PlaceReceivers.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace PhotonTransport
{

/// Samples of light that meshes over one surface share.
struct SharedSamples
{
  LightSamples light;
  std::unordered_map<std::uint64_t, std::uint32_t> middles; ///< By the samples at both ends.
};

/// A mesh over a surface, and the light at its points and at the middles of its edges.
class LitMesh
{
public:
  using Marks = AdaptiveMesh::Marks;
  /// What a mesh is made of. All must outlive it.
  struct Parts
  {
    const Surface& surface;
    const PlaceReceivers& receivers;
    const std::vector<double>& lengths; ///< [facet of the surface]
    SharedSamples& samples;             ///< The first ones are those of the surface's points.
  };

  explicit LitMesh(const Parts& parts);

  const AdaptiveMesh& Mesh() const { return this->Refined; }
  const std::vector<std::uint32_t>& SampleOfPoint() const { return this->Samples; }
  /// The least of the lengths of the facets of an edge.
  double LengthOf(std::size_t edge) const { return this->Lengths[edge]; }

  static constexpr std::uint32_t NoSample = 0xffffffffu;
  /// At the middle of a point pair; NoSample if light was not received there.
  std::uint32_t MiddleOf(const PointPair& pair) const;

  /// Receives light at the middles of edges where it was not yet. @return Whether it was done.
  bool ReceiveMiddles(
    const Marks& ofEdges, const GatherPass& pass, const GatherPass::Report& report);

  /// [edge] By how much linear interpolation misses the light at the middle, lx; see
  /// LightSamples::Miss. 0 where it is not known.
  std::vector<double> Misses(double tolerance, const LightSamples::Floor& darkest) const;

  /// @param marks Closed; light is known at the middles. @return See AdaptiveMesh::Halved.
  std::vector<std::uint32_t> Halve(const Marks& marks);

private:
  void PlacesOfMiddle(std::uint32_t pair, std::vector<PlaceOnFacet>& places) const;
  void MeasureEdges();

  Parts From;
  AdaptiveMesh Refined;
  std::vector<std::uint32_t> Samples; ///< [point]
  std::vector<double> Lengths;        ///< [edge]
};

} // namespace PhotonTransport
