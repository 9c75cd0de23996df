// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/FacetTree.h"

#include "PhotonTransport/memory/HugePages.h"
#include "PhotonTransport/scene/OverlappingFacets.h"
#include "PhotonTransport/scene/PlaceKeys.h"
#include "PhotonTransport/scene/Ray.h"
#include "PhotonTransport/scene/SharedPlanes.h"
#include "PhotonTransport/threads/Threads.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cstring>
#include <limits>

namespace PhotonTransport
{
namespace
{

/// Farther off than anything in a scene with its margins.
constexpr float FarOff = 0x1p100f;

std::array<glm::vec3, 3> CornersOf(
  const std::vector<glm::vec3>& positions, const glm::uvec3& vertices)
{
  return { positions[vertices.x], positions[vertices.y], positions[vertices.z] };
}

using Lanes = std::array<float, FacetTree::Width>;

void Store(const Lanes& lanes, FacetTree::Four (&place)[FacetTree::Halves])
{
  static_assert(sizeof place == sizeof lanes);
  std::memcpy(place, lanes.data(), sizeof lanes);
}

/// @param keys Of the leaf's facets.
FacetTree::Leaf MakeLeaf(const std::vector<glm::vec3>& positions, const LargeArray<Facet>& facets,
  const DataRounding& rounding, const std::uint64_t* keys, std::size_t count)
{
  FacetTree::Leaf leaf;
  Lanes corners[3][3], normals[3];
  leaf.count = count;
  leaf.margin = 0.0f;
  for (std::size_t i = 0; i < FacetTree::Width; ++i)
  {
    leaf.facets[i] = NoFacet;
    std::array<glm::vec3, 3> places{ glm::vec3(FarOff), glm::vec3(FarOff), glm::vec3(FarOff) };
    glm::vec3 normal(0.0f);
    if (i < count)
    {
      leaf.facets[i] = IndexOfKey(keys[i]);
      const Facet& facet = facets[leaf.facets[i]];
      places = CornersOf(positions, facet.vertices);
      normal = facet.normal;
      leaf.margin = std::max(leaf.margin, MarginOf(places, rounding));
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      normals[axis][i] = normal[axis];
      for (std::size_t c = 0; c < 3; ++c)
      {
        corners[c][axis][i] = places[c][axis];
      }
    }
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    Store(normals[axis], leaf.normals[axis]);
    for (std::size_t c = 0; c < 3; ++c)
    {
      Store(corners[c][axis], leaf.corners[c][axis]);
    }
  }
  return leaf;
}

} // namespace

float MarginOf(const std::array<glm::vec3, 3>& corners, const DataRounding& rounding)
{
  glm::vec3 most(0.0f);
  double farthest = 0.0;
  for (const glm::vec3& corner : corners)
  {
    most = glm::max(most, glm::abs(corner));
    if (rounding.relative > 0.0)
    {
      farthest = std::max(farthest, glm::length(glm::dvec3(corner) - rounding.origin));
    }
  }
  const float reach = std::max({ most.x, most.y, most.z });
  const auto data = static_cast<float>(rounding.relative * farthest);
  const float single = static_cast<float>(2.0 * SingleHalfUnit) *
    static_cast<float>(glm::length(rounding.origin) + 2.0);
  return std::max(static_cast<float>(MostExcess) * ((SheetGap + CornerGap) * reach + data), single);
}

FacetTree::FacetTree(const std::vector<glm::vec3>& positions, const LargeArray<Facet>& facets,
  const DataRounding& rounding)
{
  const LargeArray<std::uint64_t> keys = PlaceKeys(positions, facets);
  ResizeOnHugePages(this->AllLeaves, (facets.size() + Width - 1) / Width);
  ForEach(this->AllLeaves.size(),
    [&](std::size_t leaf)
    {
      const std::size_t begin = leaf * Width;
      this->AllLeaves[leaf] = MakeLeaf(
        positions, facets, rounding, keys.data() + begin, std::min(Width, keys.size() - begin));
    });
  this->AddLevels();
}

FacetTree::Box FacetTree::Around(const Leaf& leaf) const
{
  Box box;
  for (int axis = 0; axis < 3; ++axis)
  {
    float low = std::numeric_limits<float>::max(), high = std::numeric_limits<float>::lowest();
    for (std::size_t i = 0; i < leaf.count; ++i)
    {
      for (const auto& corner : leaf.corners)
      {
        low = std::min(low, corner[axis][i / 4][i % 4]);
        high = std::max(high, corner[axis][i / 4][i % 4]);
      }
    }
    box.low[axis] = low - leaf.margin;
    box.high[axis] = high + leaf.margin;
  }
  return box;
}

void FacetTree::AddLevels()
{
  std::vector<Box> boxes(this->AllLeaves.size());
  ForEach(
    boxes.size(), [&](std::size_t leaf) { boxes[leaf] = this->Around(this->AllLeaves[leaf]); });
  do
  {
    std::vector<Node> nodes((boxes.size() + Width - 1) / Width);
    std::vector<Box> around(nodes.size());
    ForEach(nodes.size(),
      [&](std::size_t n)
      {
        around[n] = { glm::vec3(FarOff), glm::vec3(-FarOff) };
        Lanes low[3], high[3];
        for (std::size_t i = 0; i < Width; ++i)
        {
          const std::size_t child = Width * n + i;
          const Box box =
            child < boxes.size() ? boxes[child] : Box{ glm::vec3(FarOff), glm::vec3(-FarOff) };
          around[n].low = glm::min(around[n].low, box.low);
          around[n].high = glm::max(around[n].high, box.high);
          for (int axis = 0; axis < 3; ++axis)
          {
            low[axis][i] = box.low[axis];
            high[axis][i] = box.high[axis];
          }
        }
        for (int axis = 0; axis < 3; ++axis)
        {
          Store(low[axis], nodes[n].low[axis]);
          Store(high[axis], nodes[n].high[axis]);
        }
      });
    this->Levels.push_back(std::move(nodes));
    boxes = std::move(around);
  } while (boxes.size() > 1);
}

void FacetTree::Meeting(const Node& node, const Box& box, std::array<std::int32_t, Width>& meets)
{
  for (std::size_t h = 0; h < Halves; ++h)
  {
    const auto apart = (node.low[0][h] > box.high.x) | (node.high[0][h] < box.low.x) |
      (node.low[1][h] > box.high.y) | (node.high[1][h] < box.low.y) |
      (node.low[2][h] > box.high.z) | (node.high[2][h] < box.low.z);
    const auto together = ~apart;
    static_assert(sizeof together == 4 * sizeof(std::int32_t));
    std::memcpy(&meets[4 * h], &together, sizeof together);
  }
}

} // namespace PhotonTransport
