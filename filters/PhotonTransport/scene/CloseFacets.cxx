// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/CloseFacets.h"

#include "PhotonTransport/scene/FacetLanes.h"
#include "PhotonTransport/scene/FacetOverlap.h"
#include "PhotonTransport/scene/FacetTree.h"
#include "PhotonTransport/scene/PlaneTriangle.h"
#include "PhotonTransport/scene/SharedPlanes.h"
#include "PhotonTransport/threads/Threads.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>

namespace PhotonTransport
{
namespace
{

/// Compares all facets with all that are near them.
class Comparison
{
public:
  Comparison(const LargeArray<glm::vec3>& positions, const LargeArray<Facet>& facets,
    const DataRounding& rounding, float planeCells)
    : Positions(positions)
    , Facets(facets)
    , Rounding(rounding)
    , PlaneCells(planeCells)
    , Tree(positions, facets, rounding)
    , Bits(facets.size())
  {
  }

  std::vector<std::uint8_t> Run()
  {
    ForEach(
      this->Tree.Groups(), [&](std::size_t group) { this->CompareGroup(group); }, 8);
    return { this->Bits.begin(), this->Bits.end() };
  }

private:
  void CompareGroup(std::size_t group)
  {
    const std::vector<std::size_t> near = this->Tree.GroupsNear(group);
    const std::size_t begin = group * FacetLeaf::Width;
    const std::size_t end = std::min(begin + FacetLeaf::Width, this->Tree.Leaves());
    for (std::size_t index = begin; index < end; ++index)
    {
      const OneLeaf leaf(this->Tree, index);
      for (const std::size_t other : near)
      {
        this->Tree.ForEachMeeting(
          other, index, leaf.box, [&](std::size_t o) { this->CompareLeaves(leaf, o); });
      }
    }
  }

  /// A leaf, to be compared with others.
  struct OneLeaf
  {
    OneLeaf(const FacetTree& tree, std::size_t leafIndex)
      : index(leafIndex)
      , leaf(tree.LeafAt(leafIndex))
      , box(tree.BoxOf(leafIndex))
      , bounds(this->leaf)
    {
      for (std::size_t i = 0; i < this->leaf.count; ++i)
      {
        this->ones[i] = OneFacet(this->leaf, this->bounds, i);
      }
    }

    std::size_t index;
    const FacetLeaf& leaf;
    FacetBox box;
    LeafBounds bounds;
    std::array<OneFacet, FacetLeaf::Width> ones;
  };

  void CompareLeaves(const OneLeaf& one, std::size_t other)
  {
    std::array<std::int32_t, FacetLeaf::Width> meets;
    if (!one.bounds.Meeting(this->Tree.BoxOf(other), meets))
    {
      return;
    }
    const FacetLeaf& leaf = this->Tree.LeafAt(other);
    const LeafBounds bounds(leaf);
    for (std::size_t h = 0; h < FacetLeaf::Halves; ++h)
    {
      const FourBits others = bounds.Meeting(one.box, h);
      if (!Any(others))
      {
        continue;
      }
      for (std::size_t i = 0; i < one.leaf.count; ++i)
      {
        if (meets[i] != 0)
        {
          // Each pair once.
          const FourBits wanted = other == one.index ? others & LanesAfter(i, h) : others;
          this->CompareWith(one.ones[i], one.leaf.facets[i], leaf, bounds, h, wanted);
        }
      }
    }
  }

  /// Compares a facet with those wanted of half a leaf.
  void CompareWith(const OneFacet& one, std::uint32_t facet, const FacetLeaf& leaf,
    const LeafBounds& bounds, std::size_t half, const FourBits& wanted)
  {
    const OneFacet::Neighbours found = one.NeighboursIn(leaf, bounds, half, wanted);
    for (std::size_t i = 0; i < 4 && Any(found.notBeside); ++i)
    {
      const std::uint32_t other = leaf.facets[4 * half + i];
      if (found.notBeside[i] != 0)
      {
        this->Mark(facet, other, MayBeBefore);
      }
      if (found.candidates[i] != 0)
      {
        this->Compare(facet, other);
      }
    }
  }

  void Mark(std::uint32_t one, std::uint32_t other, std::uint8_t bit)
  {
    for (const std::uint32_t facet : { one, other })
    {
      if ((this->Bits[facet].load(std::memory_order_relaxed) & bit) == 0)
      {
        this->Bits[facet].fetch_or(bit, std::memory_order_relaxed);
      }
    }
  }

  /// Sets the bits of both if one lies in the place of the other.
  void Compare(std::uint32_t one, std::uint32_t other)
  {
    const float cosine = glm::dot(this->Facets[one].normal, this->Facets[other].normal);
    const std::uint8_t bit = cosine > 0.0f ? FacesAlike : FacesOpposite;
    if ((this->Bits[one] & this->Bits[other] & bit) != 0)
    {
      return;
    }
    if (cosine > SameSheet ? this->MayOverlap(one, other)
                           : cosine < -SameSheet && this->MayBeTwoSheets(one, other))
    {
      this->Mark(one, other, bit);
    }
  }

  const glm::vec3& Corner(std::uint32_t facet, int corner) const
  {
    return this->Positions[this->Facets[facet].vertices[corner]];
  }

  PlaneTriangle Triangle(std::uint32_t facet, int axis) const
  {
    return { facet, this->Corner(facet, 0), this->Corner(facet, 1), this->Corner(facet, 2), axis };
  }

  bool MayOverlap(std::uint32_t one, std::uint32_t other) const
  {
    const int axis = BestAxis(this->Facets[one].normal);
    const PlaneTriangle a = this->Triangle(one, axis), b = this->Triangle(other, axis);
    return Meet(a, b) || (a.low == b.low && a.high == b.high); // copies may be slivers
  }

  /// Whether the one comes as close to the other one's plane as rays can't tell (Scene::FindFront).
  bool MayBeTwoSheets(std::uint32_t one, std::uint32_t other) const
  {
    constexpr float Reserve = 8.0f / static_cast<float>(MostExcess);
    const float near = Reserve * (this->Margin(one) + this->Margin(other));
    const glm::dvec3 normal(this->Facets[one].normal), place(this->Corner(one, 0));
    double low = std::numeric_limits<double>::max(), high = std::numeric_limits<double>::lowest();
    for (int c = 0; c < 3; ++c)
    {
      const double height = glm::dot(glm::dvec3(this->Corner(other, c)) - place, normal);
      low = std::min(low, height);
      high = std::max(high, height);
    }
    return low <= double{ near } && high >= -double{ near } &&
      ShareACell(this->Plane(one), this->Plane(other), this->PlaneCells);
  }

  FacetPlane Plane(std::uint32_t facet) const
  {
    return PlaneOf(this->Corner(facet, 0), this->Corner(facet, 1), this->Corner(facet, 2),
      this->Facets[facet].normal, this->Rounding);
  }

  float Margin(std::uint32_t facet) const
  {
    return MarginOf(
      { this->Corner(facet, 0), this->Corner(facet, 1), this->Corner(facet, 2) }, this->Rounding);
  }

  const LargeArray<glm::vec3>& Positions;
  const LargeArray<Facet>& Facets;
  const DataRounding& Rounding;
  float PlaneCells;
  FacetTree Tree;
  std::vector<std::atomic<std::uint8_t>> Bits;
};

} // namespace

std::vector<std::uint8_t> FindCloseFacets(const LargeArray<glm::vec3>& positions,
  const LargeArray<Facet>& facets, const DataRounding& rounding, float planeCells)
{
  return Comparison(positions, facets, rounding, planeCells).Run();
}

} // namespace PhotonTransport
