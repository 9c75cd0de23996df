// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PointReference.h"

#include <cstdint>
#include <string>
#include <vector>

/// The light at some vertices of a scene.
struct StoredReference
{
  std::vector<std::uint32_t> vertices;
  std::vector<PointEstimate> estimates; ///< One a vertex.
  double seconds = 0.0;                 ///< What it took.
};

/// Throws std::runtime_error if the file can't be written.
void Store(const StoredReference& reference, const std::string& fileName);
/// Throws std::runtime_error if the file is not one that Store has written.
StoredReference LoadReference(const std::string& fileName);
