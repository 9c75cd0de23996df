// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/StopRules.h"

#include "PhotonTransport/scene/InvalidInput.h"

#include <cmath>
#include <string>

namespace PhotonTransport
{
namespace
{

[[noreturn]] void RefuseRule(const std::string& message)
{
  throw InvalidInput(InvalidInput::Where::TraceSettings, 0, message);
}

} // namespace

void Validate(const StopRules& rules)
{
  // The first round of so many photons can't fill a sum; ReplicateSums::AreFull looks after the
  // later ones.
  constexpr std::uint64_t MostPhotons = 10'000'000'000u;
  if (rules.photons < 1 || rules.photons > MostPhotons)
  {
    RefuseRule("the number of photons is " + std::to_string(rules.photons) +
      "; it must be between 1 and " + std::to_string(MostPhotons));
  }
  if (!(rules.relativeError >= 0.0) || !std::isfinite(rules.relativeError))
  {
    RefuseRule("the target relative error is " + std::to_string(rules.relativeError) +
      "; it must be 0 (no target) or more");
  }
  if (!(rules.seconds >= 0.0) || !std::isfinite(rules.seconds))
  {
    RefuseRule("the time limit is " + std::to_string(rules.seconds) +
      " s; it must be 0 (none) or more, and finite");
  }
}

} // namespace PhotonTransport
