// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// The light of a number of sides of cells, and from which other sides it comes.
struct LinkTable
{
  std::size_t values = 1; ///< For each side and replicate: by channel and lamp.
  std::size_t channels = 1;
  std::vector<std::uint32_t> sides; ///< In the order in which they were found.
  std::vector<float> direct;        ///< [side][replicate][channel][lamp]
  std::vector<std::uint64_t> ends;  ///< [side][replicate] In links.
  std::vector<std::uint32_t> links; ///< Sides; once all are found, places in `sides`.
  std::vector<float> weights;       ///< [link][channel]

  std::size_t Lamps() const { return this->values / this->channels; }

  /// Of one side, without its links.
  static std::uint64_t BytesPerSide(std::size_t replicates, std::size_t values)
  {
    return sizeof(std::uint32_t) + replicates * (values * sizeof(float) + sizeof(std::uint64_t));
  }
  static std::uint64_t BytesPerLink(std::size_t channels)
  {
    return sizeof(std::uint32_t) + channels * sizeof(float);
  }

  /// Room for so many sides, so that their lists are not copied as they grow.
  void Reserve(std::size_t numberOfSides, std::size_t replicates, std::size_t linksOfReplicate)
  {
    const std::size_t rows = numberOfSides * replicates;
    this->sides.reserve(numberOfSides);
    this->direct.reserve(rows * this->values);
    this->ends.reserve(rows);
    this->links.reserve(rows * linksOfReplicate);
    this->weights.reserve(rows * linksOfReplicate * this->channels);
  }

  void Append(const LinkTable& more)
  {
    const std::uint64_t before = this->links.size();
    const auto append = [](auto& to, const auto& from)
    { to.insert(to.end(), from.begin(), from.end()); };
    append(this->sides, more.sides);
    append(this->direct, more.direct);
    append(this->links, more.links);
    append(this->weights, more.weights);
    for (const std::uint64_t end : more.ends)
    {
      this->ends.push_back(before + end);
    }
  }
};

} // namespace PhotonTransport
