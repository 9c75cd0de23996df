// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/transport/MemoryLimit.h"
#include "PhotonTransport/transport/MemoryNeed.h"

#include <cstdint>

namespace PhotonTransport
{

/// What a run needs of memory, beside what it may take. The need is known better as the run goes
/// on: the cells of a second pass once there is a scene, links between them while they are found.
/// Each time it is compared with the limit before the rest is taken.
class MemoryBudget
{
public:
  /// Throws InvalidInput if the need is more than the limit, as all that follows does.
  MemoryBudget(const MemoryNeed& need, const MemoryBeside& beside, const MemoryLimit& limit)
    : Need(need)
    , Beside(beside)
    , Limit(limit)
  {
    this->Limit.Require(this->Bytes());
  }

  std::uint64_t Bytes() const { return this->Need.Bytes(this->Beside); }
  const MemoryNeed& OfRun() const { return this->Need; }
  /// False once the run has been refused.
  bool IsKept() const { return this->Limit.Allows(this->Bytes()); }

  /// Another execution of a filter may want other arrays of the same run.
  void SetBeside(const MemoryBeside& beside) { this->Beside = beside; }
  /// See MemoryNeed; MostAdaptiveFacets keeps to the limit.
  void SetAdapted(std::uint64_t facets) { this->Need.SetAdapted(facets); }

  void KnowScene(std::uint64_t parts, std::uint64_t cells)
  {
    this->Need.SetScene(parts, cells);
    this->Limit.Require(this->Bytes());
  }
  void KnowLinks(std::uint64_t bytes)
  {
    this->Need.SetLinks(bytes);
    this->Limit.Require(this->Bytes());
  }

private:
  MemoryNeed Need;
  MemoryBeside Beside;
  MemoryLimit Limit;
};

} // namespace PhotonTransport
