// SPDX-License-Identifier: BSD-3-Clause
// Comparisons of one facet with four others at a time, for CloseFacets.cxx.
#pragma once

#include "PhotonTransport/scene/FacetLeaf.h"
#include "PhotonTransport/scene/PlaneTriangle.h"

#include <glm/common.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace PhotonTransport
{

/// A little less than SameSheet: how a cosine is rounded depends on the order of its terms. Pairs
/// are looked at more closely.
constexpr float AboutSameSheet = 0.9989f;

/// Half of what Meet takes for a sliver, which leaves room for rounding.
constexpr float HalfSliver = 0.5f * SliverWidth;

/// So small facets, and those that are slivers themselves, are always looked at more closely.
constexpr float Tiny = 0x1p-24f;

/// The facets of half a leaf that come after one of the same leaf.
inline FourBits LanesAfter(std::size_t facet, std::size_t half)
{
  const auto first = static_cast<std::int32_t>(4 * half);
  const FourBits lanes = { first, first + 1, first + 2, first + 3 };
  return lanes > static_cast<std::int32_t>(facet);
}

/// One facet of a leaf, to be compared with others four at a time.
class OneFacet
{
public:
  OneFacet() = default;
  OneFacet(const FacetLeaf& leaf, const LeafBounds& bounds, std::size_t lane)
    : Bounds(bounds.BoxOf(lane))
  {
    const auto of = [&](const Four(&values)[FacetLeaf::Halves])
    { return values[lane / 4][lane % 4]; };
    this->Normal = { of(leaf.normals[0]), of(leaf.normals[1]), of(leaf.normals[2]) };
    std::array<glm::vec3, 3> corners;
    for (std::size_t c = 0; c < 3; ++c)
    {
      corners[c] = { of(leaf.corners[c][0]), of(leaf.corners[c][1]), of(leaf.corners[c][2]) };
    }
    const auto& [a, b, c] = corners;
    const glm::vec3 most = glm::max(glm::abs(a), glm::max(glm::abs(b), glm::abs(c)));
    this->Width = HalfSliver * std::max({ most.x, most.y, most.z });
    this->LookAlongAxis(corners);
  }

  /// What is said of half a leaf's facets.
  struct Neighbours
  {
    /// The boxes meet that of this one, and they face the same way and may have more than a sliver
    /// in common with it, or face the other way.
    FourBits candidates;
    /// These, and others whose boxes meet that of this one, but that face elsewhere.
    FourBits notBeside;
  };

  /// @param wanted Of these facets alone.
  Neighbours NeighboursIn(
    const FacetLeaf& leaf, const LeafBounds& bounds, std::size_t half, const FourBits& wanted) const
  {
    const FourBits near = wanted & bounds.Meeting(this->Bounds, half);
    if (!Any(near))
    {
      return { near, near };
    }
    const Four cosine = this->Normal.x * leaf.normals[0][half] +
      this->Normal.y * leaf.normals[1][half] + this->Normal.z * leaf.normals[2][half];
    const FourBits opposite = near & (cosine < -AboutSameSheet);
    const FourBits alike = near & (cosine > AboutSameSheet);
    if (this->IsSliver || !Any(alike))
    {
      return { alike | opposite, near };
    }
    FourBits left = alike & ~this->DividedByThis(leaf, half);
    if (Any(left))
    {
      left &= ~this->DividedByOthers(leaf, half);
    }
    return { left | opposite, near & ~(alike & ~left) };
  }

private:
  /// Corners and edges, counter-clockwise, in the plane that the normal's largest component leaves
  /// out.
  void LookAlongAxis(const std::array<glm::vec3, 3>& corners)
  {
    const int axis = BestAxis(this->Normal);
    this->AxisU = (axis + 1) % 3;
    this->AxisV = (axis + 2) % 3;
    float u[3], v[3];
    for (std::size_t i = 0; i < 3; ++i)
    {
      u[i] = corners[i][this->AxisU];
      v[i] = corners[i][this->AxisV];
      this->U[i] = FourTimes(u[i]);
      this->V[i] = FourTimes(v[i]);
    }
    float twiceArea = (u[1] - u[0]) * (v[2] - v[0]) - (v[1] - v[0]) * (u[2] - u[0]);
    const float sign = twiceArea < 0.0f ? -1.0f : 1.0f;
    twiceArea *= sign;
    float longest = 0.0f;
    for (int i = 0; i < 3; ++i)
    {
      const int next = (i + 1) % 3;
      const float alongU = sign * (u[next] - u[i]), alongV = sign * (v[next] - v[i]);
      this->AlongU[i] = FourTimes(alongU);
      this->AlongV[i] = FourTimes(alongV);
      const float length = std::max(std::fabs(alongU), std::fabs(alongV));
      const float fromFirst = i == 1 ? twiceArea : 0.0f; // the others end at the first corner
      this->Inmost[i] = FourTimes(this->Width * length - fromFirst);
      longest = std::max(longest, length);
    }
    this->IsSliver = longest < Tiny || twiceArea <= 4.0f * this->Width * longest;
  }

  /// Those that an edge of this one has on its outer side, up to half a sliver.
  FourBits DividedByThis(const FacetLeaf& leaf, std::size_t h) const
  {
    Four u[3], v[3]; // from the first corner
    for (int c = 0; c < 3; ++c)
    {
      u[c] = leaf.corners[c][this->AxisU][h] - this->U[0];
      v[c] = leaf.corners[c][this->AxisV][h] - this->V[0];
    }
    FourBits divided{};
    for (int i = 0; i < 3; ++i)
    {
      const auto side = [&](int c) { return this->AlongU[i] * v[c] - this->AlongV[i] * u[c]; };
      divided |= Largest(side(0), Largest(side(1), side(2))) <= this->Inmost[i];
    }
    return divided;
  }

  /// Those that have this one on the outer side of an edge.
  FourBits DividedByOthers(const FacetLeaf& leaf, std::size_t h) const
  {
    const auto along = [&](int axis, int from, int to)
    { return leaf.corners[to][axis][h] - leaf.corners[from][axis][h]; };
    const int u = this->AxisU, v = this->AxisV;
    const Four twiceArea = along(u, 0, 1) * along(v, 0, 2) - along(v, 0, 1) * along(u, 0, 2);
    const Four one = Four{} + 1.0f;
    const Four sign = twiceArea < 0.0f ? -one : one;
    FourBits divided{};
    for (int i = 0; i < 3; ++i)
    {
      const Four &au = leaf.corners[i][u][h], &av = leaf.corners[i][v][h];
      const Four alongU = sign * along(u, i, (i + 1) % 3), alongV = sign * along(v, i, (i + 1) % 3);
      const auto side = [&](int c)
      { return alongU * (this->V[c] - av) - alongV * (this->U[c] - au); };
      const Four length = Largest(Largest(alongU, -alongU), Largest(alongV, -alongV));
      divided |= Largest(side(0), Largest(side(1), side(2))) <= this->Width * length;
    }
    return divided;
  }

  glm::vec3 Normal;
  FacetBox Bounds;                       ///< With margins.
  Four U[3], V[3], AlongU[3], AlongV[3]; ///< Each number four times.
  float Width;                           ///< Half of the sliver that neighbours may have in common.
  Four Inmost[3]; ///< What is no farther inside an edge, times its length, is outside.
  int AxisU, AxisV;
  bool IsSliver;
};

} // namespace PhotonTransport
