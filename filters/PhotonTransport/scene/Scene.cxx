// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/Scene.h"

#include "PhotonTransport/scene/DoubleSheets.h"
#include "PhotonTransport/scene/FacetSide.h"
#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/scene/SharedPlanes.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace PhotonTransport
{
namespace
{

/// Scene units squared. A smaller facet has no area that its single-precision record could hold.
constexpr double LeastArea = std::numeric_limits<float>::min();

/// Below this sine of the angle to its facets a vertex normal counts as theirs.
constexpr float NoTilt = 1e-4f;

std::vector<glm::vec3> ScenePositions(const Surface& surface, const Placement& placement)
{
  std::vector<glm::vec3> positions(surface.points.size(), glm::vec3(0.0f));
  for (const glm::uvec3& facet : surface.facets)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      positions[facet[corner]] = glm::vec3(placement.PointToScene(surface.points[facet[corner]]));
    }
  }
  return positions;
}

/// Smallest barycentric coordinate that keeps EdgeClearance from every edge, by offset.
float MarginPerOffset(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, double area)
{
  const double longest = std::max({ glm::length(b - a), glm::length(c - b), glm::length(a - c) });
  const double smallestHeight = 2.0 * area / longest;
  constexpr double Most = std::numeric_limits<float>::max();
  return static_cast<float>(std::min(Most, double{ EdgeClearance } / smallestHeight));
}

/// Whether no edge can be longer than 1.5 times its distance from the origin: the nearest point of
/// the facet is nearer than a corner by the longest edge at most.
bool IsFarForItsSize(const glm::vec3& a, const glm::vec3& b, const glm::vec3& c)
{
  const glm::vec3 ab = b - a, bc = c - b, ca = a - c;
  const float longest = std::max(std::max(glm::dot(ab, ab), glm::dot(bc, bc)), glm::dot(ca, ca));
  constexpr float Lengths = 1.75f; // > 1 + 1 / 1.5
  return Lengths * Lengths * longest < glm::dot(a, a);
}

} // namespace

std::size_t MostParts(std::size_t facets)
{
  constexpr std::size_t Few = 16384;
  return std::max(Few, facets / 8);
}

Scene::Scene(const Surface& surface)
  : MetresPerUnit(surface.metresPerUnit)
{
  Validate(surface);
  this->Place = FitPlacement(surface.points, surface.facets);
  this->RequireSize();
  std::vector<glm::vec3> positions = ScenePositions(surface, this->Place);
  this->AddFacets(surface, positions);
  this->FindSharedPlaces(positions);
  this->AddVertices(surface, positions);
  this->BuildBvh(std::move(positions));
  ThinGaps& gaps = this->Found.thinGaps;
  gaps = FindThinGaps(*this);
  for (std::uint32_t* facet : { &gaps.facet, &gaps.other, &gaps.firstUnresolved })
  {
    *facet = this->InSurface(*facet);
  }
}

std::uint32_t Scene::InSurface(std::uint32_t facet) const
{
  for (const std::uint32_t dropped : this->Dropped)
  {
    facet += dropped <= facet;
  }
  return facet;
}

/// Areas must neither vanish nor overflow in m^2.
void Scene::RequireSize() const
{
  const double squareMetres = this->SquareMetresPerSceneArea();
  constexpr double MostFacets = 0x1p32;
  if (!std::isnormal(squareMetres * LeastArea / 3.0) || !std::isfinite(squareMetres * MostFacets))
  {
    std::ostringstream message;
    message << "the surface is about " << this->MetresPerUnit / this->Place.scale
            << " m across; its areas in m^2 are beyond what a number can hold";
    throw InvalidInput(InvalidInput::Where::Surface, 0, message.str());
  }
}

