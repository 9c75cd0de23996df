// SPDX-License-Identifier: BSD-3-Clause
// Photons as data sets: where they have hit, and the paths that they have taken.
#ifndef PhotonArrays_h
#define PhotonArrays_h

#include "PhotonTransport/transport/IlluminationRun.h"

#include <cstdint>
#include <functional>

class vtkPolyData;

namespace PhotonTransport
{
struct Lighting;
}

namespace Illumination
{

class SceneBlocks;

/// What photons are taken from.
struct PhotonSource
{
  const SceneBlocks& blocks;
  const PhotonTransport::Lighting& lighting;
  const PhotonTransport::Scene& scene;
  const PhotonTransport::IlluminationRun& run;
};

/// Throws InputError for numbers out of range. @param most MaximumPhotons. @param paths
/// PhotonPaths.
void RequirePhotonCounts(int most, int paths);

/// Replaces the output by a vertex for each hit of the first photons, of as many photons as have at
/// most `most` hits together; without any if that is 0. @param goOn See IlluminationRun::Photons.
void FillPhotons(const PhotonSource& source, std::uint64_t most,
  const std::function<bool(std::uint64_t hits)>& goOn, vtkPolyData* output);

/// Replaces the output by a polyline for each of the first photons.
void FillPhotonPaths(const PhotonSource& source, std::uint64_t photons, vtkPolyData* output);

} // namespace Illumination

#endif
