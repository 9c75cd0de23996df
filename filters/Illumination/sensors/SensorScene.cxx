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

PhotonTransport::Surface SurfaceToTrace(
  const PhotonTransport::Surface& given, const TraceSettings& settings)
{
  constexpr std::uint64_t WhatTheMachineHas = 0;
  return settings.curvedSurface ? CurvedSurface(given, MostRefinedFacets(WhatTheMachineHas))
                                : given;
}

} // namespace

SensorScene::SensorScene(
  const PhotonTransport::Surface& surface, const Lighting& lighting, TraceSettings settings)
  : Traced(SurfaceToTrace(surface, settings))
  , Settings(WithSecondPass(settings))
  , Memory(MemoryNeed(this->Traced, lighting, this->Settings), {}, MemoryLimit())
  , Scene(this->Traced)
  , Openings(OpeningsToSkies(this->Traced, this->Scene, lighting, this->Settings))
  , Run(this->Scene, lighting, this->Settings, this->Openings.openings, &this->Memory)
{
}

} // namespace Illumination
