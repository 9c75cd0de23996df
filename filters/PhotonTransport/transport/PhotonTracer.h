// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/effects/Effects.h"
#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/openings/Opening.h"
#include "PhotonTransport/registration/IlluminationSums.h"
#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/transport/TraceSettings.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace PhotonTransport
{

class Emitter;
class FacetCells;
class OpeningPhotons;

/// Called now and then from the thread that called Trace, with the number of blocks that this call
/// has traced so far. Returns false to stop.
using Monitor = std::function<bool(std::uint64_t blocksDone)>;

/// Photons are traced in blocks of so many, which are the same in every run, whichever thread
/// traces them. They are so small that a run stops promptly even where nothing absorbs.
constexpr std::uint64_t PhotonBlock = 256;

/// The lighting as it is traced: without dimming where that is applied afterwards.
Lighting Undimmed(Lighting lighting, const TraceSettings& settings);

/// Traces blocks of photons into sums, on several threads. The sums are a function of the blocks
/// alone: they have the same bits for any number of threads and any division of a range.
class PhotonTracer
{
public:
  /// Throws InvalidInput for settings or a lamp that make no sense, and for a luminous flux whose
  /// illuminances would leave the range of a double.
  /// @param scene Must outlive the tracer.
  /// @param cells To count light by, in place of vertices, which then get caustics alone; must
  /// outlive the tracer.
  /// @param openings Through which light from afar enters; not where light is counted by cells.
  PhotonTracer(const Scene& scene, const Lighting& lighting, const TraceSettings& settings,
    const FacetCells* cells = nullptr, Openings openings = {});
  ~PhotonTracer();

  /// Adds `count` blocks of a replicate, from block `first`, to `sums`. Stopped early, it adds the
  /// photons that were traced (sums.Balance().emitted tells how many) and returns false.
  bool Trace(std::uint32_t replicate, std::uint64_t first, std::uint64_t count,
    IlluminationSums& sums, const Monitor& monitor = {});
  /// The same, but calls add(part) for the parts of the sums, one after the other. It is called
  /// where loops run on all threads, and must leave the part clear for the next use.
  bool Trace(std::uint32_t replicate, std::uint64_t first, std::uint64_t count,
    const std::function<void(IlluminationSums& part)>& add, const Monitor& monitor = {});

  /// Gives up the memory of the threads' sums until light is traced again.
  void FreeSums();

  /// With slots for each lamp where the settings ask for lamps apart, and layers of colour where
  /// the scene calls for colour and LampsTellColours() is false.
  IlluminationSums EmptySums() const;
  double Flux() const;
  /// Throws InvalidInput if the illuminances of so much flux, lm, would leave the range of a
  /// double.
  void RequireIlluminanceInRange(double flux) const;
  const Emitter& Source() const;
  const std::vector<float>& StartWeights() const; ///< See Emitter.
  const OpeningPhotons* OpeningsInUse() const;    ///< Null where no light comes through any.
  /// See PhotonTransport::LampsTellColours.
  bool LampsTellColours() const { return this->ColoursByLamp; }
  /// Whether photons may reach a facet by mirrors, gloss or glass alone.
  bool CountsCaustics() const;
  const Effects& EffectsInUse() const { return this->EffectsFound; }

  /// The corners of one facet on whose back light of a lamp first arrives, as an example for
  /// messages. Nothing if none of the first 65536 photons meets such a facet first.
  std::optional<glm::uvec3> CornersLitFromBehind(std::uint32_t lamp) const;

private:
  void MakeSums();

  struct Implementation;
  const Scene& LitScene;
  TraceSettings Settings;
  const FacetCells* Cells;
  Effects EffectsFound;
  bool ColoursByLamp;
  std::unique_ptr<Implementation> Impl;
};

} // namespace PhotonTransport
