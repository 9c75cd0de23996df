// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/TraceSettings.h"

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/scene/InvalidInput.h"

#include <algorithm>
#include <variant>

namespace PhotonTransport
{
namespace
{

void Require(bool holds, const std::string& message)
{
  if (!holds)
  {
    throw InvalidInput(InvalidInput::Where::TraceSettings, 0, message);
  }
}

} // namespace

bool LampsTellColours(const Lighting& lighting, const TraceSettings& settings, bool colouredFacets)
{
  return CanBeRelit(settings) && !colouredFacets &&
    std::none_of(lighting.luminaires.begin(), lighting.luminaires.end(),
      [](const Luminaire& luminaire)
      { return std::holds_alternative<EmittingFacets>(luminaire.lamp); });
}

void Validate(const TraceSettings& settings)
{
  Require(settings.replicates >= 2,
    "the number of replicates is " + std::to_string(settings.replicates) +
      "; it must be 2 or more");
  Require(settings.weightBound >= 1.0f && settings.weightBound <= LargestFactor,
    "the weight bound is " + std::to_string(settings.weightBound) +
      "; it must be between 1 and 1048576");
  Require(settings.maximumPathLength >= 1, "the maximum path length is 0; it must be 1 or more");
  Require(settings.gatherRays == 0 ||
      (settings.gatherRays >= LeastGatherRays && settings.gatherRays <= MostGatherRays),
    "the number of gather rays is " + std::to_string(settings.gatherRays) +
      "; it must be 0 or between " + std::to_string(LeastGatherRays) + " and " +
      std::to_string(MostGatherRays));
  Require(settings.threads >= 0 && settings.threads <= MostThreads,
    "the number of threads is " + std::to_string(settings.threads) +
      "; it must be between 0 (all) and " + std::to_string(MostThreads));
}

} // namespace PhotonTransport
