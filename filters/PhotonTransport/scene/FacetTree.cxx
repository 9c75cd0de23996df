// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/FacetTree.h"

#include "PhotonTransport/memory/HugePages.h"
#include "PhotonTransport/scene/FacetLeaf.h"
#include "PhotonTransport/scene/FacetOverlap.h"
#include "PhotonTransport/scene/PlaceKeys.h"
#include "PhotonTransport/scene/Ray.h"
#include "PhotonTransport/scene/SharedPlanes.h"
#include "PhotonTransport/threads/Threads.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cstring>

namespace PhotonTransport
{
namespace
{

/// Farther off than anything in a scene with its margins.
constexpr float FarOff = 0x1p100f;

std::array<glm::vec3, 3> CornersOf(
  const LargeArray<glm::vec3>& positions, const glm::uvec3& vertices)
{
  return { positions[vertices.x], positions[vertices.y], positions[vertices.z] };
}

/// See MarginOf.
class Margin
{
public:
  explicit Margin(const DataRounding& rounding)
    : Rounding(rounding)
  {
  }

  /// The margin becomes no less than that of a facet.
  void Include(const std::array<glm::vec3, 3>& corners)
  {
    for (const glm::vec3& corner : corners)
    {
      this->Most = glm::max(this->Most, glm::abs(corner));
      if (this->Rounding.relative > 0.0)
      {
        this->Farthest =
          std::max(this->Farthest, glm::length(glm::dvec3(corner) - this->Rounding.origin));
      }
    }
  }

  float Value() const
  {
    const float reach = std::max({ this->Most.x, this->Most.y, this->Most.z });
    const auto data = static_cast<float>(this->Rounding.relative * this->Farthest);
    const float single = static_cast<float>(2.0 * SingleHalfUnit) *
      static_cast<float>(glm::length(this->Rounding.origin) + 2.0);
    return std::max(
      static_cast<float>(MostExcess) * ((SheetGap + CornerGap) * reach + data), single);
  }

private:
  const DataRounding& Rounding;
  glm::vec3 Most{ 0.0f }; ///< Largest coordinates.
  double Farthest = 0.0;  ///< From the data's origin.
};

using Lanes = std::array<float, FacetLeaf::Width>;

void Store(const Lanes& lanes, Four (&place)[FacetLeaf::Halves])
{
  static_assert(sizeof place == sizeof lanes);
  std::memcpy(place, lanes.data(), sizeof lanes);
}

/// @param keys Of the leaf's facets.
FacetLeaf MakeLeaf(const LargeArray<glm::vec3>& positions, const LargeArray<Facet>& facets,
  const DataRounding& rounding, const std::uint64_t* keys, std::size_t count)
{
  FacetLeaf leaf;
  Lanes corners[3][3], normals[3];
  leaf.count = count;
  Margin margin(rounding);
  for (std::size_t i = 0; i < FacetLeaf::Width; ++i)
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
      margin.Include(places);
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
  leaf.margin = margin.Value();
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
  Margin margin(rounding);
  margin.Include(corners);
  return margin.Value();
}

FacetTree::FacetTree(const LargeArray<glm::vec3>& positions, const LargeArray<Facet>& facets,
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

FacetBox FacetTree::Around(const FacetLeaf& leaf)
{
  const LeafBounds bounds(leaf);
  FacetBox box;
  for (int axis = 0; axis < 3; ++axis)
  {
    float low = FarOff, high = -FarOff;
    for (std::size_t i = 0; i < leaf.count; ++i)
    {
      low = std::min(low, bounds.low[axis][i / 4][i % 4]);
      high = std::max(high, bounds.high[axis][i / 4][i % 4]);
    }
    box.low[axis] = low;
    box.high[axis] = high;
  }
  return box;
}

void FacetTree::AddLevels()
{
  std::vector<FacetBox> boxes(this->AllLeaves.size());
  ForEach(boxes.size(), [&](std::size_t leaf) { boxes[leaf] = Around(this->AllLeaves[leaf]); });
  do
  {
    std::vector<Node> nodes((boxes.size() + Width - 1) / Width);
    std::vector<FacetBox> around(nodes.size());
    ForEach(nodes.size(),
      [&](std::size_t n)
      {
        around[n] = { glm::vec3(FarOff), glm::vec3(-FarOff) };
        Lanes low[3], high[3];
        for (std::size_t i = 0; i < Width; ++i)
        {
          const std::size_t child = Width * n + i;
          const FacetBox box =
            child < boxes.size() ? boxes[child] : FacetBox{ glm::vec3(FarOff), glm::vec3(-FarOff) };
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

} // namespace PhotonTransport
