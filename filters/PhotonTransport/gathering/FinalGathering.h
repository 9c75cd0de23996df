// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/effects/Effects.h"
#include "PhotonTransport/gathering/GatheredMap.h"
#include "PhotonTransport/gathering/PhotonExitance.h"
#include "PhotonTransport/gathering/Viewers.h"
#include "PhotonTransport/lights/Emitter.h"
#include "PhotonTransport/openings/Opening.h"
#include "PhotonTransport/registration/FacetCells.h"
#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/threads/Ranks.h"
#include "PhotonTransport/threads/Threads.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace PhotonTransport
{

class DirectLight;
struct FacetRoulettes;
class GatherPass;
struct GatherScene;
class VertexReceivers;

/// How the second pass gathers.
struct GatherSettings
{
  std::uint32_t seed;
  std::uint32_t maximumPathLength; ///< Segments of a ray, >= 1.
  bool backSide;
  bool lampsApart;
  int threads; ///< See ThreadCount.
};

/// The second pass (Jensen, "Realistic Image Synthesis Using Photon Mapping", 2001, chapter 9). The
/// light at a vertex is the sum of what comes straight from the lamps, which is drawn there, of
/// caustics, which photons have brought, and of what diffuse facets send there, which rays gather
/// from the map of the first pass. Each path counts for one of the three, by its last scattering.
class FinalGathering
{
public:
  /// Called now and then from the thread that called Gather, with the share that is done; returns
  /// false to stop.
  using Progress = std::function<bool(double done)>;

  /// All must outlive it. @param cells Those by which the first pass counts. @param openings
  /// Through which the sky's light enters; there may be none.
  FinalGathering(const Scene& scene, const FacetCells& cells, const Emitter& source,
    const Openings& openings, const Effects& effects, const GatherSettings& settings);
  ~FinalGathering();

  /// From now on `watch` is told how many bytes links between cells take (CellLinks), as they
  /// become more, and may throw.
  void WatchLinks(std::function<void(std::uint64_t bytes)> watch)
  {
    this->OnLinks = std::move(watch);
  }

  /// From now on these ranks share the work; they must outlive it.
  void ShareWith(Ranks& ranks) { this->Sharing = &ranks; }

  /// Gathers light for all vertices from what the first pass has counted, on several threads. The
  /// result has the same bits for any number of them.
  /// @param rays For each vertex and side, about.
  /// @return Whether it was done. If it was stopped the maps stay as they were, or, if there were
  /// none, those vertices that are not done have the mean light on the facets around them.
  bool Gather(const PhotonCounts& counts, std::uint32_t rays, const Progress& progress);

  /// Makes maps of what the first pass has counted alone, until a second pass takes their place:
  /// each vertex has the mean light on the facets around it, but for caustics.
  void ShowFirstPass(const PhotonCounts& counts);

  /// Calls work(pass) on the threads, for light at more places than the vertices: with what photons
  /// have counted and so many rays it is the same light. The calling thread reports.
  void Run(const PhotonCounts& counts, std::uint32_t rays,
    const std::function<void(const GatherPass& pass)>& work);
  /// The same with a first pass that is made for these viewers and not for the vertices.
  void Run(const Viewers& viewers, const PhotonCounts& counts, std::uint32_t rays,
    const std::function<void(const GatherPass& pass)>& work);

  const GatheredMap& Front() const { return this->FrontMap; }
  const GatheredMap& Back() const { return this->BackMap; }

private:
  bool GatherSides(const GatherPass& pass, const Progress& progress);
  void FillFromFacets(const CellExitance& exitance, bool front,
    const std::vector<std::uint8_t>& done, GatheredMap& map) const;
  CellExitance FirstPass(const GatherScene& scene, const Viewers& viewers,
    const PhotonCounts& counts, std::uint32_t rays) const;
  GatheredMap EmptyMap() const;

  const Scene& LitScene;
  const FacetCells& Cells;
  const Openings& ToSky;
  const Effects& EffectsInUse;
  std::size_t Lamps;
  /// In which all light is kept until it is given out: the flux of all lamps on a scene unit
  /// squared, so that single precision holds any.
  double LuxPerUnit;
  GatherSettings Settings;
  Threads Workers;
  std::unique_ptr<FacetRoulettes> Materials;
  std::unique_ptr<DirectLight> DirectFromLamps;
  std::unique_ptr<VertexReceivers> Receivers;
  GatheredMap FrontMap, BackMap;
  bool OfFirstPass = false; ///< Whether these are of the first pass alone.
  std::function<void(std::uint64_t bytes)> OnLinks = [](std::uint64_t) {};
  Ranks Alone;
  Ranks* Sharing = &this->Alone;
};

/// Rays for each vertex that suit so many photons: the noise of the rays falls faster with their
/// number than that of the first pass with the photons.
std::uint32_t RaysFor(std::uint64_t photons);

} // namespace PhotonTransport
