// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/CloseFacets.h"

#include "PhotonTransport/scene/FacetLanes.h"
#include "PhotonTransport/scene/FacetTree.h"
#include "PhotonTransport/scene/OverlappingFacets.h"
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

using Leaf = FacetTree::Leaf;

/// Compares all facets with all that are near them.
class Comparison
{
public:
  Comparison(const std::vector<glm::vec3>& positions, const LargeArray<Facet>& facets,
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
      this->Tree.Leaves(), [&](std::size_t leaf) { this->CompareLeaf(leaf); }, 64);
    return { this->Bits.begin(), this->Bits.end() };
  }

private:
  void CompareLeaf(std::size_t index)
  {
    const Leaf& leaf = this->Tree.LeafAt(index);
    std::array<OneFacet, FacetTree::Width> ones;
    for (std::size_t i = 0; i < leaf.count; ++i)
    {
      ones[i] = OneFacet(leaf, i);
    }
    const FacetTree::Box box = this->Tree.BoxOf(index);
    const LeafBounds bounds(leaf);
    std::array<std::int32_t, FacetTree::Width> meets;
    this->Tree.ForEachFrom(index, box,
      [&](std::size_t other)
      {
        const Leaf& otherLeaf = this->Tree.LeafAt(other);
        const LeafBounds ofOthers(otherLeaf);
        bounds.Meeting(this->Tree.BoxOf(other), meets);
        for (std::size_t h = 0; h < FacetTree::Halves; ++h)
        {
          const FourBits others = ofOthers.Meeting(box, h);
          if (!Any(others))
          {
            continue;
          }
          for (std::size_t i = 0; i < leaf.count; ++i)
          {
            if (meets[i] != 0)
            {
              // Each pair once.
              const FourBits wanted = other == index ? others & LanesAfter(i, h) : others;
              this->CompareWith(ones[i], leaf.facets[i], otherLeaf, ofOthers, h, wanted);
            }
          }
        }
      });
  }

  /// Compares a facet with those wanted of half a leaf.
  void CompareWith(const OneFacet& one, std::uint32_t facet, const Leaf& leaf,
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

  const std::vector<glm::vec3>& Positions;
  const LargeArray<Facet>& Facets;
  const DataRounding& Rounding;
  float PlaneCells;
  FacetTree Tree;
  std::vector<std::atomic<std::uint8_t>> Bits;
};

} // namespace

std::vector<std::uint8_t> FindCloseFacets(const std::vector<glm::vec3>& positions,
  const LargeArray<Facet>& facets, const DataRounding& rounding, float planeCells)
{
  return Comparison(positions, facets, rounding, planeCells).Run();
}

} // namespace PhotonTransport
