// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/map/OpeningLines.h"

#include "Illumination/pipeline/Text.h"

#include <cmath>
#include <utility>

namespace Illumination
{
namespace
{

using PhotonTransport::FoundOpenings;
using PhotonTransport::Opening;
using PhotonTransport::OpeningKind;
using PhotonTransport::OpeningNotes;
using PhotonTransport::Placement;
using PhotonTransport::Scene;

const char* WordsFor(OpeningKind kind)
{
  switch (kind)
  {
    case OpeningKind::Glass:
      return "a pane";
    case OpeningKind::Marked:
      return "marked";
    default:
      return "a hole of the mesh";
  }
}

/// To three digits.
double Rounded(double value, double size)
{
  const double step = std::pow(10.0, std::floor(std::log10(size)) - 2.0);
  return std::round(value / step) * step + 0.0; // never -0
}

std::string AreaOf(double squareMetres)
{
  return Text(Rounded(squareMetres, squareMetres), " m^2");
}

std::string LineFor(const Opening& opening, const Scene& scene)
{
  const Placement& placement = scene.GetPlacement();
  const double radius = double{ opening.radius } / placement.scale;
  const auto coordinate = [&](int i)
  { return Rounded(double{ opening.centre[i] } / placement.scale + placement.centre[i], radius); };
  return Text(AreaOf(double{ opening.Area() } * scene.SquareMetresPerSceneArea()), " at (",
    coordinate(0), ", ", coordinate(1), ", ", coordinate(2), "), ", WordsFor(opening.kind));
}

std::string UsedLine(const FoundOpenings& found, const Scene& scene)
{
  const std::vector<Opening>& openings = found.openings.List();
  if (openings.empty())
  {
    return "openings used: none";
  }
  constexpr std::size_t MostListed = 6;
  double all = 0.0;
  std::string list;
  for (std::size_t i = 0; i < openings.size(); ++i)
  {
    all += openings[i].Area();
    list += i < MostListed ? (i == 0 ? "" : "; ") + LineFor(openings[i], scene) : "";
  }
  const std::size_t more = openings.size() < MostListed ? 0 : openings.size() - MostListed;
  return Text("openings used: ", openings.size(), " (",
    AreaOf(all * scene.SquareMetresPerSceneArea()), " in all): ", list,
    more > 0 ? Text("; and ", more, more > 1 ? " smaller ones" : " smaller one") : "");
}

std::string NotUsedLine(const OpeningNotes& notes)
{
  const std::pair<std::size_t, const char*> reasons[] = { { notes.openToBothSides,
                                                            "see as much sky from either side" },
    { notes.withoutSky, "see hardly any sky" }, { notes.covered, "are covered by other triangles" },
    { notes.doubled, "lie close to a larger one" },
    { notes.tooMany, "are too small among so many" },
    { notes.opaqueMarks.number, "triangles are marked and let no light straight through" } };
  std::string line;
  for (const auto& [number, why] : reasons)
  {
    line += number > 0 ? Text(line.empty() ? "openings not used: " : "; ", number, " ", why) : "";
  }
  return line;
}

} // namespace

std::vector<std::string> OpeningLines(
  const FoundOpenings& found, const Scene& scene, bool tellsOfNone)
{
  std::vector<std::string> lines;
  if (tellsOfNone || !found.openings.IsEmpty())
  {
    lines.push_back(UsedLine(found, scene));
  }
  const std::string notUsed = NotUsedLine(found.notes);
  if (!notUsed.empty())
  {
    lines.push_back(notUsed);
  }
  return lines;
}

} // namespace Illumination
