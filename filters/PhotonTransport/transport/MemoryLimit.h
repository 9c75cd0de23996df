// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>

namespace PhotonTransport
{

/// Bytes that this process can still take without being killed or swapped out, by what Linux and
/// its control groups say; nothing on other systems.
std::optional<std::uint64_t> AvailableMemory();

/// What a run may take in all.
class MemoryLimit
{
public:
  /// @param limit Bytes; 0 is AvailableMemory() as it is now, or no limit where that is not known.
  explicit MemoryLimit(std::uint64_t limit = 0);

  bool Allows(std::uint64_t need) const { return !this->Most || need <= *this->Most; }
  /// Throws InvalidInput that names both numbers if the need is above the limit.
  void Require(std::uint64_t need) const;

private:
  bool IsGiven;
  std::optional<std::uint64_t> Most;
};

} // namespace PhotonTransport
