// SPDX-License-Identifier: BSD-3-Clause
// Finds light that a map does not show, and says what that means and what to do.
#ifndef MissingLight_h
#define MissingLight_h

#include "PhotonTransport/transport/IlluminationRun.h"

#include <string>
#include <vector>

class vtkFieldData;

namespace Illumination
{

struct TracedScene;

/// What a run's user should know of light that did not arrive on fronts; see
/// PhotonTransport::Arrivals.
///
/// There is a warning for a lamp in the scene if more than 10 % of its light that met the surface
/// fell on backs that let no light through. Light that meets nothing is often meant to: a lamp over
/// a table may lose 98 %. So there is a warning only if more than 99 % of a lamp's light left the
/// scene, or, if the surface is closed, if more than 10 % left it or fell on backs. It is taken to
/// be closed if of 1000 or more scattered photons less than 1 in 1000 left the scene, and with
/// fewer photons if each edge belongs to two facets and the fronts look inward.
///
/// There is a warning for scattered light if more than 10 % of what met the surface fell on backs
/// and there is no other warning: a floor whose normals look down gets nothing, however little of a
/// lamp's light falls straight on it.
///
/// Parallel light and skies start over the whole scene, so that most of their light rightly meets
/// nothing or the outside of a building. There is a warning if less than 1 in 10^4 of what met the
/// surface fell on fronts and more than half on backs, as on a closed room, or if nothing met it.
///
/// A share exceeds its threshold if it does so by three standard errors of the photons that tell
/// it, so that few photons alone are no reason for a warning (ShareOfLight). Scattered light
/// outdoors is left out where light comes in through openings.
///
/// A warning also says that a run ended because nothing was lit (StopReason::NothingLit).
///
/// There is a note if more than 1 % of the light of all lamps in the scene that met the surface
/// fell on backs, or of the scattered light; if more than 10 % of the lamps' light left the scene;
/// if more than 10 % of the light from outside that met the surface fell on backs; if more than 1 %
/// of the light ended at the path length limit; and if all lamps together have no flux.
///
/// If backs are registered, light on them is not missing.
struct MissingLight
{
  std::string warning; ///< Empty where there is nothing to warn of.
  std::vector<std::string> notes;
};

MissingLight FindMissingLight(const TracedScene& traced, PhotonTransport::StopReason reason);

/// Adds FluxOnFronts, FluxOnBacks and FluxEscaped, lm, to a map's field data.
void AddArrivals(vtkFieldData* output, const PhotonTransport::IlluminationRun& run);

} // namespace Illumination

#endif
