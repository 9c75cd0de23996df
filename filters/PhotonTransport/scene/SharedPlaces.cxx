// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/SharedPlace.h"

#include "PhotonTransport/materials/MaterialProperties.h"
#include "PhotonTransport/scene/CloseFacets.h"
#include "PhotonTransport/scene/NearOverlaps.h"
#include "PhotonTransport/scene/OverlappingFacets.h"
#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/threads/Threads.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
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

} // namespace PhotonTransport
