// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/refinement/Refinement.h"

#include <cstdint>
#include <memory>

namespace PhotonTransport
{

/// A refinement of no more facets than are allowed.
struct LimitedRefinement
{
  std::unique_ptr<Refinement> refinement;
  RefinementLimits limits; ///< Those that served.
  bool widened;            ///< Whether the limits that were given asked for more.
};

/// A refinement by the given limits, or, if these ask for more than `most` facets, by wider ones. A
/// mesh that has as many itself stays whole. The time it takes depends on `most`, however narrow
/// the limits are. @param mesh Must outlive the result.
LimitedRefinement LimitFacets(
  const TriangleMesh& mesh, const RefinementLimits& limits, std::uint64_t most);

} // namespace PhotonTransport
