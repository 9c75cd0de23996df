// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/map/SceneWarnings.h"

#include "Illumination/map/SceneBlocks.h"

#include "PhotonTransport/scene/Scene.h"

#include <sstream>

namespace Illumination
{
namespace
{

/// "12 triangles WHAT, such as those of cell 3 and cell 7 (on 0.5 m^2): WHY"; nothing if there are
/// none.
void AddSharedPlaces(std::vector<std::string>& lines, const SceneBlocks& blocks,
  const PhotonTransport::SharedPlaceNote& note, const std::string& what, const std::string& why)
{
  if (note.facets > 0)
  {
    std::ostringstream line;
    line << note.facets << (note.facets == 1 ? " triangle " : " triangles ") << what
         << ", such as those of " << blocks.NameOfFacet(note.first) << " and "
         << blocks.NameOfFacet(note.second) << " (on " << note.squareMetres << " m^2): " << why;
    lines.push_back(line.str());
  }
}

std::string LeftToChanceText(
  const PhotonTransport::SharedPlaceNote& note, const SceneBlocks& blocks)
{
  std::ostringstream text;
  text
    << note.facets << " triangles lie nearly in the plane of others that face the same way, "
    << "such as those of " << blocks.NameOfFacet(note.first) << " and "
    << blocks.NameOfFacet(note.second) << " (on " << note.squareMetres << " m^2). They are at most "
    << note.apart
    << " apart, too little to tell everywhere which is in front, so chance shares the light out "
       "between them. Remove one of the two surfaces, or move one by more than that. If rounding "
       "of the coordinates has put them apart, move all data near the origin before they are "
       "rounded, or use points of double precision";
  return text.str();
}

std::string ThinGapsText(const PhotonTransport::ThinGaps& gaps, const SceneBlocks& blocks)
{
  std::ostringstream text;
  text << "light may pass " << gaps.number
       << " triangles unseen, since another one is too close in front: "
       << blocks.NameOfFacet(gaps.facet) << " and " << blocks.NameOfFacet(gaps.other) << " are "
       << gaps.gap << " apart, and light that leaves a surface there starts " << gaps.offset
       << " away from it, because coordinates are no finer so far from the scene's finest part. "
          "Light that part in a run of its own, without what is far away, or close the gap";
  return text.str();
}

} // namespace

std::vector<std::string> NotesOnSharedPlaces(
  const SceneBlocks& blocks, const PhotonTransport::Scene& scene)
{
  const PhotonTransport::SharedPlaceNotes& found = scene.Notes().sharedPlaces;
  std::vector<std::string> notes;
  AddSharedPlaces(notes, blocks, found.copies,
    found.copies.facets == 1
      ? "is a copy of another one, with the same corners and facing the same way"
      : "are copies of others, with the same corners and facing the same way",
    "they count once, and the points of all copies get the whole light");
  AddSharedPlaces(notes, blocks, found.inPart,
    "overlap others in their plane that face the same way",
    "each gets the whole light, and the material of the later cell counts");
  return notes;
}

std::vector<std::string> WarningsOn(const SceneBlocks& blocks, const PhotonTransport::Scene& scene)
{
  const PhotonTransport::SharedPlaceNotes& found = scene.Notes().sharedPlaces;
  std::vector<std::string> warnings;
  AddSharedPlaces(warnings, blocks, found.unlikeMaterials,
    "lie in the place of others that face the same way and have another material",
    "the material of the later cell counts there. Remove one of the two, or move it");
  AddSharedPlaces(warnings, blocks, found.shineToo,
    "shine where others shine that face the same way",
    "the light of both is emitted there. Remove one of the two, or set its exitance to 0");
  if (found.leftToChance.facets > 0)
  {
    warnings.push_back(LeftToChanceText(found.leftToChance, blocks));
  }
  const PhotonTransport::ThinGaps& gaps = scene.Notes().thinGaps;
  if (gaps.unresolved > 0)
  {
    warnings.push_back(std::to_string(gaps.unresolved) + " triangles, the first being of " +
      blocks.NameOfFacet(gaps.firstUnresolved) +
      ", are too small for coordinates so far from the scene's finest part: light there is not "
      "right. Light that part in a run of its own, without what is far away");
  }
  if (gaps.number > 0)
  {
    warnings.push_back(ThinGapsText(gaps, blocks));
  }
  return warnings;
}

} // namespace Illumination
