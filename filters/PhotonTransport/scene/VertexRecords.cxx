// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/memory/HugePages.h"
#include "PhotonTransport/scene/FacetSide.h"
#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/threads/Threads.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{

/// What a facet has in the hat function of a vertex.
struct RingPart
{
  explicit RingPart(const glm::vec3& vector)
    : areaVector(vector)
    , area(glm::length(this->areaVector))
  {
  }
  glm::dvec3 areaVector;
  double area;
};

namespace
{

/// A vertex normal counts as that of its facets if the sine of its angle to them is below this.
constexpr float NoTilt = 1e-4f;

/// The record of a point that a refinement added: nothing but its position counts.
Vertex PointOfPatch(const glm::vec3& position)
{
  return { position, glm::vec3(0.0f), glm::vec3(0.0f), -1.0f, 1.0f };
}

/// What is to be noted of a vertex, as bits.
enum FoundAtVertex : std::uint8_t
{
  Tilted = 1,
  NoNormal = 2,      ///< The given one is zero or not finite.
  NormalInPlane = 4, ///< The given one is in the plane of all facets of the ring.
};

/// Why a given normal does not tell a front, so that the normal of the ring's fronts takes its
/// place; 0 if it does.
std::uint8_t WhyNotUsable(const glm::dvec3& givenNormal, const std::vector<RingPart>& ring)
{
  if (givenNormal == glm::dvec3(0.0))
  {
    return NoNormal;
  }
  const auto isInPlane = [&](const RingPart& part)
  { return std::fabs(glm::dot(givenNormal, part.areaVector)) <= InPlane * part.area; };
  return std::all_of(ring.begin(), ring.end(), isInPlane) ? NormalInPlane : 0;
}

} // namespace

/// The ring of each vertex: the facets of which its hat function covers a part. The corners of
/// copies are left out, whose light and area count once; see SharedPlace.
FacetRings Scene::RingsThatCount(std::size_t vertices) const
{
  return { vertices, this->FacetRecords.size(),
    [this](std::size_t i)
    {
      const auto f = static_cast<std::uint32_t>(i);
      glm::uvec3 kept = this->GivenVertices(f);
      if (this->Shared.empty() && this->GivenFacets.empty())
      {
        return kept; // all count, as nearly everywhere
      }
      for (int corner = 0; corner < 3; ++corner)
      {
        const bool isCopy = !this->Shared.empty() && ((this->Shared[f] >> corner) & 1u) != 0;
        if (isCopy || this->ShareOfCorner(f, corner) == 0.0f)
        {
          kept[corner] = NoVertex;
        }
      }
      return kept;
    } };
}

/// Three times the mean over a facet of the hat function of one of the given facet's corners.
float Scene::ShareOfCorner(std::uint32_t facet, int corner) const
{
  if (this->GivenFacets.empty())
  {
    return 1.0f;
  }
  const FacetTriangle& corners = this->GivenFacets[facet].origin.corners;
  return corners[0][corner] + corners[1][corner] + corners[2][corner];
}

/// The area vector of a facet by the share of a given vertex.
glm::vec3 Scene::SharedArea(std::uint32_t facet, std::uint32_t vertex) const
{
  const glm::uvec3& ids = this->GivenVertices(facet);
  const int corner = ids.x == vertex ? 0 : ids.y == vertex ? 1 : 2;
  return this->ShareOfCorner(facet, corner) * this->FacetAreas[facet];
}

/// Makes the lists that AreaInRing reads.
void Scene::AddRings(std::size_t vertices)
{
  this->Rings = this->RingsThatCount(vertices);
  if (this->GivenFacets.empty())
  {
    return;
  }
  ResizeOnHugePages(this->RingAreas, this->Rings.Length());
  ForEach(vertices,
    [&](std::size_t i)
    {
      const auto v = static_cast<std::uint32_t>(i);
      glm::vec3* area = this->RingAreas.data() + this->Rings.Begin(v);
      for (const std::uint32_t facet : this->Rings.Of(v))
      {
        *area++ = this->SharedArea(facet, v);
      }
    });
}

