// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/threads/Ranks.h"

#include <algorithm>
#include <cstring>

namespace PhotonTransport
{

void Ranks::Sum(std::uint64_t*, std::size_t) {}

bool Ranks::Any(bool here)
{
  std::uint64_t ranks = here ? 1 : 0;
  this->Sum(&ranks, 1);
  return ranks > 0;
}

double Ranks::OfFirst(double here)
{
  double there = this->Index() == 0 ? here : 0.0;
  this->SumOne(there);
  return there;
}

std::uint64_t Ranks::Least(std::uint64_t here)
{
  std::vector<std::uint64_t> all(static_cast<std::size_t>(this->Number()), 0);
  all[static_cast<std::size_t>(this->Index())] = here;
  this->SumAll(all);
  return *std::min_element(all.begin(), all.end());
}

void Ranks::SumBytes(void* bytes, std::size_t count)
{
  if (!this->AreSeveral())
  {
    return;
  }
  constexpr std::size_t Word = sizeof(std::uint64_t);
  auto* next = static_cast<unsigned char*>(bytes);
  std::vector<std::uint64_t> words(std::min(MostAtOnce, (count + Word - 1) / Word));
  while (count > 0)
  {
    const std::size_t size = std::min(count, words.size() * Word);
    words[(size - 1) / Word] = 0; // which may be filled in part
    std::memcpy(words.data(), next, size);
    this->Sum(words.data(), (size + Word - 1) / Word);
    std::memcpy(next, words.data(), size);
    next += size;
    count -= size;
  }
}

} // namespace PhotonTransport
