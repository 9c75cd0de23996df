// SPDX-License-Identifier: BSD-3-Clause
// What a run has found, as outputs, notes and warnings.
#include "vtkIlluminationMap.h"

#include "Illumination/map/IlluminationArrays.h"
#include "Illumination/map/KeptRun.h"
#include "Illumination/map/LightLosses.h"
#include "Illumination/map/MissingLight.h"
#include "Illumination/map/OpeningLines.h"
#include "Illumination/map/PhotonArrays.h"
#include "Illumination/map/RunFacts.h"
#include "Illumination/map/SceneBlocks.h"
#include "Illumination/map/SceneWarnings.h"
#include "Illumination/pipeline/FieldArrays.h"
#include "Illumination/pipeline/Pipeline.h"
#include "Illumination/ranks/ControllerRanks.h"

#include "PhotonTransport/adaptive/AdaptiveLimits.h"
#include "PhotonTransport/transport/MemoryNeed.h"
#include "PhotonTransport/transport/RefinedMap.h"
#include "PhotonTransport/transport/SkyOpenings.h"

#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include <algorithm>

using namespace Illumination;

namespace
{

constexpr const char* TooFewCells = "the refinement ended at the greatest number of cells, "
                                    "MaximumCells or what fits the memory: some "
                                    "edges miss the light by more than RefinementTolerance";

constexpr const char* Relit =
  "the map was relit without tracing: its photons were traced for lamps without Dimming, or with "
  "other fluxes or colours than the lamps have now";

} // namespace

void vtkIlluminationMap::WriteMap(const SceneBlocks& blocks,
  const PhotonTransport::Lighting& lighting, PhotonTransport::StopReason reason,
  vtkInformationVector* outputs)
{
  const PhotonTransport::IlluminationRun& run = this->Kept->Run;
  const MissingLight missing = FindMissingLight(
    { blocks, lighting, run, this->RegisterBackSide, this->MetresPerUnit }, reason);
  std::vector<std::string> notes = NotesOn(blocks, this->Kept->Scene);
  if (PhotonTransport::UsesOpenings(lighting, this->MakeTraceSettings()))
  {
    const std::vector<std::string> onOpenings =
      OpeningLines(this->Kept->Openings, this->Kept->Scene, PhotonTransport::HasSky(lighting));
    notes.insert(notes.end(), onOpenings.begin(), onOpenings.end());
  }
  if (run.IsOfOtherShares())
  {
    notes.emplace_back(Relit);
  }
  notes.insert(notes.end(), missing.notes.begin(), missing.notes.end());
  const std::vector<std::string> onFiles = NotesOn(lighting);
  notes.insert(notes.end(), onFiles.begin(), onFiles.end());
  if (reason == PhotonTransport::StopReason::Paused && run.IsPreliminary())
  {
    notes.emplace_back("preliminary: the mean light on the triangles around each point, as the "
                       "first photons tell it, in white; light at the points themselves follows");
  }
  std::vector<std::string> warnings = WarningsOn(blocks, this->Kept->Scene);
  if (!missing.warning.empty())
  {
    warnings.push_back(missing.warning);
  }
  const std::optional<PhotonTransport::RefinedMap> refined =
    reason == PhotonTransport::StopReason::Paused ? std::nullopt : this->RefineMap(blocks);
  if (refined && refined->isCoarse)
  {
    notes.emplace_back(TooFewCells);
    warnings.emplace_back(TooFewCells);
  }
  const WantedArrays wanted{ this->RegisterBackSide, this->GroupMeans,
    this->LampContributions ? &lighting : nullptr };
  refined ? AddRefinedBlocks(blocks, this->Kept->Scene, *refined, wanted)
          : AddPointArrays(blocks, this->Kept->Scene, run, wanted);
  AddFieldData(vtkDataObject::GetData(outputs)->GetFieldData(), run, reason, notes);
  const bool ownLamp = lighting.luminaires.front().name.empty(); // all others have been named
  this->RememberSettings(vtkDataObject::GetData(outputs)->GetFieldData(), ownLamp);
  FillAccuracyTable(vtkTable::GetData(outputs, 1), run.Rounds());
  for (const std::string& warning : warnings)
  {
    if (reason != PhotonTransport::StopReason::Paused) // once, when the run is over
    {
      this->Warn(warning);
    }
  }
  AddArray(vtkDataObject::GetData(outputs)->GetFieldData(), "Warnings", warnings);
}

void vtkIlluminationMap::WritePhotons(const SceneBlocks& blocks,
  const PhotonTransport::Lighting& lighting, vtkInformationVector* outputs)
{
  if (this->GetRanks().Index() != 0) // the first rank has the photons of all
  {
    vtkPolyData::GetData(outputs, 2)->Initialize();
    vtkPolyData::GetData(outputs, 3)->Initialize();
    return;
  }
  const PhotonSource source{ blocks, lighting, this->Kept->Scene, this->Kept->Run };
  FillPhotons(
    source, static_cast<std::uint64_t>(this->MaximumPhotons),
    [report = ProgressReport(this)](std::uint64_t hits) mutable
    { return report(1.0, "Storing photons, " + std::to_string(hits) + " hits"); },
    vtkPolyData::GetData(outputs, 2));
  FillPhotonPaths(
    source, static_cast<std::uint64_t>(this->PhotonPaths), vtkPolyData::GetData(outputs, 3));
}

std::optional<PhotonTransport::RefinedMap> vtkIlluminationMap::RefineMap(const SceneBlocks& blocks)
{
  if (!this->AdaptiveRefinement || this->Method != FINAL_GATHERING)
  {
    return std::nullopt;
  }
  PhotonTransport::MemoryBudget& memory = this->Kept->Memory;
  memory.SetAdapted(0); // of an execution before
  PhotonTransport::AdaptiveLimits limits = this->MakeAdaptiveLimits();
  limits.facets = this->GetRanks().Least(std::min(limits.facets,
    PhotonTransport::MostAdaptiveFacets(this->MemoryLimitInBytes(), memory.Bytes())));
  const bool isCurved = this->Kept->Curved.IsRefined();
  std::optional<PhotonTransport::RefinedMap> refined =
    this->Kept->Run.Refine(isCurved ? this->Kept->Curved : blocks.Surface(), limits,
      [report = ProgressReport(this)](std::uint64_t points) mutable
      {
        return report(
          1.0, "Refining where light varies, " + std::to_string(points) + " points looked at");
      });
  memory.SetAdapted(refined ? refined->mostFacets : 0);
  return refined;
}
