// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/Scene.h"

#include "PhotonTransport/materials/Scattering.h"
#include "PhotonTransport/memory/HugePages.h"
#include "PhotonTransport/scene/EmbreeScene.h"
#include "PhotonTransport/scene/FacetSide.h"
#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/scene/LargeFacets.h"
#include "PhotonTransport/threads/Threads.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <sstream>

namespace PhotonTransport
{
namespace
{

/// Scene units squared. A smaller facet has no area that its single-precision record could hold.
constexpr double LeastArea = std::numeric_limits<float>::min();

/// Those of points that no facet uses, which may be anywhere, are 0.
LargeArray<glm::vec3> ScenePositions(const Surface& surface, const Placement& placement)
{
  std::vector<std::atomic<std::uint8_t>> used(surface.points.size());
  ForEach(surface.facets.size(),
    [&](std::size_t f)
    {
      for (int corner = 0; corner < 3; ++corner)
      {
        used[surface.facets[f][corner]].store(1, std::memory_order_relaxed);
      }
    });

  LargeArray<glm::vec3> positions;
  ResizeOnHugePages(positions, surface.points.size());
  ForEach(positions.size(),
    [&](std::size_t p)
    {
      positions[p] = used[p].load(std::memory_order_relaxed) != 0
        ? glm::vec3(placement.PointToScene(surface.points[p]))
        : glm::vec3(0.0f);
    });
  return positions;
}

LargeArray<glm::dvec3> UsableNormals(const Surface& surface)
{
  LargeArray<glm::dvec3> normals;
  ResizeOnHugePages(normals, surface.normals.size());
  ForEach(normals.size(), [&](std::size_t p) { normals[p] = UsableNormal(surface.normals[p]); });
  return normals;
}

/// Smallest barycentric coordinate that keeps EdgeClearance from every edge, by offset.
float MarginPerOffset(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c, double area)
{
  const double longest = std::max({ glm::length(b - a), glm::length(c - b), glm::length(a - c) });
  const double smallestHeight = 2.0 * area / longest;
  constexpr double Most = std::numeric_limits<float>::max();
  return static_cast<float>(std::min(Most, double{ EdgeClearance } / smallestHeight));
}

/// What the normals say of a facet's front. Parts of a facet have its front.
FacetSide SideOfGiven(const Surface& surface, std::size_t facet, const PlacedPoints& points)
{
  const glm::uvec3& ids = surface.IsRefined()
    ? surface.given.facets[surface.given.origins[facet].facet]
    : surface.facets[facet];
  const glm::dvec3 a(points.positions[ids[0]]), b(points.positions[ids[1]]),
    c(points.positions[ids[2]]);
  return SideByUsableNormals(0.5 * glm::cross(b - a, c - a),
    { points.normals[ids.x], points.normals[ids.y], points.normals[ids.z] });
}

/// What is to be noted of a facet, as bits.
enum FoundInFacet : std::uint8_t
{
  NoArea = 1, ///< It is left out.
  Turned = 2,
  Undecided = 4
};

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
  std::vector<std::uint8_t> close;
  {
    const PlacedPoints points{ ScenePositions(surface, this->Place), UsableNormals(surface) };
    this->AddFacets(surface, points);
    close = this->FindSharedPlaces(points.positions);
    this->AddVertices(surface, points);
  }

