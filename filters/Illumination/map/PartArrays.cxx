// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/map/PartArrays.h"

#include "Illumination/pipeline/FieldArrays.h"

#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/registration/IlluminationMap.h"
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

/// A lamp's light with its own errors.
void AddLamp(
  const std::vector<PointMapping>& mappings, const IlluminationMap& map, const std::string& name)
{
  AddMean(mappings, "Illuminance_" + name, map.Totals());
  for (const PointMapping& mapping : mappings)
  {
    AddArray(mapping.PointArrays(), ("StandardError_" + name).c_str(),
      mapping.MeanError(map.standardError));
  }
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
    if (byPhotons)
    {
      AddLamp(mappings, run.MapOfLamp(lamp), name);
    }
    else
    {
      AddMean(mappings, "Illuminance_" + name, run.FrontOfLamp(lamp));
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
