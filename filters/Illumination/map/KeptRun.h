// SPDX-License-Identifier: BSD-3-Clause
#ifndef KeptRun_h
#define KeptRun_h

#include "Illumination/map/BackgroundRun.h"
#include "Illumination/map/SceneBlocks.h"

#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/scene/Surface.h"
#include "PhotonTransport/transport/IlluminationRun.h"
#include "PhotonTransport/transport/MemoryBudget.h"
#include "PhotonTransport/transport/SkyOpenings.h"
#include "PhotonTransport/transport/StopRules.h"

#include "vtkType.h"

#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace Illumination
{

/// When data and filter last changed; no two states of any objects have the same time.
using Origins = std::vector<vtkMTimeType>;

/// How a run ended: by which rules, for which region, and why.
struct EndedRun
{
  PhotonTransport::StopRules rules;
  std::vector<double> region; ///< See AccuracyRegion.
  PhotonTransport::StopReason reason;

  /// Whether these rules ask for nothing else.
  bool IsBy(const PhotonTransport::StopRules& asked, const std::vector<double>& wanted) const
  {
    return this->rules.photons == asked.photons && this->rules.seconds == asked.seconds &&
      this->rules.relativeError == asked.relativeError &&
      this->rules.countFacetError == asked.countFacetError && this->region == wanted;
  }
};

/// A run that the next execution of a filter may go on with, and what its map depends on but for
/// the number of photons and the lighting, which the run itself compares.
struct KeptRun
{
  KeptRun(const PhotonTransport::Surface& surface, const PhotonTransport::Lighting& lighting,
    const PhotonTransport::TraceSettings& settings, Origins madeFrom,
    const PhotonTransport::MemoryBudget& memory)
    : Memory(memory)
    , Scene(surface)
    , Openings(OpeningsToSkies(surface, this->Scene, lighting, settings))
    , Run(this->Scene, lighting, settings, this->Openings.openings, &this->Memory)
    , MadeFrom(std::move(madeFrom))
    , Background(this->Run)
  {
  }

  PhotonTransport::MemoryBudget Memory; ///< With what the filter makes of the maps.
  PhotonTransport::Scene Scene;
  PhotonTransport::FoundOpenings Openings;
  PhotonTransport::IlluminationRun Run;
  PhotonTransport::Surface Curved; ///< What is traced where it is not the surface of the blocks.
  Origins MadeFrom;
  std::optional<EndedRun> Ended;       ///< How it ended last.
  std::shared_ptr<SceneBlocks> Blocks; ///< What the scene was made of.
  double MemoryLimit = 0.0;            ///< The property as it was, GiB.
  BackgroundRun Background;            ///< Last, since it uses the others.

  /// Whether another limit may allow more parts of curved patches.
  bool IsCoarseForAnother(double memoryLimit) const
  {
    return this->Scene.Notes().isCoarse && memoryLimit != this->MemoryLimit;
  }
};

} // namespace Illumination

#endif
