// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/FacetSide.h"
#include "PhotonTransport/scene/Scene.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{
namespace
{

/// A vertex normal counts as that of its facets if the sine of its angle to them is below this.
constexpr float NoTilt = 1e-4f;

/// The record of a point that a refinement added: nothing but its position counts.
Vertex PointOfPatch(const glm::vec3& position)
{
  return { position, glm::vec3(0.0f), glm::vec3(0.0f), -1.0f, 1.0f };
}

} // namespace

/// The ring of each vertex: the facets of which its hat function covers a part. The corners of
/// copies are left out, whose light and area count once; see SharedPlace.
FacetRings Scene::RingsThatCount(std::size_t vertices) const
{
  std::vector<glm::uvec3> kept(this->FacetRecords.size());
  for (std::uint32_t f = 0; f < kept.size(); ++f)
  {
    kept[f] = this->GivenVertices(f);
    for (int corner = 0; corner < 3; ++corner)
    {
      const bool isCopy = !this->Shared.empty() && ((this->Shared[f] >> corner) & 1u) != 0;
      if (isCopy || this->ShareOfCorner(f, corner) == 0.0f)
      {
        kept[f][corner] = NoVertex;
      }
    }
  }
  return { vertices, kept };
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

/// The area vectors of a vertex's ring, each by the vertex's share of its facet.
void Scene::FindAreasAround(
  std::uint32_t vertex, const FacetRings& rings, std::vector<glm::vec3>& areas) const
{
  areas.clear();
  for (const std::uint32_t f : rings.Of(vertex))
  {
    const glm::uvec3& ids = this->GivenVertices(f);
    const int corner = ids.x == vertex ? 0 : ids.y == vertex ? 1 : 2;
    areas.push_back(this->ShareOfCorner(f, corner) * this->FacetAreas[f]);
  }
}

void Scene::AddVertices(const Surface& surface, const std::vector<glm::vec3>& positions)
{
  const std::size_t onMap = surface.IsRefined() ? surface.given.points : positions.size();
  const FacetRings rings = this->RingsThatCount(onMap);
  std::size_t groups = 0; // growing by doubling would take three times the memory for a moment
  for (std::uint32_t v = 0; v < onMap; ++v)
  {
    const Range<std::uint32_t> ring = rings.Of(v);
    groups += static_cast<std::size_t>(ring.end() - ring.begin() + 3) / 4;
  }
  this->AreasByRing.reserve(groups);
  this->VertexRecords.reserve(positions.size());
  this->Areas.reserve(onMap);
  this->FirstAreas.reserve(onMap + 1);
  this->FirstAreas.push_back(0);
  std::vector<glm::vec3> ring;
  for (std::uint32_t v = 0; v < onMap; ++v)
  {
    this->FindAreasAround(v, rings, ring);
    this->AddRingAreas(ring);
    this->AddVertex(ring, PhotonTransport::UsableNormal(surface.normals[v]), positions[v]);
  }
  for (std::size_t v = onMap; v < positions.size(); ++v)
  {
    this->VertexRecords.push_back(PointOfPatch(positions[v]));
  }
}

void Scene::AddRingAreas(const std::vector<glm::vec3>& ring)
{
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    if (i % 4 == 0)
    {
      this->AreasByRing.push_back({});
    }
    RingAreas& four = this->AreasByRing.back();
    four.x[i % 4] = ring[i].x;
    four.y[i % 4] = ring[i].y;
    four.z[i % 4] = ring[i].z;
  }
  this->FirstAreas.push_back(this->AreasByRing.size());
}

void Scene::AddVertex(
  const std::vector<glm::vec3>& ring, const glm::dvec3& givenNormal, const glm::vec3& position)
{
  glm::dvec3 areaVectors(0.0);
  double areas = 0.0;
  for (const glm::vec3& area : ring)
  {
    areaVectors += glm::dvec3(area);
    areas += glm::length(glm::dvec3(area));
  }
  this->Areas.push_back(areas / 3.0 * this->SquareMetresPerSceneArea());
  if (!(areas > 0.0))
  {
    this->VertexRecords.push_back({ position, glm::vec3(0.0f), glm::vec3(0.0f), 2.0f, 0.0f });
    return;
  }

  const glm::dvec3 normal = this->UsableNormal(ring, givenNormal, areaVectors);
  double leastCosine = 1.0;
  for (const glm::vec3& area : ring)
  {
    leastCosine = std::min(leastCosine, glm::dot(normal, glm::normalize(glm::dvec3(area))));
  }
  const double sinTilt =
    leastCosine > 0.0 ? std::sqrt(std::max(0.0, 1.0 - leastCosine * leastCosine)) : 2.0;
  const bool flat = sinTilt <= NoTilt;
  this->Found.tiltedVertices += !flat;
  this->VertexRecords.push_back({ position, glm::vec3(normal), glm::vec3(areaVectors / areas),
    flat ? -1.0f : static_cast<float>(sinTilt), static_cast<float>(1.0 / areas) });
}

/// The given normal, or the normal of the ring's fronts if the given one does not tell a front.
glm::dvec3 Scene::UsableNormal(
  const std::vector<glm::vec3>& ring, const glm::dvec3& givenNormal, const glm::dvec3& areaVectors)
{
  if (givenNormal == glm::dvec3(0.0))
  {
    ++this->Found.replacedNormals;
  }
  else if (std::all_of(ring.begin(), ring.end(),
             [&](const glm::vec3& part)
             {
               const glm::dvec3 area(part);
               return std::fabs(glm::dot(givenNormal, area)) <= InPlane * glm::length(area);
             }))
  {
    this->Found.inPlaneNormals.Add(this->VertexRecords.size());
  }
  else
  {
    return givenNormal;
  }
  return PhotonTransport::UsableNormal(areaVectors);
}

} // namespace PhotonTransport
