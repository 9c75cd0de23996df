// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/scene/Surface.h"
#include "PhotonTransport/transport/GatheringMemory.h"
#include "PhotonTransport/transport/TraceSettings.h"

#include <algorithm>
#include <cstdint>

namespace PhotonTransport
{

/// Bytes that someone takes beside a run.
struct MemoryBeside
{
  std::uint64_t always = 0;
  std::uint64_t maps = 0; ///< In addition, once there are maps, these included.
};

/// Bytes that a Surface, its Scene, an IlluminationRun and the maps it gives take together at most,
/// with the error of facet size. Nearly all of it is worked out from the Surface before the rest is
/// allocated. Parts of large facets and the cells of a second pass are known once there is a scene,
/// and how many links there are between cells once these are found. This counts what grows with the
/// surface, and not the few MiB that every process takes.
class MemoryNeed
{
public:
  /// Until more is known, no facet has parts, each has one cell, and there are no links. @param
  /// surface Valid; see Validate.
  MemoryNeed(const Surface& surface, const Lighting& lighting, const TraceSettings& settings);

  /// @param parts Of large facets; see Scene::NumberOfParts. @param cells See FacetCells; any
  /// number in Method::PhotonTracing.
  void SetScene(std::uint64_t parts, std::uint64_t cells)
  {
    this->Parts = parts;
    this->Cells = cells;
  }
  /// The most that CellLinks told of.
  void SetLinks(std::uint64_t bytes) { this->Links = std::max(this->Links, bytes); }

  /// The most facets of a mesh that is refined where the light varies, see IlluminationRun::Refine.
  void SetAdapted(std::uint64_t facets) { this->Adapted = facets; }

  std::uint64_t Bytes(const MemoryBeside& beside = {}) const;

  /// What a filter's need depends on as well: points that have light, and facets that are traced.
  std::uint64_t Points() const { return this->OnMap; }
  std::uint64_t Facets() const { return this->Traced; }
  bool HasColours() const { return this->Colour; }

private:
  void CountScene(const Surface& surface);
  void CountSums(const Lighting& lighting, const TraceSettings& settings);
  void CountMaps(const Surface& surface, const TraceSettings& settings);

  std::uint64_t OnMap, Traced;
  std::uint64_t Cells;
  bool ColouredFacets, Colour;
  std::uint64_t PerAdapted; ///< Bytes.
  std::uint64_t Parts = 0;
  std::uint64_t Links = 0;
  std::uint64_t Adapted = 0;
  std::uint64_t OfScene = 0; ///< With the Surface.
  std::uint64_t Copies = 0;  ///< Of facets and points, if any facet has parts.
  PhaseBytes Run;            ///< All but the second pass.
  GatheringNeed Second;
};

/// So many facets that a refined surface takes half of the memory. @param limit See MemoryLimit.
std::uint64_t MostRefinedFacets(std::uint64_t limit);

/// So many facets of a map that is refined where its light varies fit the memory that is left,
/// about.
/// @param limit See MemoryLimit. @param need What the run takes already.
std::uint64_t MostAdaptiveFacets(std::uint64_t limit, std::uint64_t need);

} // namespace PhotonTransport
