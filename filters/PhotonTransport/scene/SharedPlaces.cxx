// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/SharedPlace.h"

#include "PhotonTransport/materials/MaterialProperties.h"
#include "PhotonTransport/scene/CloseFacets.h"
#include "PhotonTransport/scene/NearOverlaps.h"
#include "PhotonTransport/scene/OverlappingFacets.h"
#include "PhotonTransport/scene/PlaneTriangle.h"
#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/threads/Threads.h"

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

/// Barycentric coordinates of a point in a triangle, both seen along an axis; nothing for a point
/// outside. A point on the edge at which two triangles are joined is in exactly one of them.
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

void Scene::NoteOverlap(SharedPlaceNote& note, const FacetOverlap& overlap) const
{
  Keep(note, overlap.first, overlap.second, overlap.area * this->SquareMetresPerSceneArea());
  note.apart = std::max(note.apart, overlap.Apart() / this->Place.scale);
}

void Scene::MarkSharedPlace(const FacetOverlap& overlap)
{
  const std::uint32_t first = overlap.first, second = overlap.second;
  SharedPlaceNotes& notes = this->Found.sharedPlaces;
  const auto mark = [&](SharedPlaceNote& note, unsigned bits, unsigned ofSecond)
  {
    this->Shared[first] = static_cast<std::uint8_t>(this->Shared[first] | bits);
    this->Shared[second] = static_cast<std::uint8_t>(this->Shared[second] | bits | ofSecond);
    this->NoteOverlap(note, overlap);
  };
  this->Shared.resize(this->FacetRecords.size(), 0);
  this->Apart.resize(this->FacetRecords.size(), 0.0f);
  constexpr double Reserve = 1.01; // their planes may be inclined, see SameSheet
  const auto apart = static_cast<float>(Reserve * overlap.Apart());
  this->Apart[first] = std::max(this->Apart[first], apart);
  this->Apart[second] = std::max(this->Apart[second], apart);
  const auto exitance = [&](std::uint32_t facet)
  { return this->FacetExitance.empty() ? 0.0f : Luminous(this->FacetExitance[facet]); };
  if (overlap.copies)
  {
    mark(notes.copies, SharesPlace,
      IsCopy | CornersOf(this->GivenVertices(second), this->GivenVertices(first)));
    if (!this->FacetExitance.empty()) // they shine once, as the brighter one
    {
      const bool secondIsBrighter = exitance(second) > exitance(first);
      this->FacetExitance[secondIsBrighter ? first : second] = Colour(0.0f);
    }
  }
  else
  {
    mark(notes.inPart, SharesPlace | OverlapsInPart, 0);
    if (exitance(first) > 0.0f && exitance(second) > 0.0f)
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

/// Marks those that belong to sheets in one place, and notes those that are left to chance.
void Scene::JoinNearOverlaps(NearOverlaps& near)
{
  if (near.Empty())
  {
    return;
  }
  std::vector<std::uint32_t> inOnePlace;
  for (std::uint32_t f = 0; f < this->Shared.size(); ++f)
  {
    if ((this->Shared[f] & OverlapsInPart) != 0)
    {
      inOnePlace.push_back(f);
    }
  }
  for (const FacetOverlap& overlap : near.TakeJoined(inOnePlace))
  {
    this->MarkSharedPlace(overlap);
  }
  SharedPlaceNote& note = this->Found.sharedPlaces.leftToChance;
  std::vector<std::uint32_t> facets;
  for (const FacetOverlap& overlap : near.LeftToChance())
  {
    this->NoteOverlap(note, overlap);
    facets.insert(
      facets.end(), { this->GivenIndex(overlap.first), this->GivenIndex(overlap.second) });
  }
  std::sort(facets.begin(), facets.end());
  note.facets =
    static_cast<std::size_t>(std::unique(facets.begin(), facets.end()) - facets.begin());
}

/// @return What FindCloseFacets says.
std::vector<std::uint8_t> Scene::FindSharedPlaces(const LargeArray<glm::vec3>& positions)
{
  const auto having = [](const std::vector<std::uint8_t>& bits, std::uint8_t bit)
  {
    const auto only = [bit](std::uint8_t of) { return static_cast<std::uint8_t>(of & bit); };
    std::vector<std::uint8_t> some; // in nearly all scenes none
    if (std::any_of(bits.begin(), bits.end(), only))
    {
      some.resize(bits.size());
      std::transform(bits.begin(), bits.end(), some.begin(), only);
    }
    return some;
  };
  const auto planeOf = [&](std::size_t f)
  {
    const Facet& facet = this->FacetRecords[f];
    const glm::uvec3& ids = facet.vertices;
    return PlaneOf(
      positions[ids.x], positions[ids.y], positions[ids.z], facet.normal, this->Rounding);
  };
  const std::size_t facets = this->FacetRecords.size();
  const float cells = PlaneCellsPerUnit(facets, planeOf, this->Rounding);
  std::vector<std::uint8_t> close =
    FindCloseFacets(positions, this->FacetRecords, this->Rounding, cells);
  this->DoubleSheets = having(close, FacesOpposite);
  const std::vector<std::uint8_t> alike = having(close, FacesAlike);
  if (!alike.empty())
  {
    std::vector<FacetPlane> planes(facets);
    ForEach(facets, [&](std::size_t f) { planes[f] = planeOf(f); });
    this->FindOverlaps(positions, planes, SharedPlanes(planes, alike, cells));
  }
  this->FinishNotesOnSharedPlaces();
  return close;
}

void Scene::FindOverlaps(const LargeArray<glm::vec3>& positions,
  const std::vector<FacetPlane>& planes, const std::vector<PlaneMember>& groups)
{
  NearOverlaps near(positions, this->FacetRecords);
  ForEachOverlap({ positions, this->FacetRecords, planes, groups, this->Rounding },
    [&](const FacetOverlap& overlap)
    {
      if (overlap.excess <= 1.0)
      {
        this->MarkSharedPlace(overlap);
      }
      else
      {
        near.Add(overlap);
      }
    });
  this->JoinNearOverlaps(near);
}

void Scene::FinishNotesOnSharedPlaces()
{
  SharedPlaceNotes& notes = this->Found.sharedPlaces;
  const auto count = [&](SharedPlaceNote& note, unsigned bit)
  {
    note.facets = this->Shared.empty()
      ? 0
      : this->CountGiven([&](std::uint32_t f) { return (this->Shared[f] & bit) != 0; });
  };
  count(notes.copies, IsCopy);
  count(notes.inPart, OverlapsInPart);
  count(notes.unlikeMaterials, UnlikeMaterials);
  count(notes.shineToo, ShinesToo);
  for (SharedPlaceNote* note :
    { &notes.copies, &notes.inPart, &notes.unlikeMaterials, &notes.shineToo, &notes.leftToChance })
  {
    note->first = this->InSurface(note->first);
    note->second = this->InSurface(note->second);
  }
}

/// Where a hit is, and how far from there a facet may be that shares the place.
struct Scene::PlaceOfHit
{
  glm::dvec3 point;
  glm::vec3 normal; ///< Of the facet that was hit.
  double near;      ///< By rounding.
  double apart;     ///< As the facet that was hit and those in its place may be.
};

Scene::PlaceOfHit Scene::PlaceOf(const Hit& hit) const
{
  const Facet& met = this->FacetRecords[hit.facet];
  const glm::dvec3 weights(hit.barycentric);
  glm::dvec3 point(0.0);
  for (int c = 0; c < 3; ++c)
  {
    point += weights[c] / (weights.x + weights.y + weights.z) *
      glm::dvec3(this->VertexRecords[met.vertices[c]].position);
  }
  const double near = double{ SheetGap } * this->Reach(point) + double{ CornerGap };
  return { point, met.normal, near, double{ this->Apart[hit.facet] } };
}

/// The barycentric coordinates in a facet of a place that it shares, or nothing.
std::optional<glm::vec3> Scene::WithinShared(std::uint32_t f, const PlaceOfHit& place) const
{
  const Facet& facet = this->FacetRecords[f];
  if ((this->Shared[f] & SharesPlace) == 0 || !(glm::dot(place.normal, facet.normal) > SameSheet))
  {
    return std::nullopt;
  }
  const glm::dvec3 corners[3] = { glm::dvec3(this->VertexRecords[facet.vertices.x].position),
    glm::dvec3(this->VertexRecords[facet.vertices.y].position),
    glm::dvec3(this->VertexRecords[facet.vertices.z].position) };
  const glm::dvec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double gap = place.near + std::min(place.apart, double{ this->Apart[f] });
  return std::fabs(glm::dot(place.point - corners[0], normal)) <= gap * glm::length(normal)
    ? Inside(place.point, corners, BestAxis(place.normal))
    : std::nullopt;
}

void Scene::FindSharers(Hit& hit, std::vector<Sharer>& sharers) const
{
  sharers.clear();
  const PlaceOfHit place = this->PlaceOf(hit);
  const float lift = hit.part == NoPartButLifted ? hit.inPart.x : 0.0f; // see FindFront
  // Seen along the axis a facet may be farther from the point than its plane is.
  this->ForEachNear(glm::vec3(place.point), static_cast<float>(place.near + 2.0 * place.apart),
    [&](std::uint32_t f)
    {
      if (const auto there = this->WithinShared(f, place))
      {
        sharers.push_back({ f, *there, AllCorners & ~unsigned{ this->Shared[f] } });
      }
    });
  std::sort(sharers.begin(), sharers.end(),
    [](const Sharer& a, const Sharer& b) { return a.facet < b.facet; });
  sharers.erase(std::unique(sharers.begin(), sharers.end(),
                  [](const Sharer& a, const Sharer& b) { return a.facet == b.facet; }),
    sharers.end());
  if (sharers.size() < 2)
  {
    // The facet shares another part of its place, or rounding has put the point beside the others.
    sharers.assign(1, { hit.facet, hit.barycentric, AllCorners });
  }
  else if (sharers.back().facet != hit.facet)
  {
    hit.facet = sharers.back().facet;
    hit.barycentric = sharers.back().barycentric;
    hit.part = NoPart;
  }
  if (this->Apart[hit.facet] > 0.0f || lift > 0.0f)
  {
    hit.part = NoPartButLifted;
    hit.inPart = glm::vec3(lift);
  }
}

} // namespace PhotonTransport
