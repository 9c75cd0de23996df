// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/SceneRecords.h"

#include <glm/vec3.hpp>

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// The facets in an order in which neighbours are close together: by size in four classes, and
/// along a space-filling curve. Each key has a facet's index in its lower half (IndexOfKey).
LargeArray<std::uint64_t> PlaceKeys(
  const LargeArray<glm::vec3>& positions, const LargeArray<Facet>& facets);

inline std::uint32_t IndexOfKey(std::uint64_t key)
{
  return static_cast<std::uint32_t>(key);
}

/// Sorts keys by their upper half; those that are equal there keep their order.
void SortByUpperHalf(LargeArray<std::uint64_t>& keys);

} // namespace PhotonTransport
