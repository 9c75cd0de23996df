// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/MemoryLimit.h"

#include "PhotonTransport/scene/InvalidInput.h"

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>

namespace PhotonTransport
{
namespace
{

double GiB(std::uint64_t bytes)
{
  return static_cast<double>(bytes) * 0x1p-30;
}

/// The number after `key` in a file of the system; nothing if there is none.
std::optional<std::uint64_t> NumberIn(const char* file, const char* key)
{
  std::ifstream in(file);
  std::string word;
  while (*key != '\0' && in >> word && word != key)
  {
  }
  std::uint64_t number = 0;
  return in >> number ? std::optional(number) : std::nullopt;
}

/// Where Linux says what a control group (a container, say) may take: version 2, version 1.
struct ControlGroup
{
  const char *limit, *used, *statistics, *activeFiles, *inactiveFiles;
};
constexpr ControlGroup ControlGroups[] = {
  { "/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory.current", "/sys/fs/cgroup/memory.stat",
    "active_file", "inactive_file" },
  { "/sys/fs/cgroup/memory/memory.limit_in_bytes", "/sys/fs/cgroup/memory/memory.usage_in_bytes",
    "/sys/fs/cgroup/memory/memory.stat", "total_active_file", "total_inactive_file" }
};

} // namespace

std::optional<std::uint64_t> AvailableMemory()
{
  std::optional<std::uint64_t> available = NumberIn("/proc/meminfo", "MemAvailable:");
  if (!available)
  {
    return std::nullopt;
  }
  *available *= 1024; // given in KiB
  for (const ControlGroup& group : ControlGroups)
  {
    const auto limit = NumberIn(group.limit, ""); // "max" is no number and no limit
    const auto used = NumberIn(group.used, "");
    if (limit && used)
    {
      // What caches files is given up when memory is wanted.
      const std::uint64_t files = NumberIn(group.statistics, group.activeFiles).value_or(0) +
        NumberIn(group.statistics, group.inactiveFiles).value_or(0);
      const std::uint64_t held = *used - std::min(files, *used);
      available = std::min(*available, *limit - std::min(*limit, held));
    }
  }
  return available;
}

MemoryLimit::MemoryLimit(std::uint64_t limit)
  : IsGiven(limit > 0)
  , Most(limit > 0 ? std::optional(limit) : AvailableMemory())
{
}

void MemoryLimit::Require(std::uint64_t need) const
{
  if (!this->Allows(need))
  {
    std::ostringstream message;
    message.precision(3);
    message << "the run needs up to " << GiB(need) << " GiB of memory, and "
            << (this->IsGiven ? "its limit is " : "the machine has ") << GiB(*this->Most) << " GiB"
            << (this->IsGiven ? "" : " available");
    throw InvalidInput(InvalidInput::Where::TraceSettings, 0, message.str());
  }
}

} // namespace PhotonTransport