void Scene::AddFacets(const Surface& surface, const std::vector<glm::vec3>& positions)
{
  this->FacetRecords.reserve(surface.facets.size());
  this->FacetAreas.reserve(surface.facets.size());
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
  {
    const glm::uvec3& ids = surface.facets[f];
    // The rounded positions are the ones that photons hit, so areas and normals are theirs.
    const glm::dvec3 a(positions[ids[0]]), b(positions[ids[1]]), c(positions[ids[2]]);
    glm::dvec3 areaVector = 0.5 * glm::cross(b - a, c - a);
    const double area = glm::length(areaVector);
    if (!(area >= LeastArea))
    {
      ++this->Found.droppedFacets;
      this->Dropped.push_back(static_cast<std::uint32_t>(f));
      continue;
    }
    const FacetSide side = SideOf(
      areaVector, { surface.normals[ids.x], surface.normals[ids.y], surface.normals[ids.z] });
    if (side.turned)
    {
      areaVector = -areaVector;
      ++this->Found.turnedFacets;
    }
    if (side.undecided)
    {
      this->Found.undecidedFacets.Add(f);
    }
    const float reflectance = surface.materials.empty()
      ? surface.reflectance[f]
      : Luminous(surface.materials[surface.materialOfFacet[f]].diffuseReflectance);
    this->FacetRecords.push_back(
      { ids, reflectance, glm::vec3(areaVector / area), MarginPerOffset(a, b, c, area) });
    this->FacetAreas.emplace_back(areaVector);
    this->AddFacetLight(surface, f);
  }
  this->FacetMaterials = surface.materials;
  this->CountScatterings();
  if (this->FacetRecords.empty())
  {
    throw InvalidInput(InvalidInput::Where::Surface, 0, "every triangle has zero area");
  }
}

void Scene::AddFacetLight(const Surface& surface, std::size_t facet)
{
  if (!surface.materials.empty())
  {
    this->FacetMaterial.push_back(surface.materialOfFacet[facet]);
  }
  if (!surface.exitance.empty())
  {
    this->FacetExitance.push_back(surface.exitance[facet]);
  }
  if (!surface.exitanceColour.empty())
  {
    this->FacetExitanceColour.push_back(surface.exitanceColour[facet]);
  }
}

/// Which facets call for which effects.
void Scene::CountScatterings()
{
  std::vector<ScatteringSet> ways(this->FacetMaterials.size());
  std::transform(
    this->FacetMaterials.begin(), this->FacetMaterials.end(), ways.begin(), ScatteringsOf);
  for (std::size_t f = 0; f < this->FacetRecords.size(); ++f)
  {
    const bool diffuse = this->FacetRecords[f].reflectance > 0.0f;
    const ScatteringSet set = ways.empty() ? (diffuse ? SetOf(Scattering::DiffuseReflection) : 0u)
                                           : ways[this->FacetMaterial[f]];
    for (unsigned s = 0; s < Scatterings; ++s)
    {
      this->Found.scatteringFacets[s] += (set >> s) & 1u;
    }
    const bool coloured =
      (!ways.empty() && IsColoured(this->FacetMaterials[this->FacetMaterial[f]])) ||
      (!this->FacetExitanceColour.empty() && !IsGrey(this->FacetExitanceColour[f]));
    this->Found.colouredFacets += coloured;
  }
}

void Scene::AddVertices(const Surface& surface, const std::vector<glm::vec3>& positions)
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
  this->VertexRings = FacetRings(positions.size(), kept);

  this->VertexRecords.reserve(positions.size());
  this->Areas.reserve(positions.size());
  this->FirstAreas.reserve(positions.size() + 1);
  this->FirstAreas.push_back(0);
  this->ReserveRingAreas(positions.size());
  for (std::uint32_t v = 0; v < positions.size(); ++v)
  {
    this->AddRingAreas(v);
    this->VertexRecords.push_back(
      this->MakeVertex(v, UsableNormal(surface.normals[v]), positions[v]));
  }
}

