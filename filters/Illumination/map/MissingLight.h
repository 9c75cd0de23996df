// SPDX-License-Identifier: BSD-3-Clause
// Light that a map does not show is told, with what it means and what to do.
#ifndef MissingLight_h
#define MissingLight_h

#include "PhotonTransport/transport/IlluminationRun.h"

#include <string>
#include <vector>

class SceneBlocks;
class vtkFieldData;

/// What a run's user should know of light that did not arrive on fronts; see
/// PhotonTransport::Arrivals.
///
/// Lamps: a warning where more than a tenth of what met the surface fell on backs that let no light
/// through. Light that meets nothing is often meant to, as a lamp over a table loses nine tenths: a
/// warning only where more than 99 % of a lamp's light left the scene, or 90 % if the lamp is
/// farther from the surface than that is across, or a tenth if the surface is closed, so that no
/// scattered light leaves it. A note from a tenth on, for all lamps together.
///
/// Parallel light and skies start over the whole scene, so that most of it rightly meets nothing,
/// or the outside of a building: a warning where less than 1 in 10^4 of what met the surface fell
/// on fronts, as on a closed room, or where nothing met it.
///
/// Where backs are registered light on them is not missing.
struct MissingLight
{
  std::string warning; ///< Empty where there is nothing to warn of.
  std::vector<std::string> notes;
};

/// What a filter has traced, and what its user calls it.
struct TracedScene
{
  const SceneBlocks& blocks;
  const PhotonTransport::Lighting& lighting;
  const PhotonTransport::IlluminationRun& run;
  bool backSide;        ///< Whether backs are registered.
  double metresPerUnit; ///< As it was set.
};

MissingLight FindMissingLight(const TracedScene& traced, PhotonTransport::StopReason reason);

/// Adds FluxOnFronts, FluxOnBacks and FluxEscaped, lm, to a map's field data.
void AddArrivals(vtkFieldData* output, const PhotonTransport::IlluminationRun& run);

#endif
