// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/Scene.h"

#include "PhotonTransport/materials/Scattering.h"
#include "PhotonTransport/scene/EmbreeScene.h"
#include "PhotonTransport/scene/FacetSide.h"
#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/scene/LargeFacets.h"

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

} // namespace

Scene::Scene(const Surface& surface)
  : MetresPerUnit(surface.metresPerUnit)
{
  Validate(surface);
  this->Place = FitPlacement(surface.points, surface.facets);
  this->Rounding = { this->Place.PointToScene(glm::dvec3(0.0)), surface.rounding };
  this->Found.turn = surface.given.turn;
  this->Found.isCoarse = surface.given.isCoarse;
  this->RequireSize();
  std::vector<glm::vec3> positions = ScenePositions(surface, this->Place);
  this->AddFacets(surface, positions);
  this->FindSharedPlaces(positions);
  this->AddVertices(surface, positions);
  this->BuildBvh(std::move(positions));
  this->FindThinGaps();
}

std::uint32_t Scene::InSurface(std::uint32_t facet) const
{
  if (!this->GivenFacets.empty())
  {
    return this->GivenIndex(facet);
  }
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
    this->AddFacet(surface, f, positions);
  }
  this->FacetMaterials = surface.materials;
  this->CountEffects();
  if (this->FacetRecords.empty())
  {
    throw InvalidInput(InvalidInput::Where::Surface, 0, "every triangle has zero area");
  }
}

/// Whether the front is the side round which the facet's corners run clockwise. Parts of a facet
/// have its front.
bool Scene::IsTurned(
  const Surface& surface, std::size_t facet, const std::vector<glm::vec3>& positions)
{
  const std::size_t given =
    surface.IsRefined() ? std::size_t{ surface.given.origins[facet].facet } : facet;
  const glm::uvec3& ids = surface.IsRefined() ? surface.given.facets[given] : surface.facets[given];
  const glm::dvec3 a(positions[ids[0]]), b(positions[ids[1]]), c(positions[ids[2]]);
  const FacetSide side = SideOf(0.5 * glm::cross(b - a, c - a),
    { surface.normals[ids.x], surface.normals[ids.y], surface.normals[ids.z] });
  if (!surface.IsRefined() || surface.given.IsFirstPart(facet))
  {
    this->Found.turnedFacets += side.turned;
    if (side.undecided)
    {
      this->Found.undecidedFacets.Add(given);
    }
  }
  return side.turned;
}

/// Leaves out a facet that has no area.
void Scene::AddFacet(
  const Surface& surface, std::size_t facet, const std::vector<glm::vec3>& positions)
{
  const glm::uvec3& ids = surface.facets[facet];
  // The rounded positions are the ones that photons hit, so areas and normals are theirs.
  const glm::dvec3 a(positions[ids[0]]), b(positions[ids[1]]), c(positions[ids[2]]);
  glm::dvec3 areaVector = 0.5 * glm::cross(b - a, c - a);
  const double area = glm::length(areaVector);
  if (!(area >= LeastArea))
  {
    ++this->Found.droppedFacets;
    this->Dropped.push_back(static_cast<std::uint32_t>(facet));
    return;
  }
  if (surface.IsRefined())
  {
    const FacetOrigin& origin = surface.given.origins[facet];
    this->GivenFacets.push_back({ surface.given.facets[origin.facet], origin });
  }
  areaVector = this->IsTurned(surface, facet, positions) ? -areaVector : areaVector;
  const float reflectance =
    Luminous(surface.materials[surface.materialOfFacet[facet]].diffuseReflectance);
  this->FacetRecords.push_back(
    { ids, reflectance, glm::vec3(areaVector / area), MarginPerOffset(a, b, c, area) });
  this->FacetAreas.emplace_back(areaVector);
  this->FacetMaterial.push_back(surface.materialOfFacet[facet]);
  if (!surface.exitance.empty())
  {
    this->FacetExitance.push_back(surface.exitance[facet]);
  }
}

/// How many facets are curved, scatter light in each way, or treat or emit channels unequally.
void Scene::CountEffects()
{
  this->Found.curvedFacets = this->CountGiven([this](std::uint32_t f)
    { return !this->GivenFacets.empty() && this->GivenFacets[f].origin.corners != WholeFacet; });
  std::vector<ScatteringSet> ways(this->FacetMaterials.size());
  std::transform(
    this->FacetMaterials.begin(), this->FacetMaterials.end(), ways.begin(), ScatteringsOf);
  for (unsigned s = 0; s < Scatterings; ++s)
  {
    this->Found.scatteringFacets[s] = this->CountGiven(
      [&](std::uint32_t f) { return ((ways[this->FacetMaterial[f]] >> s) & 1u) != 0; });
  }
  this->Found.colouredFacets = this->CountGiven(
    [this](std::uint32_t f)
    {
      return IsColoured(this->FacetMaterials[this->FacetMaterial[f]]) ||
        (!this->FacetExitance.empty() && !IsGrey(this->FacetExitance[f]));
    });
}

void Scene::BuildBvh(std::vector<glm::vec3> positions)
{
  std::vector<glm::uvec3> indices;
  indices.reserve(this->FacetRecords.size());
  for (const Facet& facet : this->FacetRecords)
  {
    indices.push_back(facet.vertices);
  }
  std::vector<FacetPart> parts = PartsOfLargeFacets(positions, indices, this->LeastReach);
  this->Bvh =
    std::make_unique<EmbreeScene>(std::move(positions), std::move(indices), std::move(parts));
}

void Scene::Intersect(const Ray* rays, Hit* hits, std::size_t count) const
{
  this->Bvh->Intersect(rays, hits, count);
}

void Scene::ForEachNear(
  const glm::vec3& point, float distance, const std::function<void(std::uint32_t)>& f) const
{
  this->Bvh->ForEachNear(point, distance, f);
}

Scene::~Scene() = default;

double Scene::SquareMetresPerSceneArea() const
{
  const double metres = this->MetresPerUnit / this->Place.scale;
  return metres * metres;
}

} // namespace PhotonTransport
