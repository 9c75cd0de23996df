// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/map/MissingLight.h"

#include "Illumination/luminaires/LampPlace.h"
#include "Illumination/map/LightLosses.h"
#include "Illumination/map/SceneBlocks.h"
#include "Illumination/pipeline/FieldArrays.h"
#include "Illumination/pipeline/Text.h"

#include "vtkFieldData.h"

#include <algorithm>
#include <numeric>
#include <optional>

namespace Illumination
{
namespace
{

using PhotonTransport::ArrivedFlux;
using PhotonTransport::IlluminationRun;
using PhotonTransport::Luminaire;

/// See MissingLight.
constexpr double EscapedWorthANote = 0.1;
constexpr double LostWorthANote = 0.01;
constexpr double MostScatteredOnBacks = 0.1;

std::string PointText(const glm::dvec3& point)
{
  return Text("(", point.x, ", ", point.y, ", ", point.z, ")");
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
std::string Amount(double lumens, double of)
{
  return Text(lumens, " of the ", of, " lm (", 100.0 * Share(lumens, of), " %)");
}

/// Where the surface and the lamp are.
std::string Places(const Lost& lost, const TracedScene& traced)
{
  const Box box = BoxOf(traced.blocks.Surface());
  const std::optional<glm::dvec3> place = PlaceOf(traced.lighting.luminaires[lost.worst].lamp);
  std::string text =
    "The surface extends from " + PointText(box.least) + " to " + PointText(box.most);
  if (place)
  {
    text += ", and the lamp is at " + PointText(*place);
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

std::string TextOnBacks(const TracedScene& traced, const std::vector<Loss>& losses)
{
  const Lost lost = AllThatLost(Loss::OnBacks, losses, traced);
  if (lost.lamps.empty())
  {
    return "";
  }
  return Amount(lost.sum.back, MetBy(lost.sum)) + " of " + NameOf(lost, traced) +
    " that met the surface fell on the backs of facets" + Example(lost, traced) +
    ". The front is the side that point normals look to, and only light on fronts is in the map. "
    "Either normals look away from the light, as those of a room that look outward do, or the lamp "
    "is inside a solid body or behind a wall. In the first case " +
    TurnNormals +
    ", in the second move the lamp; if light on backs is meant, switch RegisterBackSide on. " +
    Places(lost, traced);
}

std::string TextOnEscaped(const TracedScene& traced, const std::vector<Loss>& losses)
{
  const Lost lost = AllThatLost(Loss::Escaped, losses, traced);
  return lost.lamps.empty()
    ? ""
    : Amount(lost.sum.escaped, lost.sum.Emitted()) + " of " + NameOf(lost, traced) +
      " left the scene without meeting it. Look at the lamp's position, which is in the data's "
      "length unit, and at its direction; facets that shine do so from their fronts. " +
      Places(lost, traced);
}

std::string TextOnClosed(const TracedScene& traced, const std::vector<Loss>& losses)
{
  const Lost lost = AllThatLost(Loss::OutsideClosed, losses, traced);
  return lost.lamps.empty()
    ? ""
    : "Light from outside, " + NameOf(lost, traced) + (lost.lamps.size() > 1 ? "" : ",") +
      " reached next to no front: " + Amount(lost.sum.back, MetBy(lost.sum)) +
      " of what met the surface fell on backs" + Example(lost, traced) +
      ". The front is the side that point normals look to, and only light on fronts is in the map. "
      "If the surface is a closed room, put a lamp inside (LampType and LampPosition, or a "
      "luminaire) or give it an opening; if its outside or a terrain is to be lit, " +
      TurnNormals + "; if light on backs is meant, switch RegisterBackSide on.";
}

std::string TextOnMissed(const TracedScene& traced, const std::vector<Loss>& losses)
{
  const Lost lost = AllThatLost(Loss::OutsideMissed, losses, traced);
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

std::string TextOnScattered(const TracedScene& traced)
{
  const PhotonTransport::ShareOfLight onBacks = ScatteredLightOnBacks(traced);
  return !onBacks.SurelyExceeds(MostScatteredOnBacks)
    ? ""
    : Text(100.0 * onBacks.Value(),
        " % of the scattered light that met the surface fell on backs of facets, where light is "
        "not "
        "registered. Either some normals look away from the light, as those of a floor that look "
        "down do, or the surface is thin and is lit from behind. In the first case ",
        TurnNormals, "; if light on backs is meant, switch RegisterBackSide on.");
}

std::vector<std::string> NotesOn(const TracedScene& traced)
{
  ArrivedFlux lamps;
  ArrivedFlux outside;
  const std::vector<ArrivedFlux> arrivals = traced.run.FluxArrivedByLamp();
  for (std::size_t lamp = 0; lamp < arrivals.size(); ++lamp)
  {
    (ComesFromOutside(traced.lighting.luminaires[lamp]) ? outside : lamps) += arrivals[lamp];
  }
  std::vector<std::string> notes;
  const auto note = [&](double part, double whole, double most, const char* what)
  {
    if (Share(part, whole) > most)
    {
      notes.push_back(Amount(part, whole) + what);
    }
  };
  note(traced.backSide ? 0.0 : lamps.back, MetBy(lamps), LostWorthANote,
    " of the lamps that met the surface fell on backs of facets, where light is not registered");
  note(lamps.escaped, lamps.Emitted(), EscapedWorthANote,
    " of the lamps left the scene without meeting it");
  note(traced.backSide ? 0.0 : outside.back, MetBy(outside), EscapedWorthANote,
    " from outside that met the surface fell on backs of facets, where light is not registered");
  const PhotonTransport::ShareOfLight scattered = ScatteredLightOnBacks(traced);
  note(scattered.part, scattered.whole, LostWorthANote,
    " of scattered light that met the surface, each time it did, fell on backs of facets, where "
    "light is not registered");
  const PhotonTransport::FluxBalance balance = traced.run.BalanceOfFlux();
  const double switchedOff =
    std::accumulate(balance.switchedOff.begin(), balance.switchedOff.end(), 0.0);
  note(balance.cutOff - switchedOff, traced.run.Flux(), LostWorthANote,
    " ended at MaximumPathLength; light that total reflection keeps in a solid body does so");
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
  const std::vector<Loss> losses = LossesByLamp(traced);
  std::vector<std::string> texts = { TextOnBacks(traced, losses), TextOnEscaped(traced, losses),
    TextOnClosed(traced, losses), TextOnMissed(traced, losses) };
  if (std::all_of(texts.begin(), texts.end(), [](const std::string& text) { return text.empty(); }))
  {
    texts.push_back(TextOnScattered(traced));
  }
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
  ArrivedFlux sum;
  for (const ArrivedFlux& lamp : run.FluxArrivedByLamp())
  {
    sum += lamp;
  }
  AddArray(output, "FluxOnFronts", std::vector<double>{ sum.front });
  AddArray(output, "FluxOnBacks", std::vector<double>{ sum.back });
  AddArray(output, "FluxEscaped", std::vector<double>{ sum.escaped });
}

} // namespace Illumination
