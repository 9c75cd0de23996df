// SPDX-License-Identifier: BSD-3-Clause
// What the tests of the second pass have in common.
#pragma once

#include "PhotonTransport/openings/Opening.h"
#include "PhotonTransport/transport/IlluminationRun.h"

#include <cstdint>
#include <vector>

/// Replicates of a run, from whose spread its standard errors come.
constexpr std::uint32_t GatheredReplicates = 8;

PhotonTransport::TraceSettings GatheringSettings(std::uint32_t rays, std::uint32_t seed = 1);

/// The map of the front of a whole run.
PhotonTransport::IlluminationMap GatheredFront(const PhotonTransport::Scene& scene,
  const PhotonTransport::Lighting& lighting, const PhotonTransport::TraceSettings& settings,
  std::uint64_t photons, const PhotonTransport::Openings& openings = {});

/// The second pass at some vertices of matt walls, with far more rays than all of them could get.
/// @param places Vertices; one that is named several times gets rays of its own each time.
/// @return [place] lx
std::vector<double> GatheredAt(const PhotonTransport::Scene& scene,
  const PhotonTransport::Lighting& lighting, const PhotonTransport::TraceSettings& settings,
  std::uint64_t photons, const std::vector<std::uint32_t>& places);

/// Mean of independent values, and its standard error.
struct MeanAndError
{
  double mean = 0.0, error = 0.0;
};
MeanAndError MeanOf(const std::vector<double>& values);

/// How errors compare with what standard errors tell, over seeds: values of one seed share the
/// first pass, so only seeds are independent.
struct ToldErrors
{
  MeanAndError square;  ///< Mean square of error over standard error.
  double covered = 0.0; ///< By the 95 % interval of Student's t, a share.
  double largest = 0.0; ///< Mean over seeds of the error over its standard error, at most.
};

/// @param values [seed][point] lx, and their standard errors.
/// @param expected [point]; if it is empty the mean over all seeds is.
ToldErrors CompareWithTold(const std::vector<std::vector<double>>& values,
  const std::vector<std::vector<double>>& errors, const std::vector<double>& expected);
