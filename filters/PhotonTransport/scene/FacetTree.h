// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/DataRounding.h"
#include "PhotonTransport/scene/SceneRecords.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// Facets in groups of eight that are close together, and boxes around eight groups, around eight
/// of these, and so on. It finds which facets come close to which, for all of them, in a fraction
/// of the time that single queries take.
class FacetTree
{
public:
  static constexpr std::size_t Width = 8;

  /// Four numbers side by side.
  using Four = float __attribute__((vector_size(16)));
  static constexpr std::size_t Halves = Width / 4;

  /// Eight facets. Those that are missing in the last group have corners far off.
  struct Leaf
  {
    Four corners[3][3][Halves]; ///< [corner][axis]
    Four normals[3][Halves];    ///< [axis]
    std::array<std::uint32_t, Width> facets;
    std::size_t count;
    float margin; ///< The largest of the facets, see MarginOf.
  };

  struct Box
  {
    glm::vec3 low, high;
  };

  /// @param positions Of vertices. @param rounding Of the data.
  FacetTree(const std::vector<glm::vec3>& positions, const LargeArray<Facet>& facets,
    const DataRounding& rounding);

  std::size_t Leaves() const { return this->AllLeaves.size(); }
  const Leaf& LeafAt(std::size_t leaf) const { return this->AllLeaves[leaf]; }
  /// Around its facets with their margins.
  Box BoxOf(std::size_t leaf) const
  {
    const Node& node = this->Levels.front()[leaf / Width];
    const std::size_t half = leaf % Width / 4, lane = leaf % 4;
    return { { node.low[0][half][lane], node.low[1][half][lane], node.low[2][half][lane] },
      { node.high[0][half][lane], node.high[1][half][lane], node.high[2][half][lane] } };
  }

  /// Calls f(leaf) for all leaves from `first` on whose boxes meet a box.
  template <typename F>
  void ForEachFrom(std::size_t first, const Box& box, const F& f) const
  {
    this->Descend(this->Levels.size() - 1, 0, first, box, f);
  }

private:
  /// The boxes of eight leaves or eight nodes of the level below.
  struct Node
  {
    Four low[3][Halves], high[3][Halves];
  };

  template <typename F>
  void Descend(
    std::size_t level, std::size_t node, std::size_t first, const Box& box, const F& f) const
  {
    const Node& boxes = this->Levels[level][node];
    std::array<std::int32_t, Width> meets;
    Meeting(boxes, box, meets);
    for (std::size_t i = 0; i < Width; ++i)
    {
      const std::size_t child = Width * node + i;
      if (meets[i] == 0 || (child + 1) << (3 * level) <= first)
      {
        continue;
      }
      if (level == 0)
      {
        f(child);
      }
      else
      {
        this->Descend(level - 1, child, first, box, f);
      }
    }
  }

  /// For each box of a node whether it meets another one.
  static void Meeting(const Node& node, const Box& box, std::array<std::int32_t, Width>& meets);
  void AddLevels();
  Box Around(const Leaf& leaf) const;

  LargeArray<Leaf> AllLeaves;
  std::vector<std::vector<Node>> Levels; ///< The first one has the boxes of leaves.
};

/// How far from a facet others may be, along its normal, that overlap it, see ForEachOverlap.
float MarginOf(const std::array<glm::vec3, 3>& corners, const DataRounding& rounding);

} // namespace PhotonTransport
