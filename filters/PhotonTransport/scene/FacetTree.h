// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/DataRounding.h"
#include "PhotonTransport/scene/FacetLeaf.h"
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
  static constexpr std::size_t Width = FacetLeaf::Width;

  /// @param positions Of vertices. @param rounding Of the data.
  FacetTree(const LargeArray<glm::vec3>& positions, const LargeArray<Facet>& facets,
    const DataRounding& rounding);

  std::size_t Leaves() const { return this->AllLeaves.size(); }
  const FacetLeaf& LeafAt(std::size_t leaf) const { return this->AllLeaves[leaf]; }
  /// Around its facets' boxes, see LeafBounds.
  FacetBox BoxOf(std::size_t leaf) const { return BoxIn(this->Levels.front(), leaf); }

  /// Eight leaves that are close together make a group.
  std::size_t Groups() const { return this->Levels.front().size(); }

  /// The groups that have leaves whose boxes meet those of a group: the group itself and such that
  /// come after it.
  std::vector<std::size_t> GroupsNear(std::size_t group) const
  {
    if (this->Levels.size() == 1)
    {
      return { group };
    }
    std::vector<std::size_t> near;
    this->Descend(this->Levels.size() - 1, 0, group, BoxIn(this->Levels[1], group),
      [&](std::size_t other) { near.push_back(other); });
    return near;
  }

  /// Calls f(leaf) for the leaves of a group, from the leaf `first` on, whose boxes meet a box.
  template <typename F>
  void ForEachMeeting(std::size_t group, std::size_t first, const FacetBox& box, const F& f) const
  {
    ForEachChild(this->Levels.front()[group], box,
      [&](std::size_t i)
      {
        const std::size_t leaf = Width * group + i;
        if (leaf >= first)
        {
          f(leaf);
        }
      });
  }

private:
  /// The boxes of eight leaves or eight nodes of the level below.
  struct Node
  {
    Four low[3][FacetLeaf::Halves], high[3][FacetLeaf::Halves];
  };

  static FacetBox BoxIn(const std::vector<Node>& level, std::size_t child)
  {
    const Node& node = level[child / Width];
    const std::size_t half = child % Width / 4, lane = child % 4;
    return { { node.low[0][half][lane], node.low[1][half][lane], node.low[2][half][lane] },
      { node.high[0][half][lane], node.high[1][half][lane], node.high[2][half][lane] } };
  }

  /// Calls f(group) for groups from `first` on below a node.
  template <typename F>
  void Descend(
    std::size_t level, std::size_t node, std::size_t first, const FacetBox& box, const F& f) const
  {
    ForEachChild(this->Levels[level][node], box,
      [&](std::size_t i)
      {
        const std::size_t child = Width * node + i;
        if ((child + 1) << (3 * (level - 1)) <= first)
        {
          return; // all of its groups come before
        }
        if (level == 1)
        {
          f(child);
        }
        else
        {
          this->Descend(level - 1, child, first, box, f);
        }
      });
  }

  /// Calls f(i) for the boxes of a node that meet another one.
  template <typename F>
  static void ForEachChild(const Node& node, const FacetBox& box, const F& f)
  {
    for (std::size_t h = 0; h < FacetLeaf::Halves; ++h)
    {
      const FourBits meets = (node.low[0][h] < box.high.x) & (node.high[0][h] > box.low.x) &
        (node.low[1][h] < box.high.y) & (node.high[1][h] > box.low.y) &
        (node.low[2][h] < box.high.z) & (node.high[2][h] > box.low.z);
      for (std::size_t i = 0; i < 4 && Any(meets); ++i)
      {
        if (meets[i] != 0)
        {
          f(4 * h + i);
        }
      }
    }
  }

  void AddLevels();
  static FacetBox Around(const FacetLeaf& leaf);

  LargeArray<FacetLeaf> AllLeaves;
  std::vector<std::vector<Node>> Levels; ///< The first one has the boxes of leaves.
};

/// How far from a facet others may be, along its normal, that overlap it, see ForEachOverlap.
float MarginOf(const std::array<glm::vec3, 3>& corners, const DataRounding& rounding);

} // namespace PhotonTransport
