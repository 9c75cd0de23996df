// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/adaptive/AdaptiveLimits.h"

#include "PhotonTransport/scene/InvalidInput.h"

#include <cmath>
#include <string>

namespace PhotonTransport
{

void Validate(const AdaptiveLimits& limits)
{
  if (!(limits.tolerance > 0.0) || !std::isfinite(limits.tolerance))
  {
    throw InvalidInput(InvalidInput::Where::TraceSettings, 0,
      "the refinement tolerance is " + std::to_string(limits.tolerance) +
        "; it must be above 0 and finite");
  }
  if (limits.facets < 1)
  {
    throw InvalidInput(InvalidInput::Where::TraceSettings, 0,
      "the greatest number of cells is 0; it must be 1 or more");
  }
}

} // namespace PhotonTransport
