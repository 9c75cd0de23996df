// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/SharedPlaces.h"

#include "PhotonTransport/materials/MaterialProperties.h"
#include "PhotonTransport/scene/DoubleSheets.h"
#include "PhotonTransport/scene/OverlappingFacets.h"
#include "PhotonTransport/scene/ParallelFor.h"
#include "PhotonTransport/scene/PlaneTriangle.h"
#include "PhotonTransport/scene/Scene.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace PhotonTransport
{
namespace
{

/// Corners of a facet that another one has too, by index.
unsigned CornersOf(const glm::uvec3& facet, const glm::uvec3& other)
{
  unsigned corners = 0;
  for (int i = 0; i < 3; ++i)
  {
    const bool has = other.x == facet[i] || other.y == facet[i] || other.z == facet[i];
    corners |= has ? 1u << i : 0u;
  }
  return corners;
}

/// Whether the triangle holds a point, both seen along an axis. Triangles that are joined at an
/// edge share it out: a point is in one of them, never in both and never in none.
std::optional<glm::vec3> Inside(const glm::dvec3& point, const glm::dvec3 (&corners)[3], int axis)
{
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const auto twiceArea = [&](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& p)
  { return (b[u] - a[u]) * (p[v] - a[v]) - (b[v] - a[v]) * (p[u] - a[u]); };
  const double whole = twiceArea(corners[0], corners[1], corners[2]);
  glm::dvec3 parts;
  for (int i = 0; i < 3; ++i)
  {
    const glm::dvec3& a = corners[(i + 1) % 3];
    const glm::dvec3& b = corners[(i + 2) % 3];
    // The same bits from both sides: the edge always runs from its lesser end.
    const bool swapped = b[u] < a[u] || (b[u] == a[u] && b[v] < a[v]);
    const double left = swapped ? twiceArea(b, a, point) : twiceArea(a, b, point);
    const bool isLeft = left >= 0.0;
    if (isLeft != ((whole > 0.0) != swapped))
    {
      return std::nullopt;
    }
    parts[i] = std::fabs(left);
  }
  const double sum = parts.x + parts.y + parts.z;
  return sum > 0.0 ? std::optional(glm::vec3(parts / sum)) : std::nullopt;
}

void Keep(SharedPlaceNote& note, std::uint32_t first, std::uint32_t second, double area)
{
  const bool more = area > note.squareMetres ||
    (area == note.squareMetres &&
      (note.squareMetres == 0.0 || std::pair(first, second) < std::pair(note.first, note.second)));
  if (more)
  {
    note.first = first;
    note.second = second;
    note.squareMetres = area;
  }
}

} // namespace

void Scene::MarkSharedPlace(
  std::uint32_t first, std::uint32_t second, double area, bool copies, SharedPlaceNotes& notes)
{
  const auto mark = [&](SharedPlaceNote& note, unsigned bits, unsigned ofSecond)
  {
    this->Shared[first] = static_cast<std::uint8_t>(this->Shared[first] | bits);
    this->Shared[second] = static_cast<std::uint8_t>(this->Shared[second] | bits | ofSecond);
    Keep(note, first, second, area);
  };
  this->Shared.resize(this->FacetRecords.size(), 0);
  const bool bothShine = !this->FacetExitance.empty() && this->FacetExitance[first] > 0.0f &&
    this->FacetExitance[second] > 0.0f;
  if (copies)
  {
    mark(notes.copies, SharesPlace,
      IsCopy | CornersOf(this->FacetRecords[second].vertices, this->FacetRecords[first].vertices));
    if (!this->FacetExitance.empty()) // they shine once, as the brighter one
    {
      const bool secondIsBrighter = this->FacetExitance[second] > this->FacetExitance[first];
      this->FacetExitance[secondIsBrighter ? first : second] = 0.0f;
    }
  }
  else
  {
    mark(notes.inPart, SharesPlace | OverlapsInPart, 0);
    if (bothShine)
    {
      mark(notes.shineToo, ShinesToo, 0);
    }
  }
  const auto material = [&](std::uint32_t facet)
  { return ValuesOf(this->FacetMaterials[this->FacetMaterial[facet]]); };
  if (this->FacetMaterial[first] != this->FacetMaterial[second] &&
    material(first) != material(second))
  {
    mark(notes.unlikeMaterials, UnlikeMaterials, 0);
  }
}

void Scene::FindSharedPlaces(const std::vector<glm::vec3>& positions)
{
  std::vector<FacetPlane> planes(this->FacetRecords.size());
  std::vector<glm::uvec3> facets(this->FacetRecords.size());
  ParallelFor(0, planes.size(),
    [&](const tbb::blocked_range<std::uint64_t>& range)
    {
      for (std::uint64_t f = range.begin(); f < range.end(); ++f)
      {
        const Facet& facet = this->FacetRecords[f];
        const glm::uvec3& ids = facet.vertices;
        planes[f] = PlaneOf(positions[ids.x], positions[ids.y], positions[ids.z], facet.normal);
        facets[f] = ids;
      }
    });
  const std::vector<PlaneMember> groups = SharedPlanes(planes);
  this->DoubleSheets = FacetsOfDoubleSheets(planes, groups);
  SharedPlaceNotes& notes = this->Found.sharedPlaces;
  ForEachOverlap({ positions, facets, planes, groups },
    [&](const FacetOverlap& overlap)
    {
      this->MarkSharedPlace(overlap.first, overlap.second,
        overlap.area * this->SquareMetresPerSceneArea(), overlap.copies, notes);
    });
  const auto finish = [&](SharedPlaceNote& note, unsigned bit)
  {
    note.facets = static_cast<std::size_t>(std::count_if(this->Shared.begin(), this->Shared.end(),
      [&](std::uint8_t mark) { return (mark & bit) != 0; }));
    note.first = this->InSurface(note.first);
    note.second = this->InSurface(note.second);
  };
  finish(notes.copies, IsCopy);
  finish(notes.inPart, OverlapsInPart);
  finish(notes.unlikeMaterials, UnlikeMaterials);
  finish(notes.shineToo, ShinesToo);
}

void Scene::FindSharers(Hit& hit, std::vector<Sharer>& sharers) const
{
  sharers.clear();
  const Facet& met = this->FacetRecords[hit.facet];
  const glm::dvec3 weights(hit.barycentric);
  glm::dvec3 point(0.0);
  for (int c = 0; c < 3; ++c)
  {
    point += weights[c] / (weights.x + weights.y + weights.z) *
      glm::dvec3(this->VertexRecords[met.vertices[c]].position);
  }
  const double near = double{ SheetGap } * this->Reach(point);
  const int axis = BestAxis(met.normal);
  const auto look = [&](std::uint32_t f)
  {
    const Facet& facet = this->FacetRecords[f];
    if ((this->Shared[f] & SharesPlace) == 0 || !(glm::dot(met.normal, facet.normal) > SameSheet))
    {
      return;
    }
    const glm::dvec3 corners[3] = { glm::dvec3(this->VertexRecords[facet.vertices.x].position),
      glm::dvec3(this->VertexRecords[facet.vertices.y].position),
      glm::dvec3(this->VertexRecords[facet.vertices.z].position) };
    const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    const double gap = near + double{ CornerGap };
    if (std::fabs(glm::dot(point - corners[0], normal)) <= gap * glm::length(normal))
    {
      if (const auto there = Inside(point, corners, axis))
      {
        sharers.push_back({ f, *there, AllCorners & ~unsigned{ this->Shared[f] } });
      }
    }
  };
  this->Bvh->ForEachNear(glm::vec3(point), static_cast<float>(near + double{ CornerGap }), look);
  std::sort(sharers.begin(), sharers.end(),
    [](const Sharer& a, const Sharer& b) { return a.facet < b.facet; });
  sharers.erase(std::unique(sharers.begin(), sharers.end(),
                  [](const Sharer& a, const Sharer& b) { return a.facet == b.facet; }),
    sharers.end());
  if (sharers.size() < 2)
  {
    // The facet shares its place elsewhere, or rounding has put the point beside the others.
    sharers.assign(1, { hit.facet, hit.barycentric, AllCorners });
  }
  else if (sharers.back().facet != hit.facet)
  {
    hit.facet = sharers.back().facet;
    hit.barycentric = sharers.back().barycentric;
    hit.part = NoPart;
  }
}

} // namespace PhotonTransport
