// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/geometry/FacetRings.h"
#include "PhotonTransport/geometry/Placement.h"
#include "PhotonTransport/materials/Material.h"
#include "PhotonTransport/scene/DataRounding.h"
#include "PhotonTransport/scene/Ray.h"
#include "PhotonTransport/scene/SceneNotes.h"
#include "PhotonTransport/scene/SceneRecords.h"
#include "PhotonTransport/scene/Surface.h"

#include <glm/vec3.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace PhotonTransport
{

class EmbreeScene;
struct FacetOverlap;
struct FacetPlane;
class NearOverlaps;
struct PlaneMember;
struct RingPart;

/// The validated, immutable scene: geometry in [-1, 1], per-facet and per-vertex records, BVH.
class Scene
{
public:
  /// Throws InvalidInput (see Validate) or std::runtime_error (Embree).
  explicit Scene(const Surface& surface);
  ~Scene();

  /// See EmbreeScene::Intersect.
  void Intersect(const Ray* rays, Hit* hits, std::size_t count) const;

  /// See EmbreeScene::FindOccluded.
  void FindOccluded(const Segment* segments, std::uint8_t* occluded, std::size_t count,
    bool neighbours = false) const;

  /// The segment between two places where rays may start, from the one where coordinates are finer:
  /// its direction is rounded relative to its length, which then is less than the clearance of the
  /// other place from facets (OriginOffset).
  Segment SegmentBetween(const glm::vec3& a, const glm::dvec3& b) const;

  /// See EmbreeScene::ForEachNear.
  void ForEachNear(
    const glm::vec3& point, float distance, const std::function<void(std::uint32_t)>& f) const;

  /// Where two sheets of a wall lie in one place, a ray may meet the wrong one. This moves a hit on
  /// the back of a facet to the facet in that place whose front the ray meets, and returns whether
  /// it moved the hit.
  bool PreferFront(const Ray& ray, Hit& hit) const
  {
    return !this->DoubleSheets.empty() && this->DoubleSheets[hit.facet] != 0 &&
      this->FindFront(ray, hit);
  }

  /// Whether other facets that face the same way may lie in the place of a hit.
  bool MaySharePlace(const Hit& hit) const
  {
    return !this->Shared.empty() && this->Shared[hit.facet] != 0;
  }
  /// Finds the facets in the place of a hit, its own among them; moves the hit to the last of them.
  void FindSharers(Hit& hit, std::vector<Sharer>& sharers) const;

  /// The size of the coordinates at a point, with which their rounding grows: the largest
  /// coordinate, or a least value next to the origin.
  template <typename Number>
  Number Reach(const glm::vec<3, Number>& point) const
  {
    return std::max(std::max(std::fabs(point.x), std::fabs(point.y)),
      std::max(std::fabs(point.z), Number{ this->LeastReach }));
  }

  /// Where a ray starts that leaves the point of a hit on the facet's front or back.
  glm::vec3 SafeOrigin(const Hit& hit, bool front) const;
  /// The same for any point of a facet, slower and a little less finely.
  /// @param lift Starts so much farther from the facet.
  glm::vec3 SafeOrigin(
    std::uint32_t facet, const glm::vec3& barycentric, bool front, float lift = 0.0f) const;

  // Bring a record into the cache ahead of its use. Always inlined, since GCC takes a function that
  // does nothing but prefetch for one without effect and leaves out its calls.
  [[gnu::always_inline]] inline void PrefetchFacet(const Hit& hit) const
  {
    if (hit)
    {
      __builtin_prefetch(&this->FacetRecords[hit.facet]);
      if (!this->GivenFacets.empty())
      {
        __builtin_prefetch(&this->GivenFacets[hit.facet]);
      }
    }
  }
  [[gnu::always_inline]] inline void PrefetchVertex(std::uint32_t vertex) const
  {
    __builtin_prefetch(&this->VertexRecords[vertex]);
  }
  // The first that AreaInRing reads for a vertex, and the rest if it lies elsewhere.
  [[gnu::always_inline]] inline void PrefetchRing(std::uint32_t vertex) const
  {
    if (this->RingAreas.empty())
    {
      __builtin_prefetch(this->Rings.Of(vertex).first);
    }
    else
    {
      __builtin_prefetch(&this->RingAreas[this->Rings.Begin(vertex)]);
    }
  }
  [[gnu::always_inline]] inline void PrefetchAreasOfRing(std::uint32_t vertex) const
  {
    if (this->RingAreas.empty())
    {
      for (const std::uint32_t facet : this->Rings.Of(vertex))
      {
        __builtin_prefetch(&this->FacetAreas[facet]);
      }
    }
  }

  const LargeArray<Facet>& Facets() const { return this->FacetRecords; }
  /// The vertices that light counts for come first. Those that a refinement added have no more than
  /// a position.
  const LargeArray<Vertex>& Vertices() const { return this->VertexRecords; }
  /// Vertices of the surface that the user gave: those of the map.
  std::size_t NumberOfMapVertices() const { return this->Areas.size(); }
  /// Facets of the surface that the user gave, without those that were left out.
  std::size_t NumberOfGivenFacets() const
  {
    return this->CountGiven([](std::uint32_t) { return true; });
  }
  /// In which those facets are traced that are large next to the origin; see PartsOfLargeFacets.
  std::size_t NumberOfParts() const;
  /// Where the light of a hit counts: on the given facet of which the hit one is a part.
  RegisteredPlace PlaceOnGiven(const Hit& hit) const
  {
    if (this->GivenFacets.empty())
    {
      return { this->FacetRecords[hit.facet].vertices, hit.barycentric };
    }
    const GivenFacet& given = this->GivenFacets[hit.facet];
    return { given.vertices, given.origin.InFacet(hit.barycentric) };
  }
  const glm::uvec3& GivenVertices(std::uint32_t facet) const
  {
    return this->GivenFacets.empty() ? this->FacetRecords[facet].vertices
                                     : this->GivenFacets[facet].vertices;
  }
  /// The index that a facet, or the one of which it is a part, has in the surface that the user
  /// gave.
  std::uint32_t InSurface(std::uint32_t facet) const;
  /// How many facets a vertex's ring has.
  std::size_t RingSize(std::uint32_t vertex) const
  {
    return this->Rings.Begin(vertex + 1) - this->Rings.Begin(vertex);
  }
  /// The area vector of the facet at a place of a vertex's ring, by the vertex's share of it.
  const glm::vec3& AreaInRing(std::uint32_t vertex, std::size_t place) const
  {
    return this->RingAreas.empty() ? this->FacetAreas[this->Rings.Of(vertex).first[place]]
                                   : this->RingAreas[this->Rings.Begin(vertex) + place];
  }
  /// For each vertex its ring, where facets have neither parts nor copies; else null.
  const FacetRings* WholeRings() const
  {
    return this->GivenFacets.empty() && this->Shared.empty() ? &this->Rings : nullptr;
  }
  /// Area vectors |a_f| n_f of the facets, scene units squared.
  const LargeArray<glm::vec3>& AreaVectors() const { return this->FacetAreas; }
  /// Surface::exitance of each facet. Of exact copies only the brightest one emits.
  const std::vector<Colour>& Exitance() const { return this->FacetExitance; }
  const std::vector<Material>& Materials() const { return this->FacetMaterials; }
  /// Index into Materials, by facet.
  const std::vector<std::uint32_t>& MaterialOfFacet() const { return this->FacetMaterial; }
  /// A_i = 1/3 sum |a_f| over the ring, m^2, of the vertices of the map. Parts of facets count by
  /// the mean of the vertex's barycentric coordinate over them.
  const std::vector<double>& VertexAreas() const { return this->Areas; }
  /// Scene area times this is in m^2.
  double SquareMetresPerSceneArea() const;
  const Placement& GetPlacement() const { return this->Place; }
  const DataRounding& GetRounding() const { return this->Rounding; }
  const SceneNotes& Notes() const { return this->Found; }

private:
  void RequireSize() const;
  void CountEffects();
  void AddFacets(const Surface& surface, const PlacedPoints& points);
  std::uint8_t MakeFacet(const Surface& surface, std::size_t facet, const PlacedPoints& points);
  void NoteFacets(const Surface& surface, const std::vector<std::uint8_t>& found);
  void LeaveOutFacets();
  /// The index of the given facet that a facet is a part of, or the facet's own.
  std::uint32_t GivenIndex(std::uint32_t facet) const
  {
    return this->GivenFacets.empty() ? facet : this->GivenFacets[facet].origin.facet;
  }
  /// How many given facets there are of which a part fulfils a condition.
  template <typename Condition>
  std::size_t CountGiven(const Condition& fulfils) const
  {
    std::size_t number = 0;
    std::uint32_t last = NoFacet;
    for (std::uint32_t f = 0; f < this->FacetRecords.size(); ++f)
    {
      if (fulfils(f))
      {
        number += this->GivenIndex(f) != last;
        last = this->GivenIndex(f);
      }
    }
    return number;
  }
  void AddVertices(const Surface& surface, const PlacedPoints& points);
  void MarkFlatFacets();
  FacetRings RingsThatCount(std::size_t vertices) const;
  void AddRings(std::size_t vertices);
  float ShareOfCorner(std::uint32_t facet, int corner) const;
  glm::vec3 SharedArea(std::uint32_t facet, std::uint32_t vertex) const;
  std::uint8_t MakeVertex(std::uint32_t vertex, const std::vector<RingPart>& ring,
    const glm::dvec3& givenNormal, const glm::vec3& position);
  void NoteVertices(const std::vector<std::uint8_t>& found);
  std::vector<std::uint8_t> FindSharedPlaces(const LargeArray<glm::vec3>& positions);
  void FindOverlaps(const LargeArray<glm::vec3>& positions, const std::vector<FacetPlane>& planes,
    const std::vector<PlaneMember>& groups);
  void FinishNotesOnSharedPlaces();
  void MarkSharedPlace(const FacetOverlap& overlap);
  void NoteOverlap(SharedPlaceNote& note, const FacetOverlap& overlap) const;
  void JoinNearOverlaps(NearOverlaps& near);
  float ApartFromSharers(std::uint32_t facet) const
  {
    return this->Apart.empty() ? 0.0f : this->Apart[facet];
  }
  bool FindFront(const Ray& ray, Hit& hit) const;
  struct PlaceOfHit;
  PlaceOfHit PlaceOf(const Hit& hit) const;
  std::optional<glm::vec3> WithinShared(std::uint32_t facet, const PlaceOfHit& place) const;
  glm::vec3 SafeOriginOnPart(const Hit& hit, bool front) const;
  glm::vec3 SafeOriginAt(const glm::vec3& point, const Hit& hit, bool front) const;
  void BuildBvh();
  bool MayHaveGap(std::uint32_t facet, const std::vector<std::uint8_t>& close) const;
  void FindThinGaps(const std::vector<std::uint8_t>& close);

  Placement Place;
  DataRounding Rounding;
  double MetresPerUnit;
  float LeastReach = 0x1p-16f;
  LargeArray<Facet> FacetRecords;
  std::vector<GivenFacet> GivenFacets; ///< One a facet of a refined surface; else empty.
  LargeArray<glm::vec3> FacetAreas;
  std::vector<Colour> FacetExitance;
  std::vector<Material> FacetMaterials;
  std::vector<std::uint32_t> FacetMaterial;
  FacetRings Rings; ///< Of the vertices of the map: the facets that count there.
  /// [place in the list of all rings] The area vector of a facet by the share of the vertex. Empty
  /// unless facets are parts of given ones: then rings are long, and what they need is far apart.
  LargeArray<glm::vec3> RingAreas;
  SceneNotes Found;
  std::vector<double> Areas;
  LargeArray<Vertex> VertexRecords;
  std::vector<std::uint8_t> DoubleSheets; ///< By facet; empty if there are none.
  std::vector<std::uint8_t> Shared; ///< Bits of SharedPlace, by facet; empty if none shares one.
  /// By facet: how far those that it shares its place with are off its plane at most; or empty.
  std::vector<float> Apart;
  std::vector<std::uint32_t> Dropped; ///< Facets of the surface that were left out.
  std::unique_ptr<EmbreeScene> Bvh;
};

} // namespace PhotonTransport
