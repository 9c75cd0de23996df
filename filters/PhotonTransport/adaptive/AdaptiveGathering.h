// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/adaptive/AdaptiveLimits.h"
#include "PhotonTransport/adaptive/LitMesh.h"
#include "PhotonTransport/adaptive/PlaceReceivers.h"
#include "PhotonTransport/gathering/GatherPass.h"
#include "PhotonTransport/gathering/GatheredMap.h"
#include "PhotonTransport/registration/FacetCells.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace PhotonTransport
{

/// What a refinement starts from. All must outlive it.
struct AdaptiveStart
{
  const Scene& scene;
  const Surface& surface; ///< That of the scene.
  const FacetCells& cells;
  const GatheredMap& front; ///< At the vertices.
  const GatheredMap& back;  ///< Empty if the back is not registered.
};

/// Refines the surface where the light between two points is not what linear interpolation says,
/// level by level. Light is received at the middles of edges. An edge is halved if its middle
/// misses by more than the tolerance and more than noise explains, on one of the sides that are
/// registered. The shadow of a chair on a floor of two triangles would be missed like that, so a
/// mesh of short edges comes first. It is only there to look: the refinement then divides what
/// leads to details that were found, and leaves the rest whole. Rays see the surface as it was.
class AdaptiveGathering
{
public:
  AdaptiveGathering(const AdaptiveStart& start, const AdaptiveLimits& limits);

  /// Refines until all edges keep to the tolerance or are as short as the shortest that are made.
  /// The result has the same bits for any number of threads.
  /// @param report Gets how many points have received light. If it returns false, the level in
  /// work is given up, and the mesh stays as it is. @return Whether there is a mesh: not if it was
  /// stopped before all points of a curved surface had light.
  bool Run(const GatherPass& pass, const GatherPass::Report& report);

  const AdaptiveMesh& Mesh() const { return this->Result->Mesh(); }
  /// The light at the points of the mesh.
  GatheredMap Front() const;
  GatheredMap Back() const;
  /// Whether more facets were wanted than are allowed.
  bool IsFull() const { return this->Full; }
  /// Facets of the largest mesh that was there: that of short edges may be larger than the result.
  std::size_t MostFacets() const { return this->Most; }

private:
  using Marks = AdaptiveMesh::Marks;
  /// An edge that should be halved.
  struct Wish
  {
    bool first;  ///< Before all that are not.
    double miss; ///< By which the light misses, lx.
    double length;
    std::uint32_t edge;
    bool operator<(const Wish& other) const;
  };

  void MeasureFacets();
  void MeasureLight(const GatherPass& pass);
  bool ReceivePoints(const GatherPass& pass, const GatherPass::Report& report);
  bool Probe(const GatherPass& pass, const GatherPass::Report& report);
  void Refine(const GatherPass& pass, const GatherPass::Report& report);
  Marks LongEnough(const LitMesh& mesh) const;
  std::vector<Wish> TooLong(const LitMesh& mesh) const;
  std::vector<Wish> Missing(const LitMesh& mesh) const;
  Marks MarksFor(std::vector<Wish> wishes, const AdaptiveMesh& mesh, bool& full) const;

  AdaptiveStart Start;
  AdaptiveLimits Limits;
  PlaceReceivers Receivers;
  std::vector<double> Lengths; ///< [facet of the surface] Of edges to look at, in the data's unit.
  LightSamples::Floor Darkest{ 0.0, 0.0 };
  SharedSamples Samples;
  std::vector<std::uint8_t> Needed; ///< [sample] See ProbedDetails.
  std::optional<LitMesh> Result;
  bool Full = false;
  std::size_t Most = 0;
};

} // namespace PhotonTransport
