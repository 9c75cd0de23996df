// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/DataRounding.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace PhotonTransport
{

/// Two sheets are in one place if they are this close, relative to the reach of a point
/// (Scene::Reach): a ray's distance to a sheet is rounded by as much. The rounding of the data
/// comes on top of that (DataRounding).
constexpr float SheetGap = 0x1p-20f;

/// Facets that overlap and face the same way may be farther apart by this, relative to the largest
/// coordinate of their corners: the corners are rounded, too. What the rounding of the data adds
/// is FacetPlane::rounding of both.
constexpr float CornerGap = 0x1p-23f;

/// Two planes that close count as one if the cosine between their normals is above this.
constexpr float SameSheet = 0.999f;

/// A facet's plane: any of its points, and its unit normal.
struct FacetPlane
{
  glm::vec3 point;
  glm::vec3 normal;
  /// By how much the rounding of the facet's corners may move that point of the plane which is
  /// nearest to the origin.
  float uncertainty = SheetGap;
  /// How far the facet may be off that plane by the rounding of the data, see DataRounding.
  float rounding = 0.0f;
};

/// A facet's plane through its rounded corners.
FacetPlane PlaneOf(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c,
  const glm::vec3& normal, const DataRounding& rounding);

/// Planes are told apart by cells of this many a scene unit, in which the point nearest to the
/// origin lies: as many as possible in which most of some planes can still be told apart.
/// @param planeOf The plane of each of so many facets.
float PlaneCellsPerUnit(std::size_t facets, const std::function<FacetPlane(std::size_t)>& planeOf,
  const DataRounding& rounding);

/// Whether two planes may lie in one cell, by their uncertainty.
bool ShareACell(const FacetPlane& one, const FacetPlane& other, float cellsPerUnit);

/// A facet in a group of facets whose planes are near each other, whichever way they face.
struct PlaneMember
{
  std::uint64_t group;
  std::uint32_t facet;
  bool operator<(const PlaneMember& other) const
  {
    return this->group != other.group ? this->group < other.group : this->facet < other.facet;
  }
};

/// Groups of two facets or more, one after the other, the facets of each in ascending order. Facets
/// whose planes are the same up to rounding are together in at least one group, if both are marked.
/// A group may also hold facets of other planes, and such as are not marked.
/// @param cellsPerUnit See PlaneCellsPerUnit.
std::vector<PlaneMember> SharedPlanes(const std::vector<FacetPlane>& planes,
  const std::vector<std::uint8_t>& marked, float cellsPerUnit);

/// Calls f(first, last) for each group.
template <typename F>
void ForEachGroup(const PlaneMember* first, const PlaneMember* end, const F& f)
{
  while (first != end)
  {
    const PlaneMember* last = std::find_if(
      first, end, [&](const PlaneMember& member) { return member.group != first->group; });
    f(first, last);
    first = last;
  }
}
template <typename F>
void ForEachGroup(const std::vector<PlaneMember>& members, const F& f)
{
  ForEachGroup(members.data(), members.data() + members.size(), f);
}

} // namespace PhotonTransport
