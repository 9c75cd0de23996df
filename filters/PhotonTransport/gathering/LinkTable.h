// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// The light of a number of sides of cells, and from which other sides it comes. A table of all
/// sides is a list of these, so that no list is copied as it grows.
struct LinkTable
{
  std::size_t values = 1; ///< For each side and replicate: by channel and lamp.
  std::size_t channels = 1;
  std::vector<std::uint32_t> sides; ///< In the order in which they were found.
  std::vector<float> direct;        ///< [side][replicate][channel][lamp]
  std::vector<std::uint32_t> ends;  ///< [side][replicate] In links.
  /// Sides; once all are found, places among those of all tables.
  std::vector<std::uint32_t> links;
  std::vector<float> weights; ///< [link][channel]

  std::size_t Lamps() const { return this->values / this->channels; }
  std::uint64_t Bytes() const
  {
    return sizeof(float) *
      (this->sides.size() + this->direct.size() + this->ends.size() + this->links.size() +
        this->weights.size());
  }

  /// One table of several, which follow each other.
  static LinkTable Of(const std::vector<LinkTable>& parts)
  {
    LinkTable all;
    all.values = parts.front().values;
    all.channels = parts.front().channels;
    Append(parts, &LinkTable::sides, all);
    Append(parts, &LinkTable::direct, all);
    Append(parts, &LinkTable::links, all);
    Append(parts, &LinkTable::weights, all);
    all.ends.reserve(all.sides.size() * parts.front().ends.size() / parts.front().sides.size());
    std::uint32_t before = 0;
    for (const LinkTable& part : parts)
    {
      for (const std::uint32_t end : part.ends)
      {
        all.ends.push_back(before + end);
      }
      before += static_cast<std::uint32_t>(part.links.size());
    }
    return all;
  }

private:
  template <typename List>
  static void Append(const std::vector<LinkTable>& parts, List LinkTable::*list, LinkTable& all)
  {
    std::size_t size = 0;
    for (const LinkTable& part : parts)
    {
      size += (part.*list).size();
    }
    (all.*list).reserve(size);
    for (const LinkTable& part : parts)
    {
      (all.*list).insert((all.*list).end(), (part.*list).begin(), (part.*list).end());
    }
  }
};

} // namespace PhotonTransport