  UseHugePages(this->FacetRecords);
  UseHugePages(this->VertexRecords);
  this->BuildBvh();
  this->FindThinGaps(close);
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

void Scene::AddFacets(const Surface& surface, const PlacedPoints& points)
{
  const std::size_t facets = surface.facets.size();
  ResizeOnHugePages(this->FacetRecords, facets);
  ResizeOnHugePages(this->FacetAreas, facets);
  this->GivenFacets.resize(surface.given.origins.size());
  this->FacetMaterial = surface.materialOfFacet;
  this->FacetExitance = surface.exitance;
  std::vector<std::uint8_t> found(facets);
  ForEach(facets, [&](std::size_t f) { found[f] = this->MakeFacet(surface, f, points); });
  this->NoteFacets(surface, found);
  this->LeaveOutFacets();
  this->FacetMaterials = surface.materials;
  this->CountEffects();
  if (this->FacetRecords.empty())
  {
    throw InvalidInput(InvalidInput::Where::Surface, 0, "every triangle has zero area");
  }
}

/// @return What is to be noted of it, as FoundInFacet.
std::uint8_t Scene::MakeFacet(const Surface& surface, std::size_t facet, const PlacedPoints& points)
{
  const glm::uvec3& ids = surface.facets[facet];
  // The rounded positions are the ones that photons hit, so areas and normals are theirs.
  const glm::dvec3 a(points.positions[ids[0]]), b(points.positions[ids[1]]),
    c(points.positions[ids[2]]);
  glm::dvec3 areaVector = 0.5 * glm::cross(b - a, c - a);
  const double area = glm::length(areaVector);
  if (!(area >= LeastArea))
  {
    return NoArea;
  }
  if (surface.IsRefined())
  {
    const FacetOrigin& origin = surface.given.origins[facet];
    this->GivenFacets[facet] = { surface.given.facets[origin.facet], origin };
  }
  const FacetSide side = SideOfGiven(surface, facet, points);
  areaVector = side.turned ? -areaVector : areaVector;
  const float reflectance =
    Luminous(surface.materials[surface.materialOfFacet[facet]].diffuseReflectance);
  this->FacetRecords[facet] = { ids, reflectance, glm::vec3(areaVector / area),
    MarginPerOffset(a, b, c, area) };
  this->FacetAreas[facet] = glm::vec3(areaVector);
  return static_cast<std::uint8_t>((side.turned ? Turned : 0) | (side.undecided ? Undecided : 0));
}

/// Parts of a facet have its front, which is noted once.
void Scene::NoteFacets(const Surface& surface, const std::vector<std::uint8_t>& found)
{
  for (std::uint32_t f = 0; f < found.size(); ++f)
  {
    if (found[f] == 0)
    {
      continue; // as nearly all
    }
    if ((found[f] & NoArea) != 0)
    {
      ++this->Found.droppedFacets;
      this->Dropped.push_back(f);
    }
    else if (!surface.IsRefined() || surface.given.IsFirstPart(f))
    {
      this->Found.turnedFacets += (found[f] & Turned) != 0;
      if ((found[f] & Undecided) != 0)
      {
        this->Found.undecidedFacets.Add(surface.IsRefined() ? surface.given.origins[f].facet : f);
      }
    }
  }
}

/// Takes those without an area out of all lists of facets.
void Scene::LeaveOutFacets()
{
  if (this->Dropped.empty())
  {
    return;
  }
  const auto leaveOut = [this](auto& list)
  {
    if (list.empty())
    {
      return;
    }
    std::size_t kept = 0;
    auto dropped = this->Dropped.begin();
    for (std::size_t f = 0; f < list.size(); ++f)
    {
      if (dropped != this->Dropped.end() && *dropped == f)
      {
        ++dropped;
      }
      else
      {
        list[kept++] = list[f];
      }
    }
    list.resize(kept);
  };
  leaveOut(this->FacetRecords);
  leaveOut(this->FacetAreas);
  leaveOut(this->GivenFacets);
  leaveOut(this->FacetMaterial);
  leaveOut(this->FacetExitance);
}

/// How many facets are curved, scatter light in each way, or treat or emit channels unequally.
void Scene::CountEffects()
{
  if (!this->GivenFacets.empty())
  {
    this->Found.curvedFacets = this->CountGiven(
      [this](std::uint32_t f) { return this->GivenFacets[f].origin.corners != WholeFacet; });
  }
  // Parts of a facet have its material and its exitance.
  std::vector<std::size_t> ofMaterial(this->FacetMaterials.size(), 0);
  std::uint32_t last = NoFacet;
  for (std::uint32_t f = 0; f < this->FacetMaterial.size(); ++f)
  {
    ofMaterial[this->FacetMaterial[f]] += this->GivenIndex(f) != last;
    last = this->GivenIndex(f);
  }
  for (std::size_t m = 0; m < ofMaterial.size(); ++m)
  {
    const Material& material = this->FacetMaterials[m];
    const ScatteringSet ways = ScatteringsOf(material);
    for (unsigned s = 0; s < Scatterings; ++s)
    {
      this->Found.scatteringFacets[s] += ((ways >> s) & 1u) != 0 ? ofMaterial[m] : 0;
    }
    this->Found.colouredFacets += IsColoured(material) ? ofMaterial[m] : 0;
  }
  if (!this->FacetExitance.empty())
  {
    this->Found.colouredFacets = this->CountGiven(
      [this](std::uint32_t f)
      {
        return IsColoured(this->FacetMaterials[this->FacetMaterial[f]]) ||
          !IsGrey(this->FacetExitance[f]);
      });
  }
}

void Scene::BuildBvh()
{
  std::vector<FacetPart> parts =
    PartsOfLargeFacets(this->VertexRecords, this->FacetRecords, this->LeastReach);
  this->Bvh =
    std::make_unique<EmbreeScene>(this->VertexRecords, this->FacetRecords, std::move(parts));
}

void Scene::Intersect(const Ray* rays, Hit* hits, std::size_t count) const
{
  this->Bvh->Intersect(rays, hits, count);
}

void Scene::FindOccluded(
  const Segment* segments, std::uint8_t* occluded, std::size_t count, bool neighbours) const
{
  this->Bvh->FindOccluded(segments, occluded, count, neighbours);
}

Segment Scene::SegmentBetween(const glm::vec3& a, const glm::dvec3& b) const
{
  const bool turned = this->Reach(b) < double{ this->Reach(a) };
  const glm::vec3 from = turned ? glm::vec3(b) : a;
  const glm::dvec3 way = (turned ? glm::dvec3(a) : b) - glm::dvec3(from);
  const double length = glm::length(way);
  const glm::dvec3 direction = length > 0.0 ? way / length : glm::dvec3(0.0, 0.0, 1.0);
  return { { from, glm::vec3(direction) }, static_cast<float>(length) };
}

void Scene::ForEachNear(
  const glm::vec3& point, float distance, const std::function<void(std::uint32_t)>& f) const
{
  this->Bvh->ForEachNear(point, distance, f);
}

std::size_t Scene::NumberOfParts() const
{
  return this->Bvh->NumberOfParts();
}

Scene::~Scene() = default;

double Scene::SquareMetresPerSceneArea() const
{
  const double metres = this->MetresPerUnit / this->Place.scale;
  return metres * metres;
}

} // namespace PhotonTransport
