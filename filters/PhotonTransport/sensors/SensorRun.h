// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/FinalGathering.h"
#include "PhotonTransport/openings/Opening.h"
#include "PhotonTransport/sensors/Sensor.h"
#include "PhotonTransport/sensors/SensorReader.h"
#include "PhotonTransport/statistics/ShareOfLight.h"
#include "PhotonTransport/threads/Ranks.h"
#include "PhotonTransport/transport/PhotonTracer.h"
#include "PhotonTransport/transport/ReplicateSums.h"
#include "PhotonTransport/transport/TraceSettings.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace PhotonTransport
{

class MemoryBudget;

/// The light at points that are no part of the scene. A first pass by photons finds the light on
/// cells of the surface, as for a map by Method::FinalGathering, and sensors gather from it. A map
/// would be coarser: its values lie at the points of the user's mesh, and a wall may have four.
class SensorRun
{
public:
  /// Called now and then from the calling thread, with the share that is done; returns false to
  /// stop.
  using Progress = std::function<bool(double done)>;

  /// Throws InvalidInput as PhotonTracer does. @param scene Must outlive this. @param settings The
  /// method is Method::FinalGathering, whatever they say. @param openings, memory See
  /// IlluminationRun.
  SensorRun(const Scene& scene, const Lighting& lighting, const TraceSettings& settings,
    Openings openings = {}, MemoryBudget* memory = nullptr);

  /// From now on these ranks share the work; they must outlive it. Each makes the same calls, and
  /// all get the bits that one rank alone gets. A stop on any rank is one on all.
  void ShareWith(Ranks& ranks);

  /// The first pass, once. @param photons Rounded up to a multiple of PhotonBlock and the
  /// replicates. @return False if it was stopped.
  bool Trace(std::uint64_t photons, const Progress& progress = {});

  /// Reads sensors, on several threads; the result has the same bits for any number of them.
  /// @param rays For each sensor, about, [LeastGatherRays, MostGatherRays]; those to openings come
  /// in addition. @param readings [sensor] Gets what they measure. @return False if it was stopped.
  bool Read(const std::vector<Sensor>& sensors, const SensorDirections& directions,
    std::uint32_t rays, const Progress& progress, std::vector<SensorReading>& readings);

  /// The share of the light on surfaces that mirrors, gloss and glass alone have sent there from
  /// lamps, in photons. Such light is not seen at sensors. 0 if nothing is lit.
  ShareOfLight Caustics() const;

private:
  bool ReadShare(const std::vector<Sensor>& sensors, const SensorDirections& directions,
    const GatherPass& pass, const Progress& progress, std::vector<SensorReading>& readings) const;
  static TraceSettings WithCells(TraceSettings settings);
  Receiver ReceiverAt(const Sensor& sensor) const;

  const Scene& LitScene;
  TraceSettings Settings;
  Openings ToSky;
  std::unique_ptr<const FacetCells> Cells;
  PhotonTracer Tracer;
  FinalGathering Gathering;
  ReplicateSums Sums;
  Ranks Alone;
  Ranks* Sharing = &this->Alone;
};

} // namespace PhotonTransport
