// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/LightPieces.h"

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// Some pieces, by index.
struct PieceRange
{
  std::vector<std::uint32_t>::iterator begin, end;
};

/// Sorts pieces, two at least, into two groups that bounds tell much of: small and flat ones whose
/// pieces face about the same way. It is a function of the pieces and their order alone.
/// @return How many are in the first group; neither is empty.
std::uint32_t DividePieces(const std::vector<LightPiece>& pieces, const PieceRange& range);

} // namespace PhotonTransport
