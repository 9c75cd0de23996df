// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/PlaceKeys.h"

#include "PhotonTransport/memory/HugePages.h"
#include "PhotonTransport/threads/Threads.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cstddef>

namespace PhotonTransport
{
namespace
{

/// Spreads ten bits so that two free ones follow each.
std::uint32_t Spread(std::uint32_t bits)
{
  bits = (bits | bits << 16) & 0x030000ffu;
  bits = (bits | bits << 8) & 0x0300f00fu;
  bits = (bits | bits << 4) & 0x030c30c3u;
  return (bits | bits << 2) & 0x09249249u;
}

/// Large facets lie apart from small ones in the order, lest they make boxes around these large.
std::uint32_t SizeClass(const glm::vec3& extent)
{
  const float largest = std::max({ extent.x, extent.y, extent.z });
  return (largest < 0x1p-3f) + (largest < 0x1p-6f) + (largest < 0x1p-9f);
}

std::uint32_t CodeOf(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
  const glm::vec3 low = glm::min(a, glm::min(b, c)), high = glm::max(a, glm::max(b, c));
  // The middle is in [-1, 1].
  const glm::vec3 steps =
    glm::clamp(256.0f * (low + high) + 512.0f, glm::vec3(0.0f), glm::vec3(1023.0f));
  return SizeClass(high - low) << 30 | Spread(static_cast<std::uint32_t>(steps.x)) |
    Spread(static_cast<std::uint32_t>(steps.y)) << 1 |
    Spread(static_cast<std::uint32_t>(steps.z)) << 2;
}

constexpr unsigned DigitBits = 11;
constexpr std::size_t Digits = std::size_t{ 1 } << DigitBits;
using Counts = std::array<std::size_t, Digits>;

/// One pass of a radix sort: from one list into another, by the digit at `shift`.
void SortByDigit(const LargeArray<std::uint64_t>& from, LargeArray<std::uint64_t>& to,
  unsigned shift, std::vector<Counts>& counts)
{
  const std::size_t chunk = (from.size() + counts.size() - 1) / counts.size();
  const auto forEachKey = [&](std::size_t c, const auto& f)
  {
    const std::size_t end = std::min((c + 1) * chunk, from.size());
    for (std::size_t i = c * chunk; i < end; ++i)
    {
      f(from[i], (from[i] >> shift) & (Digits - 1));
    }
  };
  ForEach(
    counts.size(),
    [&](std::size_t c)
    {
      counts[c].fill(0);
      forEachKey(c, [&](std::uint64_t, std::size_t digit) { ++counts[c][digit]; });
    },
    1);
  std::size_t sum = 0;
  for (std::size_t digit = 0; digit < Digits; ++digit)
  {
    for (Counts& ofChunk : counts)
    {
      const std::size_t count = ofChunk[digit];
      ofChunk[digit] = sum;
      sum += count;
    }
  }
  ForEach(
    counts.size(),
    [&](std::size_t c)
    { forEachKey(c, [&](std::uint64_t key, std::size_t digit) { to[counts[c][digit]++] = key; }); },
    1);
}

} // namespace

void SortByUpperHalf(LargeArray<std::uint64_t>& keys)
{
  constexpr std::size_t PerChunk = 65536;
  const std::size_t most = 4 * MostThreadIndices();
  std::vector<Counts> counts(std::clamp<std::size_t>(keys.size() / PerChunk, 1, most));
  LargeArray<std::uint64_t> other;
  ResizeOnHugePages(other, keys.size());
  for (const unsigned shift : { 32u, 32u + DigitBits, 32u + 2 * DigitBits })
  {
    SortByDigit(keys, other, shift, counts);
    keys.swap(other);
  }
}

LargeArray<std::uint64_t> PlaceKeys(
  const LargeArray<glm::vec3>& positions, const LargeArray<Facet>& facets)
{
  LargeArray<std::uint64_t> keys;
  ResizeOnHugePages(keys, facets.size());
  ForEach(keys.size(),
    [&](std::size_t f)
    {
      const glm::uvec3& ids = facets[f].vertices;
      const std::uint64_t code = CodeOf(positions[ids.x], positions[ids.y], positions[ids.z]);
      keys[f] = code << 32 | f;
    });
  SortByUpperHalf(keys);
  return keys;
}

} // namespace PhotonTransport
