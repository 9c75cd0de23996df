// SPDX-License-Identifier: BSD-3-Clause
#ifndef LimitedRefinement_h
#define LimitedRefinement_h

#include "PhotonTransport/refinement/Refinement.h"

#include <cstdint>
#include <memory>

namespace Illumination
{

/// A refinement of no more facets than are allowed.
struct LimitedRefinement
{
  std::unique_ptr<PhotonTransport::Refinement> refinement;
  PhotonTransport::RefinementLimits limits; ///< Those that served.
  bool widened;                             ///< Whether the limits that were given asked for more.
};

/// A refinement by the given limits, or, if these ask for more than `most` facets, by wider ones. A
/// mesh that has as many itself stays whole. The time it takes depends on `most`, however narrow
/// the limits are. @param mesh Must outlive the result.
LimitedRefinement LimitFacets(const PhotonTransport::TriangleMesh& mesh,
  const PhotonTransport::RefinementLimits& limits, std::uint64_t most);

} // namespace Illumination

#endif
