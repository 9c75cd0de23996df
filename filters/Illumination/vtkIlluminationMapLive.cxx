// SPDX-License-Identifier: BSD-3-Clause
// How the map is refined before the eyes of the user.
#include "vtkIlluminationMap.h"

#include "Illumination/map/KeptRun.h"
#include "Illumination/pipeline/Pipeline.h"
#include "Illumination/ranks/ControllerRanks.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

using namespace Illumination;

namespace
{

using PhotonTransport::StopReason;

/// The photons of the first map that is shown: some tenths of a second.
constexpr std::uint64_t FirstPicture = 1u << 16;

} // namespace

bool vtkIlluminationMap::GetNeedsUpdate()
{
  this->IsWatched = true;
  if (!this->Kept || !this->Kept->Background.IsDone())
  {
    return false;
  }
  this->Superclass::Modified(); // the run goes on
  return true;
}

/// Advances the kept run to its end, or to the next map that is shown. A run that has ended by the
/// same rules and is relit stays as it is, whatever error it has now.
StopReason vtkIlluminationMap::AdvanceRun(
  const PhotonTransport::StopRules& rules, const std::vector<double>& region)
{
  PhotonTransport::IlluminationRun& run = this->Kept->Run;
  const std::optional<EndedRun>& ended = this->Kept->Ended;
  const bool asksForNothing = ended && run.IsRelit() && ended->IsBy(rules, region);
  if (!this->GetRanks().Any(!asksForNothing))
  {
    run.ShareWith(this->GetRanks());
    return ended->reason;
  }
  PhotonTransport::StopRules next = rules;
  // Ranks would have to agree on when to look.
  const bool isLive = this->Progressive && this->IsWatched && !this->GetRanks().AreSeveral();
  // Light of lamps apart is not known before the second pass.
  const bool preliminary = isLive && run.IsPreliminary() && !this->LampContributions;
  if (isLive)
  {
    next.photons = std::min(rules.photons, std::max(FirstPicture, run.Balance().emitted));
  }
  if (preliminary)
  {
    next.preliminary = true;
    next.relativeError = 0.0; // towards which the second pass counts
  }
  run.ShareWith(this->GetRanks());
  const StopReason reason = run.Advance(next,
    [report = ProgressReport(this)](const PhotonTransport::RunProgress& progress) mutable
    {
      return report(progress.fraction,
        (progress.isGathering ? "Gathering light, " : "Tracing photons, ") +
          std::to_string(std::lround(progress.secondsLeft)) + " s left");
    });
  const bool goesOn = next.photons < rules.photons || (preliminary && run.IsPreliminary());
  if (reason == StopReason::PhotonLimit && goesOn)
  {
    return StopReason::Paused;
  }
  this->Kept->Ended = { rules, region, reason };
  return reason;
}

/// Goes on to twice the photons, or to the second pass if there is none yet.
void vtkIlluminationMap::StartBackground(PhotonTransport::StopRules rules)
{
  PhotonTransport::IlluminationRun& run = this->Kept->Run;
  run.WorkAlone(); // the ranks end with the execution
  const std::uint64_t emitted = run.Balance().emitted;
  rules.photons = std::min(rules.photons, run.IsPreliminary() ? emitted : 2 * emitted);
  this->Kept->Background.Start(std::move(rules));
}

void vtkIlluminationMap::StopBackground()
{
  if (this->Kept)
  {
    this->Kept->Background.Stop();
  }
}
