// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/memory/LargeArray.h"

#include <array>
#include <cstddef>

namespace PhotonTransport
{

/// N values a vertex that are filtered side by side. Columns of a size alone are not set.
template <std::size_t N>
using Columns = LargeArray<std::array<float, N>>;

} // namespace PhotonTransport
