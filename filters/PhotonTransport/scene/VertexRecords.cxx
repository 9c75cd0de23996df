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

} // namespace

/// The ring of each vertex without the corners of copies, whose light and area count once; see
/// SharedPlace.
FacetRings Scene::RingsThatCount(std::size_t vertices) const
{
  std::vector<glm::uvec3> kept;
  kept.reserve(this->FacetRecords.size());
  for (const Facet& facet : this->FacetRecords)
  {
    kept.push_back(facet.vertices);
  }
  for (std::size_t f = 0; f < this->Shared.size(); ++f)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      if ((this->Shared[f] >> corner) & 1u)
      {
        kept[f][corner] = NoVertex;
      }
    }
  }
  return { vertices, kept };
}

void Scene::AddVertices(const Surface& surface, const std::vector<glm::vec3>& positions)
{
  const FacetRings rings = this->RingsThatCount(positions.size());
  std::size_t groups = 0; // growing by doubling would take three times the memory for a moment
  for (std::uint32_t v = 0; v < positions.size(); ++v)
  {
    const Range<std::uint32_t> ring = rings.Of(v);
    groups += static_cast<std::size_t>(ring.end() - ring.begin() + 3) / 4;
  }
  this->AreasByRing.reserve(groups);
  this->VertexRecords.reserve(positions.size());
  this->Areas.reserve(positions.size());
  this->FirstAreas.reserve(positions.size() + 1);
  this->FirstAreas.push_back(0);
  for (std::uint32_t v = 0; v < positions.size(); ++v)
  {
    this->AddRingAreas(rings.Of(v));
    this->AddVertex(rings.Of(v), PhotonTransport::UsableNormal(surface.normals[v]), positions[v]);
  }
}

void Scene::AddRingAreas(const Range<std::uint32_t>& ring)
{
  int place = 0;
  for (const std::uint32_t f : ring)
  {
    if (place == 0)
    {
      this->AreasByRing.push_back({});
    }
    RingAreas& four = this->AreasByRing.back();
    four.x[place] = this->FacetAreas[f].x;
    four.y[place] = this->FacetAreas[f].y;
    four.z[place] = this->FacetAreas[f].z;
    place = (place + 1) % 4;
  }
  this->FirstAreas.push_back(this->AreasByRing.size());
}

void Scene::AddVertex(
  const Range<std::uint32_t>& ring, const glm::dvec3& givenNormal, const glm::vec3& position)
{
  glm::dvec3 areaVectors(0.0);
  double areas = 0.0;
  for (const std::uint32_t f : ring)
  {
    areaVectors += glm::dvec3(this->FacetAreas[f]);
    areas += glm::length(glm::dvec3(this->FacetAreas[f]));
  }
  this->Areas.push_back(areas / 3.0 * this->SquareMetresPerSceneArea());
  if (!(areas > 0.0))
  {
    this->VertexRecords.push_back({ position, glm::vec3(0.0f), glm::vec3(0.0f), 2.0f, 0.0f });
    return;
  }

  const glm::dvec3 normal = this->UsableNormal(ring, givenNormal, areaVectors);
  double leastCosine = 1.0;
  for (const std::uint32_t f : ring)
  {
    leastCosine =
      std::min(leastCosine, glm::dot(normal, glm::normalize(glm::dvec3(this->FacetAreas[f]))));
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
  const Range<std::uint32_t>& ring, const glm::dvec3& givenNormal, const glm::dvec3& areaVectors)
{
  if (givenNormal == glm::dvec3(0.0))
  {
    ++this->Found.replacedNormals;
  }
  else if (std::all_of(ring.begin(), ring.end(),
             [&](std::uint32_t f)
             {
               const glm::dvec3 area(this->FacetAreas[f]);
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
