// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace PhotonTransport
{

/// What the second pass has found for one side: direct and gathered light, without caustics. One
/// value a place, lx. The first places are the vertices of the map.
struct GatheredMap
{
  std::vector<double> direct;
  std::vector<double> gathered;
  std::vector<double> standardError;
  std::vector<std::array<double, 3>> channels; ///< Luminous parts of all light; or empty.
  std::vector<double> ofLamps;                 ///< [place][lamp] Of all light; or empty.

  /// Adds places without light, or takes the last ones away.
  void Resize(std::size_t places, bool colour, std::size_t lamps)
  {
    this->direct.resize(places, 0.0);
    this->gathered.resize(places, 0.0);
    this->standardError.resize(places, 0.0);
    this->channels.resize(colour ? places : 0);
    this->ofLamps.resize(places * lamps, 0.0);
  }
};

} // namespace PhotonTransport
