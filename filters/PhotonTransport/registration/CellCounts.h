// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/memory/HugePages.h"
#include "PhotonTransport/registration/CellSide.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace PhotonTransport
{

/// How many photons have met each side of each cell (see FacetCells). Where photons have colours
/// each counts OfColours, divided between the channels. The counts of disjoint sets of photons add
/// up.
struct CellCounts
{
  static constexpr std::uint32_t OfColours = 256;
  /// A sum of so many can be tripled without an overflow.
  static constexpr std::uint32_t Full = 1u << 30;

  CellCounts() = default;
  /// @param caustics Whether caustics are counted, too.
  CellCounts(std::size_t cells, std::size_t channelsOfLight, bool caustics)
    : channels(channelsOfLight)
  {
    ResizeOnHugePages(this->all, cells * 2 * channelsOfLight);
    ResizeOnHugePages(this->caustic, caustics ? this->all.size() : 0);
  }

  bool IsEmpty() const { return this->all.empty(); }
  /// What one photon counts, all channels together.
  std::uint32_t OfPhoton() const { return this->channels > 1 ? OfColours : 1; }
  /// Where the channels of a side begin.
  std::size_t PlaceOf(std::uint32_t cell, bool front) const
  {
    return SideIndex(cell, front) * this->channels;
  }

  std::size_t channels = 1;
  std::vector<std::uint32_t> all;     ///< [cell][front, back][channel]
  std::vector<std::uint32_t> caustic; ///< Those that mirrors, gloss and glass alone have sent here.

  bool AnyOn(bool front) const
  {
    for (std::size_t side = front ? 0 : 1; side * this->channels < this->all.size(); side += 2)
    {
      for (std::size_t c = 0; c < this->channels; ++c)
      {
        if (this->all[side * this->channels + c] > 0)
        {
          return true;
        }
      }
    }
    return false;
  }

  CellCounts& operator+=(const CellCounts& other)
  {
    const auto add = [](std::vector<std::uint32_t>& to, const std::vector<std::uint32_t>& from)
    { std::transform(to.begin(), to.end(), from.begin(), to.begin(), std::plus<>()); };
    add(this->all, other.all);
    add(this->caustic, other.caustic);
    return *this;
  }
  void Clear()
  {
    std::fill(this->all.begin(), this->all.end(), 0u);
    std::fill(this->caustic.begin(), this->caustic.end(), 0u);
  }
};

/// The same for each lamp apart.
struct LampCellCounts
{
  std::size_t lamps = 0;
  std::vector<std::uint32_t> all;     ///< [place in CellCounts::all][lamp]
  std::vector<std::uint32_t> caustic; ///< The same.

  LampCellCounts() = default;
  LampCellCounts(std::size_t numberOfLamps, const CellCounts& cells)
    : lamps(numberOfLamps)
    , all(cells.all.size() * numberOfLamps, 0)
    , caustic(cells.caustic.size() * numberOfLamps, 0)
  {
  }

  bool IsEmpty() const { return this->all.empty(); }
};

} // namespace PhotonTransport
