// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/map/MissingLight.h"

#include "Illumination/luminaires/LampPlace.h"
#include "Illumination/map/SceneBlocks.h"
#include "Illumination/pipeline/FieldArrays.h"

#include "vtkFieldData.h"

#include <algorithm>
#include <optional>
#include <sstream>
#include <variant>

namespace
{

using PhotonTransport::Arrivals;
using PhotonTransport::IlluminationRun;
using PhotonTransport::Luminaire;

/// See MissingLight.
constexpr double MostOnBacks = 0.1;
constexpr double MostEscaped = 0.99;
constexpr double MostEscapedFromAfar = 0.9;
constexpr double MostEscapedFromClosed = 0.1;
constexpr double WorthANote = 0.1;
constexpr double LeastOfOutdoorLight = 1e-4;

double Share(std::uint64_t part, std::uint64_t whole)
{
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

/// Whether a lamp's light starts over the whole scene: parallel light and skies.
bool ComesFromOutside(const Luminaire& luminaire)
{
  const PhotonTransport::LampClass kind = ClassOf(luminaire.lamp);
  return kind == PhotonTransport::LampClass::Parallel || kind == PhotonTransport::LampClass::Sky;
}

enum class Loss
{
  None,
  OnBacks,       ///< Of a lamp in the scene.
  Escaped,       ///< Of a lamp in the scene.
  OutsideClosed, ///< Light from outside fell on backs.
  OutsideMissed  ///< Light from outside met nothing.
};

/// Whether the surface is closed, so that fronts see nothing but the surface: less than one in a
/// thousand of at least a thousand scattered photons left the scene. From those that left, the
/// photons are subtracted that missed the surface or first arrived on a back. A surface that
/// scatters fewer photons is not taken to be closed.
bool IsClosed(const IlluminationRun& run)
{
  const PhotonTransport::PhotonBalance balance = run.Balance();
  std::uint64_t fromOutside = 0;
  for (const Arrivals& lamp : run.ArrivalsByLamp())
  {
    fromOutside += lamp.escaped + lamp.back;
  }
  const std::uint64_t scattered = balance.segments - balance.emitted;
  const std::uint64_t escaped = balance.escaped - std::min(balance.escaped, fromOutside);
  constexpr std::uint64_t Enough = 1000;
  return scattered >= Enough && escaped * Enough < scattered;
}

/// What a lamp's light meets.
struct Surroundings
{
  Box surface;
  bool closed;
  bool backSide; ///< Whether backs are registered.
};

Loss LossOf(const Luminaire& luminaire, const Arrivals& lamp, const Surroundings& around)
{
  const std::uint64_t onBacks = around.backSide ? 0 : lamp.back;
  const std::uint64_t met = lamp.Emitted() - lamp.escaped;
  if (ComesFromOutside(luminaire))
  {
    if (met == 0 && lamp.escaped > 0)
    {
      return Loss::OutsideMissed;
    }
    const bool closed = Share(lamp.front, met) < LeastOfOutdoorLight && 2 * onBacks > met;
    return closed ? Loss::OutsideClosed : Loss::None;
  }
  const std::optional<glm::dvec3> place = PlaceOf(luminaire.lamp);
  const double escaped = Share(lamp.escaped, lamp.Emitted());
  if (escaped > (place && IsFar(*place, around.surface) ? MostEscapedFromAfar : MostEscaped))
  {
    return Loss::Escaped;
  }
  if (Share(onBacks, met) > MostOnBacks)
  {
    return Loss::OnBacks;
  }
  return around.closed && escaped > MostEscapedFromClosed ? Loss::Escaped : Loss::None;
}

template <typename... Parts>
std::string Text(const Parts&... parts)
{
  std::ostringstream text;

  (text << ... << parts);
  return text.str();
}

std::string Text(const glm::dvec3& point)
{
  return Text("(", point.x, ", ", point.y, ", ", point.z, ")");
}

/// All lamps that lost light in one way.
struct Lost
{
  Arrivals sum;
  std::vector<std::size_t> lamps;
  std::size_t worst = 0; ///< Of the lamps.
};

Lost AllThatLost(Loss way, const TracedScene& traced)
{
  const std::vector<Arrivals> arrivals = traced.run.ArrivalsByLamp();
  const Surroundings around{ BoxOf(traced.blocks.Surface()), IsClosed(traced.run),
    traced.backSide };
  const auto missing = [](const Arrivals& lamp) { return lamp.back + lamp.escaped; };
  Lost lost;
  for (std::size_t lamp = 0; lamp < arrivals.size(); ++lamp)
  {
    if (LossOf(traced.lighting.luminaires[lamp], arrivals[lamp], around) == way)
    {
      if (lost.lamps.empty() || missing(arrivals[lamp]) > missing(arrivals[lost.worst]))
      {
        lost.worst = lamp;
      }
      lost.lamps.push_back(lamp);
      lost.sum += arrivals[lamp];
    }
  }
  return lost;
}

/// "luminaire 'Spot'", "the lamp", "3 of 5 luminaires, first of all 'Spot',".
std::string NameOf(const Lost& lost, const TracedScene& traced)
{
  const std::vector<Luminaire>& all = traced.lighting.luminaires;
  const std::string name = "'" + all[lost.worst].name + "'";
  if (lost.lamps.size() > 1)
  {
    return Text(lost.lamps.size(), " of ", all.size(), " luminaires, first of all ", name, ",");
  }
  return all[lost.worst].name.empty() ? "the lamp" : "luminaire " + name;
}

/// "990 of the 1000 lm (99 %)"
std::string Amount(std::uint64_t photons, std::uint64_t of, const TracedScene& traced)
{
  return Text(traced.run.FluxOf(photons), " of the ", traced.run.FluxOf(of), " lm (",
    100.0 * Share(photons, of), " %)");
}

/// Where the surface and the lamp are.
std::string Places(const Lost& lost, const TracedScene& traced)
{
  const Box box = BoxOf(traced.blocks.Surface());
  const std::optional<glm::dvec3> place = PlaceOf(traced.lighting.luminaires[lost.worst].lamp);
  std::string text = "The surface extends from " + Text(box.least) + " to " + Text(box.most);
  if (place)
  {
    text += ", and the lamp is at " + Text(*place);
  }
  text += Text(", all in the data's length unit, of which one is ", traced.metresPerUnit, " m.");
  return text + (place ? HintOnUnits(*place, box) : "");
}

/// ", for example on that of cell 7 of block 2"
std::string Example(const Lost& lost, const TracedScene& traced)
{
  const std::optional<glm::uvec3> corners = traced.run.CornersLitFromBehind(lost.worst);
  const std::vector<glm::uvec3>& facets = traced.blocks.Surface().facets;
  const auto place = corners ? std::find(facets.begin(), facets.end(), *corners) : facets.end();
  return place == facets.end() ? ""
                               : ", for example on that of " +
      traced.blocks.NameOfFacet(static_cast<std::size_t>(place - facets.begin()));
}

const char* const TurnNormals =
  "turn the normals (vtkPolyDataNormals, in ParaView Generate Surface Normals or Surface Normals, "
  "with FlipNormals)";

std::string TextOnBacks(const TracedScene& traced)
{
  const Lost lost = AllThatLost(Loss::OnBacks, traced);
  if (lost.lamps.empty())
  {
    return "";
  }
  const std::uint64_t met = lost.sum.Emitted() - lost.sum.escaped;
  return Amount(lost.sum.back, met, traced) + " of " + NameOf(lost, traced) +
    " that met the surface fell on the backs of facets" + Example(lost, traced) +
    ". The front is the side that point normals look to, and only light on fronts is in the map. "
    "Either normals look away from the light, as those of a room that look outward do, or the lamp "
    "is inside a solid body or behind a wall. In the first case " +
    TurnNormals +
    ", in the second move the lamp; if light on backs is meant, switch RegisterBackSide on. " +
    Places(lost, traced);
}

std::string TextOnEscaped(const TracedScene& traced)
{
  const Lost lost = AllThatLost(Loss::Escaped, traced);
  return lost.lamps.empty()
    ? ""
    : Amount(lost.sum.escaped, lost.sum.Emitted(), traced) + " of " + NameOf(lost, traced) +
      " left the scene without meeting it. Look at the lamp's position, which is in the data's "
      "length unit, and at its direction; facets that shine do so from their fronts. " +
      Places(lost, traced);
}

std::string TextOnClosed(const TracedScene& traced)
{
  const Lost lost = AllThatLost(Loss::OutsideClosed, traced);
  return lost.lamps.empty() ? ""
                            : "Light from outside, " + NameOf(lost, traced) +
      (lost.lamps.size() > 1 ? "" : ",") + " reached next to no front: " +
      Amount(lost.sum.back, lost.sum.Emitted() - lost.sum.escaped, traced) +
      " of what met the surface fell on backs" + Example(lost, traced) +
      ". The front is the side that point normals look to, and only light on fronts is in the map. "
      "If the surface is a closed room, put a lamp inside (LampType and LampPosition, or a "
      "luminaire) or give it an opening; if its outside or a terrain is to be lit, " +
      TurnNormals + "; if light on backs is meant, switch RegisterBackSide on.";
}

std::string TextOnMissed(const TracedScene& traced)
{
  const Lost lost = AllThatLost(Loss::OutsideMissed, traced);
  return lost.lamps.empty()
    ? ""
    : "Light from outside, " + NameOf(lost, traced) + (lost.lamps.size() > 1 ? "" : ",") +
      " met no facet: it travels along the surface. Look at its direction.";
}

std::string TextOnTarget(const TracedScene& traced)
{
  const std::uint64_t emitted = traced.run.Balance().emitted;
  return Text("TargetRelativeError can't be met, and the run has ended: of ", emitted,
    " photons none registered on a front, so that less than 3 in so many do (with 95 % "
    "confidence), ",
    3.0 * traced.run.FluxOf(1), " lm of ", traced.run.Flux(),
    " lm. If so little light is meant, set TargetRelativeError to 0 and raise Photons.");
}

std::vector<std::string> NotesOn(const TracedScene& traced)
{
  Arrivals lamps;
  Arrivals outside;
  const std::vector<Arrivals> arrivals = traced.run.ArrivalsByLamp();
  for (std::size_t lamp = 0; lamp < arrivals.size(); ++lamp)
  {
    (ComesFromOutside(traced.lighting.luminaires[lamp]) ? outside : lamps) += arrivals[lamp];
  }
  std::vector<std::string> notes;
  const auto note = [&](std::uint64_t part, std::uint64_t whole, const char* what)
  {
    if (Share(part, whole) > WorthANote)
    {
      notes.push_back(Amount(part, whole, traced) + what);
    }
  };
  note(traced.backSide ? 0 : lamps.back, lamps.Emitted() - lamps.escaped,
    " of the lamps that met the surface fell on backs of facets, where light is not registered");
  note(lamps.escaped, lamps.Emitted(), " of the lamps left the scene without meeting it");
  note(traced.backSide ? 0 : outside.back, outside.Emitted() - outside.escaped,
    " from outside that met the surface fell on backs of facets, where light is not registered");
  return notes;
}

} // namespace

MissingLight FindMissingLight(const TracedScene& traced, PhotonTransport::StopReason reason)
{
  MissingLight missing;
  if (!(traced.run.Flux() > 0.0))
  {
    missing.notes.push_back("the lamps have a luminous flux of 0 lm: the map is dark");
    return missing;
  }
  missing.notes = NotesOn(traced);
  std::vector<std::string> texts = { TextOnBacks(traced), TextOnEscaped(traced),
    TextOnClosed(traced), TextOnMissed(traced) };
  if (reason == PhotonTransport::StopReason::NothingLit)
  {
    texts.push_back(TextOnTarget(traced));
  }
  for (const std::string& text : texts)
  {
    missing.warning += (missing.warning.empty() || text.empty() ? "" : "\n") + text;
  }
  return missing;
}

void AddArrivals(vtkFieldData* output, const IlluminationRun& run)
{
  Arrivals sum;
  for (const Arrivals& lamp : run.ArrivalsByLamp())
  {
    sum += lamp;
  }
  AddArray(output, "FluxOnFronts", std::vector<double>{ run.FluxOf(sum.front) });
  AddArray(output, "FluxOnBacks", std::vector<double>{ run.FluxOf(sum.back) });
  AddArray(output, "FluxEscaped", std::vector<double>{ run.FluxOf(sum.escaped) });
}
