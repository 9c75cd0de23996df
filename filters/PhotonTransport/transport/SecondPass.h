// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/FinalGathering.h"
#include "PhotonTransport/openings/Opening.h"
#include "PhotonTransport/registration/FacetCells.h"
#include "PhotonTransport/registration/IlluminationMap.h"
#include "PhotonTransport/transport/PhotonTracer.h"
#include "PhotonTransport/transport/ReplicateSums.h"
#include "PhotonTransport/transport/TraceSettings.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

namespace PhotonTransport
{

/// What a second pass needs of what photons have summed up, which must outlive it.
PhotonCounts CountsOf(const ReplicateSums& counted);

/// The second pass of a run. It gathers anew whenever more photons have been traced, from all that
/// they have counted, and its light is added to the caustics that photons have brought to vertices.
class SecondPass
{
public:
  /// The cells by which the first pass counts: a function of the scene alone. Null in
  /// Method::PhotonTracing. Throws InvalidInput for settings out of range.
  static std::unique_ptr<const FacetCells> CellsFor(
    const Scene& scene, const TraceSettings& settings);

  /// All but the openings must outlive it. @param tracer Of the first pass.
  SecondPass(const Scene& scene, const FacetCells& cells, const PhotonTracer& tracer,
    const TraceSettings& settings, Openings openings);

  void ShareWith(Ranks& ranks) { this->Gathering.ShareWith(ranks); }
  /// See FinalGathering::WatchLinks.
  void WatchLinks(std::function<void(std::uint64_t bytes)> watch)
  {
    this->Gathering.WatchLinks(std::move(watch));
  }

  /// See FinalGathering::Gather.
  bool Gather(const ReplicateSums& counted, const FinalGathering::Progress& progress);
  /// See FinalGathering::ShowFirstPass.
  void ShowFirstPass(const ReplicateSums& counted)
  {
    this->Gathering.ShowFirstPass(CountsOf(counted));
  }
  /// See FinalGathering::Run.
  void Run(const ReplicateSums& counted, const std::function<void(const GatherPass& pass)>& work);

  /// Whether it has gathered from any photons, and from all that are counted.
  bool HasGathered() const { return this->GatheredPhotons > 0; }
  bool HasGathered(const ReplicateSums& counted) const
  {
    return this->GatheredPhotons == counted.Balance().emitted;
  }
  /// Rays for each vertex, about.
  std::uint32_t Rays(const ReplicateSums& counted) const;

  const FacetCells& Cells() const { return this->CellsOfScene; }
  const GatheredMap& Front() const { return this->Gathering.Front(); }
  const GatheredMap& Back() const { return this->Gathering.Back(); }

  /// What photons and the second pass have brought to places.
  template <typename Caustics>
  struct Parts
  {
    Caustics caustics;
    const GatheredMap& gathered; ///< May be nothing.
    double factor;               ///< By which what was gathered counts.
  };

  /// All light of places.
  IlluminationMap Together(Parts<IlluminationMap> parts) const;
  /// [place] By colour; see IlluminationRun::FrontByColour.
  static std::vector<std::array<double, 3>> Together(
    Parts<std::vector<std::array<double, 3>>> parts);
  /// [place] Of one lamp.
  static std::vector<double> Together(Parts<std::vector<double>> parts, std::size_t lamp);

private:
  const FacetCells& CellsOfScene;
  const PhotonTracer& Tracer;
  std::uint32_t WantedRays; ///< 0: as many as suit the photons.
  Openings ToSky;
  FinalGathering Gathering;
  std::uint64_t GatheredPhotons = 0; ///< From which the maps were gathered.
};

} // namespace PhotonTransport