/// Growing by doubling would take three times the memory for a moment.
void Scene::ReserveRingAreas(std::size_t vertices)
{
  std::size_t groups = 0;
  for (std::uint32_t v = 0; v < vertices; ++v)
  {
    const Range<std::uint32_t> ring = this->VertexRings.Of(v);
    groups += static_cast<std::size_t>(ring.end() - ring.begin() + 3) / 4;
  }
  this->AreasByRing.reserve(groups);
}

void Scene::AddRingAreas(std::uint32_t vertex)
{
  int place = 0;
  for (const std::uint32_t f : this->VertexRings.Of(vertex))
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

Vertex Scene::MakeVertex(std::uint32_t v, const glm::dvec3& givenNormal, const glm::vec3& position)
{
  glm::dvec3 areaVectors(0.0);
  double areas = 0.0;
  for (const std::uint32_t f : this->VertexRings.Of(v))
  {
    areaVectors += glm::dvec3(this->FacetAreas[f]);
    areas += glm::length(glm::dvec3(this->FacetAreas[f]));
  }
  this->Areas.push_back(areas / 3.0 * this->SquareMetresPerSceneArea());
  if (!(areas > 0.0))
  {
    return { position, glm::vec3(0.0f), glm::vec3(0.0f), 2.0f, 0.0f };
  }

  const glm::dvec3 normal = this->NormalOfUse(v, givenNormal, areaVectors);
  double leastCosine = 1.0;
  for (const std::uint32_t f : this->VertexRings.Of(v))
  {
    leastCosine =
      std::min(leastCosine, glm::dot(normal, glm::normalize(glm::dvec3(this->FacetAreas[f]))));
  }
  const double sinTilt =
    leastCosine > 0.0 ? std::sqrt(std::max(0.0, 1.0 - leastCosine * leastCosine)) : 2.0;
  const bool flat = sinTilt <= NoTilt;
  this->Found.tiltedVertices += !flat;
  return { position, glm::vec3(normal), glm::vec3(areaVectors / areas),
    flat ? -1.0f : static_cast<float>(sinTilt), static_cast<float>(1.0 / areas) };
}

/// The given normal, or, where it does not tell a front, that of the ring's fronts.
glm::dvec3 Scene::NormalOfUse(
  std::uint32_t v, const glm::dvec3& givenNormal, const glm::dvec3& areaVectors)
{
  const Range<std::uint32_t> ring = this->VertexRings.Of(v);
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
    this->Found.inPlaneNormals.Add(v);
  }
  else
  {
    return givenNormal;
  }
  return UsableNormal(areaVectors);
}

void Scene::BuildBvh(std::vector<glm::vec3> positions)
{
  std::vector<glm::uvec3> indices;
  indices.reserve(this->FacetRecords.size());
  for (const Facet& facet : this->FacetRecords)
  {
    indices.push_back(facet.vertices);
  }
  std::vector<FacetPart> parts = this->PartsOfLargeFacets(positions);
  const std::size_t most = MostParts(this->FacetRecords.size());
  while (parts.size() > most) // where thousands of large facets meet next to the origin
  {
    this->LeastReach *= 16.0f;
    parts = this->PartsOfLargeFacets(positions);
  }
  this->Bvh.emplace(std::move(positions), std::move(indices), std::move(parts));
}

/// Embree's error at a facet grows with the facet's extent. Facets that are large for their
/// distance from the origin, where coordinates are fine, are traced in parts that are not.
std::vector<FacetPart> Scene::PartsOfLargeFacets(const std::vector<glm::vec3>& positions) const
{
  std::vector<FacetPart> parts;
  const auto halves = [this](const glm::vec3& a, const glm::vec3& b)
  {
    const glm::vec3 along = b - a;
    const float length = glm::length(along);
    const float place = std::clamp(-glm::dot(a, along) / (length * length), 0.0f, 1.0f);
    return length > 1.5f * std::max(glm::length(a + place * along), this->LeastReach);
  };
  for (std::uint32_t f = 0; f < this->FacetRecords.size(); ++f)
  {
    const glm::uvec3& ids = this->FacetRecords[f].vertices;
    if (IsFarForItsSize(positions[ids.x], positions[ids.y], positions[ids.z]))
    {
      continue; // as nearly all are
    }
    AppendParts(f, { positions[ids.x], positions[ids.y], positions[ids.z] }, halves, parts);
  }
  return parts;
}

