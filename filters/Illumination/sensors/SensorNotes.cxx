// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/sensors/SensorNotes.h"

#include "Illumination/map/OpeningLines.h"
#include "Illumination/sensors/SensorArrays.h"

#include <algorithm>
#include <sstream>

namespace Illumination
{
namespace
{

using PhotonTransport::SensorReading;

/// Light that sensors miss is worth a warning from here on, as a share of the light on surfaces.
constexpr double MuchMissed = 0.05;
constexpr double LittleMissed = 0.001;

std::string Percent(double share)
{
  std::ostringstream text;
  text.precision(2);
  text << 100.0 * share << " %";
  return text.str();
}

std::string MissedLight(double share)
{
  return Percent(share) +
    " of the light on surfaces was sent there straight from lamps by mirrors, gloss or clear "
    "bodies. Sensors do not see such light: on average their values are too low by about as much, "
    "and by far more where it gathers, as below a lens. Illumination Map shows it on a surface "
    "that "
    "is put there";
}

/// Of sensors that are not valid.
void AddInvalid(const std::vector<SensorReading>& readings, SensorNotes& said)
{
  const auto invalid = static_cast<std::size_t>(std::count_if(readings.begin(), readings.end(),
    [](const SensorReading& reading) { return reading.valid == 0; }));
  if (invalid > 0)
  {
    said.notes.push_back(std::to_string(invalid) + " of " + std::to_string(readings.size()) +
      " sensors are inside solid bodies or outside of the room, by the backs that they see: they "
      "have Valid 0 and no light");
  }
  if (invalid == readings.size())
  {
    said.warnings.emplace_back("no sensor is valid: all of them see the backs of facets only. The "
                               "surface's normals may point the wrong way, or the sensors are "
                               "outside");
  }
}

} // namespace

SensorNotes NotesOn(const SensorScene& scene, const SensorInput& input,
  const std::vector<SensorReading>& readings, const PhotonTransport::Lighting& lighting,
  const std::string& whyNoDaylightFactor)
{
  SensorNotes said;
  if (input.withoutNormals > 0)
  {
    said.notes.push_back(
      std::to_string(input.withoutNormals) + " sensors have no normal: they face up");
  }
  AddInvalid(readings, said);
  if (!whyNoDaylightFactor.empty())
  {
    said.notes.push_back("there is no DaylightFactor, since " + whyNoDaylightFactor +
      ": it needs overcast skies alone as Luminaires");
  }
  if (NoneHasLuminance(lighting))
  {
    said.notes.emplace_back("UGR is 0, since no luminaire has an area and so a luminance");
  }
  const PhotonTransport::ShareOfLight missed = scene.Run.Caustics();
  if (missed.Value() > LittleMissed)
  {
    said.notes.push_back(MissedLight(missed.Value()));
  }
  if (missed.SurelyExceeds(MuchMissed))
  {
    said.warnings.push_back(MissedLight(missed.Value()));
  }
  if (PhotonTransport::UsesOpenings(lighting, scene.Settings))
  {
    const std::vector<std::string> lines =
      OpeningLines(scene.Openings, scene.Scene, PhotonTransport::HasSky(lighting));
    said.notes.insert(said.notes.end(), lines.begin(), lines.end());
  }
  return said;
}

} // namespace Illumination
