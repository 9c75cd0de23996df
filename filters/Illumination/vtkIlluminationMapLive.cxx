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
  if (isLive)
  {
    next.photons = std::min(rules.photons, std::max(FirstPicture, run.Balance().emitted));
  }
  run.ShareWith(this->GetRanks());
  const StopReason reason = run.Advance(next,
    [report = ProgressReport(this)](const PhotonTransport::RunProgress& progress) mutable
    {
      return report(progress.fraction,
        (progress.isGathering ? "Gathering light, " : "Tracing photons, ") +
          std::to_string(std::lround(progress.secondsLeft)) + " s left");
    });
  if (reason == StopReason::PhotonLimit && next.photons < rules.photons)
  {
    return StopReason::Paused;
  }
  this->Kept->Ended = { rules, region, reason };
  return reason;
}

/// Goes on to twice the photons.
void vtkIlluminationMap::StartBackground(PhotonTransport::StopRules rules)
{
  PhotonTransport::IlluminationRun& run = this->Kept->Run;
  run.WorkAlone(); // the ranks end with the execution
  rules.photons = std::min(rules.photons, 2 * run.Balance().emitted);
  this->Kept->Background.Start(std::move(rules));
}

void vtkIlluminationMap::StopBackground()
{
  if (this->Kept)
  {
    this->Kept->Background.Stop();
  }
}