void Scene::AddVertices(const Surface& surface, const PlacedPoints& points)
{
  const LargeArray<glm::vec3>& positions = points.positions;
  const std::size_t onMap = surface.IsRefined() ? surface.given.points : positions.size();
  this->AddRings(onMap);
  ResizeOnHugePages(this->VertexRecords, positions.size());
  this->Areas.resize(onMap);
  std::vector<std::uint8_t> found(onMap);
  ParallelFor(
    0, positions.size(),
    [&](std::uint64_t begin, std::uint64_t end)
    {
      std::vector<RingPart> ring;
      for (auto v = static_cast<std::uint32_t>(begin); v < end; ++v)
      {
        if (v >= onMap)
        {
          this->VertexRecords[v] = PointOfPatch(positions[v]);
          continue;
        }
        ring.clear();
        for (std::size_t place = 0; place < this->RingSize(v); ++place)
        {
          ring.emplace_back(this->AreaInRing(v, place));
        }
        found[v] = this->MakeVertex(v, ring, points.normals[v], positions[v]);
      }
    },
    SimpleCalls);
  this->NoteVertices(found);
  this->MarkFlatFacets();
}

/// Registration asks the facet, whose record it has sooner than those of the vertices.
void Scene::MarkFlatFacets()
{
  ForEach(this->FacetRecords.size(),
    [this](std::size_t i)
    {
      const glm::uvec3& ids = this->GivenVertices(static_cast<std::uint32_t>(i));
      const auto isFlat = [&](int corner) { return this->VertexRecords[ids[corner]].IsFlat(); };
      if (isFlat(0) && isFlat(1) && isFlat(2))
      {
        this->FacetRecords[i].signedMargin = -this->FacetRecords[i].signedMargin;
      }
    });
}

/// @return What is to be noted of it, as FoundAtVertex.
std::uint8_t Scene::MakeVertex(std::uint32_t vertex, const std::vector<RingPart>& ring,
  const glm::dvec3& givenNormal, const glm::vec3& position)
{
  glm::dvec3 areaVectors(0.0);
  double areas = 0.0;
  for (const RingPart& part : ring)
  {
    areaVectors += part.areaVector;
    areas += part.area;
  }
  this->Areas[vertex] = areas / 3.0 * this->SquareMetresPerSceneArea();
  if (!(areas > 0.0))
  {
    this->VertexRecords[vertex] = { position, glm::vec3(0.0f), glm::vec3(0.0f), 2.0f, 0.0f };
    return 0;
  }

  const std::uint8_t replaced = WhyNotUsable(givenNormal, ring);
  const glm::dvec3 normal =
    replaced == 0 ? givenNormal : PhotonTransport::UsableNormal(areaVectors);
  double leastCosine = 1.0;
  for (const RingPart& part : ring)
  {
    leastCosine = std::min(leastCosine, glm::dot(normal, part.areaVector) / part.area);
  }
  const double sinTilt =
    leastCosine > 0.0 ? std::sqrt(std::max(0.0, 1.0 - leastCosine * leastCosine)) : 2.0;
  const bool flat = sinTilt <= NoTilt;
  this->VertexRecords[vertex] = { position, glm::vec3(normal), glm::vec3(areaVectors / areas),
    flat ? -1.0f : static_cast<float>(sinTilt), static_cast<float>(1.0 / areas) };
  return static_cast<std::uint8_t>(replaced | (flat ? 0 : Tilted));
}

void Scene::NoteVertices(const std::vector<std::uint8_t>& found)
{
  for (std::size_t v = 0; v < found.size(); ++v)
  {
    this->Found.tiltedVertices += (found[v] & Tilted) != 0;
    this->Found.replacedNormals += (found[v] & NoNormal) != 0;
    if ((found[v] & NormalInPlane) != 0)
    {
      this->Found.inPlaneNormals.Add(v);
    }
  }
}

} // namespace PhotonTransport