bool Scene::FindFront(const Ray& ray, Hit& hit) const
{
  const auto corner = [&](const Facet& facet, int c)
  { return glm::dvec3(this->VertexRecords[facet.vertices[c]].position); };
  const Facet& behind = this->FacetRecords[hit.facet];
  const glm::dvec3 point = double(hit.barycentric.x) * corner(behind, 0) +
    double(hit.barycentric.y) * corner(behind, 1) + double(hit.barycentric.z) * corner(behind, 2);
  const double gap = double{ SheetGap } * this->Reach(point);
  std::uint32_t chosen = NoFacet; // the first in the list, whatever the order of the search
  const auto look = [&](std::uint32_t f)
  {
    const Facet& facet = this->FacetRecords[f];
    if (f < chosen && glm::dot(ray.direction, facet.normal) < 0.0f &&
      glm::dot(behind.normal, facet.normal) < -SameSheet)
    {
      const auto there = Within(point, gap, corner(facet, 0), corner(facet, 1), corner(facet, 2));
      if (there)
      {
        chosen = f;
        hit.barycentric = *there;
        hit.part = NoPart;
      }
    }
  };
  this->Bvh->ForEachNear(glm::vec3(point), static_cast<float>(gap), look);
  hit.facet = chosen != NoFacet ? chosen : hit.facet;
  return chosen != NoFacet;
}

glm::vec3 Scene::SafeOrigin(const Hit& hit, bool front) const
{
  const Facet& facet = this->FacetRecords[hit.facet];
  const auto at =
    [](const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& weights)
  { return a + weights.y * (b - a) + weights.z * (c - a); };
  glm::vec3 point;
  if (hit.part == NoPart)
  {
    point = at(this->VertexRecords[facet.vertices.x].position,
      this->VertexRecords[facet.vertices.y].position,
      this->VertexRecords[facet.vertices.z].position, hit.barycentric);
  }
  else
  {
    const std::array<glm::vec3, 3>& corners = this->Bvh->Part(hit.part).positions;
    point = at(corners[0], corners[1], corners[2], hit.inPart);
  }
  const float offset = OriginOffset * this->Reach(point);
  const float margin = facet.marginPerOffset * offset;
  if (std::min(std::min(hit.barycentric.x, hit.barycentric.y), hit.barycentric.z) < margin)
  {
    return this->SafeOrigin(facet, hit.barycentric, front);
  }
  return point + (front ? offset : -offset) * facet.normal;
}

glm::vec3 Scene::SafeOrigin(const Facet& facet, const glm::vec3& barycentric, bool front) const
{
  // In double, so that the start is rounded by its own coordinates and not by the facet's.
  const glm::dvec3 a(this->VertexRecords[facet.vertices.x].position);
  const glm::dvec3 toB = glm::dvec3(this->VertexRecords[facet.vertices.y].position) - a;
  const glm::dvec3 toC = glm::dvec3(this->VertexRecords[facet.vertices.z].position) - a;
  const auto at = [&](const glm::vec3& b) { return a + double{ b.y } * toB + double{ b.z } * toC; };
  const float offset = OriginOffset * static_cast<float>(this->Reach(at(barycentric)));
  const float margin = std::min(1.0f / 3.0f, facet.marginPerOffset * offset);
  const glm::vec3 inside = glm::max(barycentric, margin);
  const glm::dvec3 point = at(inside / (inside.x + inside.y + inside.z));
  return glm::vec3(point + double{ front ? offset : -offset } * glm::dvec3(facet.normal));
}

double Scene::SquareMetresPerSceneArea() const
{
  const double metres = this->MetresPerUnit / this->Place.scale;
  return metres * metres;
}

} // namespace PhotonTransport
