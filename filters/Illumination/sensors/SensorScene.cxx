// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/sensors/SensorScene.h"

#include "PhotonTransport/scene/CurvedSurface.h"
#include "PhotonTransport/transport/MemoryNeed.h"

namespace Illumination
{
namespace
{

using namespace PhotonTransport;

TraceSettings WithSecondPass(TraceSettings settings)
{
  settings.method = Method::FinalGathering;
  return settings;
}

/// What is traced, if it fits the memory.
PhotonTransport::Surface SurfaceToTrace(
  const PhotonTransport::Surface& given, const Lighting& lighting, const TraceSettings& settings)
{
  constexpr std::uint64_t WhatTheMachineHas = 0;
  PhotonTransport::Surface surface =
    settings.curvedSurface ? CurvedSurface(given, MostRefinedFacets(WhatTheMachineHas)) : given;
  RequireMemory(MemoryNeed(surface, lighting, settings), WhatTheMachineHas);
  return surface;
}

} // namespace

SensorScene::SensorScene(
  const PhotonTransport::Surface& surface, const Lighting& lighting, TraceSettings settings)
  : Traced(SurfaceToTrace(surface, lighting, WithSecondPass(settings)))
  , Settings(WithSecondPass(settings))
  , Scene(this->Traced)
  , Openings(OpeningsToSkies(this->Traced, this->Scene, lighting, this->Settings))
  , Run(this->Scene, lighting, this->Settings, this->Openings.openings)
{
}

} // namespace Illumination
