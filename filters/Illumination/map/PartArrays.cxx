// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/map/PartArrays.h"

#include "Illumination/pipeline/FieldArrays.h"

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/statistics/PartErrors.h"
#include "PhotonTransport/transport/IlluminationRun.h"
#include "PhotonTransport/transport/RefinedMap.h"

#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <string>

namespace Illumination
{
namespace
{

using PhotonTransport::IlluminationMap;

std::string NameOf(const PhotonTransport::Luminaire& luminaire)
{
  return luminaire.name.empty() ? "Lamp" : luminaire.name;
}

using ByColour = std::array<double, 3>;

void AddColourErrors(const PointMapping& mapping, const std::vector<ByColour>& ofVertices)
{
  std::vector<ByColour> errors(
    static_cast<std::size_t>(mapping.PointArrays()->GetNumberOfTuples()));
  std::vector<double> channel(ofVertices.size());
  for (std::size_t c = 0; c < 3; ++c)
  {
    std::transform(ofVertices.begin(), ofVertices.end(), channel.begin(),
      [&](const ByColour& error) { return error[c]; });
    const std::vector<double> ofColour = mapping.MeanError(channel);
    for (std::size_t point = 0; point < errors.size(); ++point)
    {
      errors[point][c] = ofColour[point];
    }
  }
  AddArray(mapping.PointArrays(), "StandardErrorRGB", errors);
}

} // namespace

void AddParts(const std::vector<PointMapping>& mappings,
  const PhotonTransport::IlluminationRun& run, const IlluminationMap& front,
  const PhotonTransport::Lighting* lighting)
{
  const bool byPhotons = front.caustic.empty();
  if (run.EffectsInUse().colour)
  {
    AddMean(mappings, "IlluminanceRGB", run.FrontByColour());
    const std::vector<ByColour> errors = run.ColourErrors();
    for (std::size_t block = 0; byPhotons && block < mappings.size(); ++block)
    {
      AddColourErrors(mappings[block], errors);
    }
  }
  for (std::size_t lamp = 0; lighting && lamp < lighting->luminaires.size(); ++lamp)
  {
    const std::string name = NameOf(lighting->luminaires[lamp]);
    const std::vector<double> ofLamp = run.FrontOfLamp(lamp);
    AddMean(mappings, "Illuminance_" + name, ofLamp);
    const std::vector<double> errors = byPhotons
      ? PhotonTransport::PartErrors(front, [&](std::size_t vertex) { return ofLamp[vertex]; })
      : std::vector<double>();
    for (std::size_t block = 0; byPhotons && block < mappings.size(); ++block)
    {
      AddArray(mappings[block].PointArrays(), ("StandardError_" + name).c_str(),
        mappings[block].MeanError(errors));
    }
  }
}

void AddParts(const std::vector<PointMapping>& mappings, const PhotonTransport::RefinedMap& map,
  const PhotonTransport::Lighting* lighting)
{
  if (!map.frontByColour.empty())
  {
    AddMean(mappings, "IlluminanceRGB", map.frontByColour);
  }
  for (std::size_t lamp = 0; lighting && lamp < map.frontOfLamps.size(); ++lamp)
  {
    AddMean(mappings, "Illuminance_" + NameOf(lighting->luminaires[lamp]), map.frontOfLamps[lamp]);
  }
}

} // namespace Illumination
