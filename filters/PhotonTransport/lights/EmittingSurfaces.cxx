// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/EmittingSurfaces.h"

#include "PhotonTransport/lights/Clearance.h"
#include "PhotonTransport/lights/LampChecks.h"
#include "PhotonTransport/lights/PhotonStart.h"
#include "PhotonTransport/sampling/Warps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace PhotonTransport
{
namespace
{

using Corner = std::array<double, 3>;
using Corners = std::array<Corner, 3>;

/// The corners of a facet, from the least one on, so that copies that start elsewhere have the
/// same. What is not a number has no order, and is refused elsewhere.
Corners OrderedCorners(const EmittingMesh& mesh, const glm::uvec3& facet)
{
  Corners corners;
  for (int c = 0; c < 3; ++c)
  {
    const glm::dvec3& point = mesh.points[facet[c]];
    for (int axis = 0; axis < 3; ++axis)
    {
      corners[c][axis] = std::isnan(point[axis]) ? 0.0 : point[axis];
    }
  }
  std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
  return corners;
}

/// [facet] Scene coordinates.
std::vector<std::array<glm::dvec3, 3>> CheckedCorners(const EmittingMesh& mesh, const Scene& scene)
{
  if (mesh.exitance.size() != mesh.facets.size())
  {
    RefuseLamp("an emitting surface has " + std::to_string(mesh.exitance.size()) +
      " exitances for " + std::to_string(mesh.facets.size()) + " triangles");
  }
  std::vector<std::array<glm::dvec3, 3>> corners(mesh.facets.size());
  for (std::size_t f = 0; f < mesh.facets.size(); ++f)
  {
    for (int c = 0; c < 3; ++c)
    {
      if (mesh.facets[f][c] >= mesh.points.size())
      {
        RefuseLamp("triangle " + std::to_string(f) + " of an emitting surface uses point " +
          std::to_string(mesh.facets[f][c]) + " of " + std::to_string(mesh.points.size()));
      }
      corners[f][c] = CheckedPosition(mesh.points[mesh.facets[f][c]], scene);
    }
  }
  return corners;
}

} // namespace

std::vector<bool> CopiesIn(const EmittingMesh& mesh)
{
  std::vector<std::pair<Corners, std::size_t>> facets;
  facets.reserve(mesh.facets.size());
  for (std::size_t f = 0; f < mesh.facets.size(); ++f)
  {
    facets.emplace_back(OrderedCorners(mesh, mesh.facets[f]), f);
  }
  std::sort(facets.begin(), facets.end());
  std::vector<bool> isCopy(facets.size(), false);
  for (std::size_t i = 0, shines = 0; i < facets.size(); ++i)
  {
    if (i == 0 || facets[i].first != facets[i - 1].first)
    {
      shines = facets[i].second;
      continue;
    }
    const std::size_t facet = facets[i].second;
    const bool isBrighter = mesh.exitance[facet] > mesh.exitance[shines];
    isCopy[isBrighter ? shines : facet] = true;
    shines = isBrighter ? facet : shines;
  }
  return isCopy;
}

std::optional<glm::dvec3> EmittingMesh::Place() const
{
  if (this->points.empty())
  {
    return std::nullopt;
  }
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& point : this->points)
  {
    sum += point / static_cast<double>(this->points.size());
  }
  return sum;
}

LampNotes EmittingMesh::Notes(const std::string& name) const
{
  const std::vector<bool> copies = CopiesIn(*this);
  const auto number = std::count(copies.begin(), copies.end(), true);
  return number == 0
    ? LampNotes()
    : LampNotes{ std::to_string(number) + " triangles of luminaire '" + name +
        "' are exact copies of others of its triangles: such triangles shine once" };
}

Prepared<FacetEmitter> EmittingFacets::Prepare(const Scene& scene) const
{
  FacetEmitter emitter{ &scene, {}, {} };
  std::vector<double> fluxes;
  double sum = 0.0;
  for (std::uint32_t f = 0; f < scene.Exitance().size(); ++f)
  {
    const float exitance = Luminous(scene.Exitance()[f]);
    if (exitance > 0.0f)
    {
      fluxes.push_back(exitance * double{ glm::length(scene.AreaVectors()[f]) });
      emitter.facets.push_back(f);
      sum += fluxes.back();
    }
  }
  if (!(sum > 0.0))
  {
    RefuseLamp("no facet has an exitance above 0 lm/m^2");
  }
  emitter.table = FluxTable(fluxes);
  return { std::move(emitter), sum * scene.SquareMetresPerSceneArea() };
}

Prepared<MeshEmitter> EmittingMesh::Prepare(const Scene& scene) const
{
  const std::vector<std::array<glm::dvec3, 3>> allCorners = CheckedCorners(*this, scene);
  const std::vector<bool> copies = CopiesIn(*this);
  MeshEmitter emitter;
  std::vector<double> fluxes;
  double sum = 0.0;
  for (std::size_t f = 0; f < this->facets.size(); ++f)
  {
    const std::array<glm::dvec3, 3>& corners = allCorners[f];
    const glm::dvec3 u = corners[1] - corners[0];
    const glm::dvec3 v = corners[2] - corners[0];
    const glm::dvec3 area = 0.5 * glm::cross(u, v);
    const double flux = CheckedAmount(this->exitance[f], "exitance") * glm::length(area);
    if (flux > 0.0 && !copies[f])
    {
      const glm::dvec3 normal = CheckedDirection(area); // whose square may be too small a number
      const glm::dvec3 way = WayClearOfFacets(
        scene, { corners[0], corners[1], corners[2], corners[0] + (u + v) / 3.0 }, normal);
      emitter.triangles.push_back({ corners[0] + way, u, v, glm::vec3(normal) });
      fluxes.push_back(flux);
      sum += flux;
    }
  }
  if (!(sum > 0.0))
  {
    RefuseLamp("no triangle of an emitting surface has an exitance above 0 lm/m^2");
  }
  emitter.table = FluxTable(fluxes);
  return { std::move(emitter), sum * scene.SquareMetresPerSceneArea() };
}

std::uint32_t FacetEmitter::FacetOf(const PhotonSample& sample, const Share& share) const
{
  return this->facets[this->table.At(share.PlaceOf(sample))];
}

const Colour* FacetEmitter::OwnColour(const PhotonSample& sample, const Share& share) const
{
  return &this->scene->Exitance()[this->FacetOf(sample, share)];
}

Ray FacetEmitter::Emit(const PhotonSample& sample, const Share& share) const
{
  const std::uint32_t facet = this->FacetOf(sample, share);
  const glm::vec2 b = UniformTriangle(sample.Emission(0), sample.Emission(1));
  const glm::vec3 barycentric(std::max(0.0f, 1.0f - b.x - b.y), b.x, b.y);
  return { this->scene->SafeOrigin(facet, barycentric, true),
    Frame(this->scene->Facets()[facet].normal).ToWorld(CosineHemisphereAbove(sample.OnDisk(1))) };
}

Ray MeshEmitter::Emit(const PhotonSample& sample, const Share& share) const
{
  const Triangle& triangle = this->triangles[this->table.At(share.PlaceOf(sample))];
  const glm::dvec2 b(UniformTriangle(sample.Emission(0), sample.Emission(1)));
  const glm::vec3 direction =
    Frame(triangle.normal).ToWorld(CosineHemisphereAbove(sample.OnDisk(1)));
  return RayFrom(triangle.corner + b.x * triangle.u + b.y * triangle.v, direction);
}

ShiningTriangle FacetEmitter::Shape(std::size_t chosen) const
{
  const Facet& facet = this->scene->Facets()[this->facets[chosen]];
  const auto corner = [&](int c)
  { return glm::dvec3(this->scene->Vertices()[facet.vertices[c]].position); };
  const glm::dvec3 first = corner(0);
  return { first, corner(1) - first, corner(2) - first, glm::dvec3(facet.normal) };
}

Incidence FacetEmitter::Arriving(
  const glm::dvec3& point, float u, float v, std::size_t chosen) const
{
  const ShiningTriangle::Seen seen = this->Shape(chosen).From(point, u, v);
  if (!(seen.perLumen > 0.0))
  {
    return {};
  }
  const glm::vec2 b(seen.barycentric);
  const glm::vec3 barycentric(std::max(0.0f, 1.0f - b.x - b.y), b.x, b.y);
  // Seen in the facet's plane, so that the facet is not seen from itself and its like.
  Incidence incidence(point, seen.place, seen.perLumen);
  incidence.place = glm::dvec3(this->scene->SafeOrigin(this->facets[chosen], barycentric, true));
  return incidence;
}

ShiningTriangle MeshEmitter::Shape(std::size_t chosen) const
{
  const Triangle& triangle = this->triangles[chosen];
  return { triangle.corner, triangle.u, triangle.v, glm::dvec3(triangle.normal) };
}

Incidence MeshEmitter::Arriving(const glm::dvec3& point, float u, float v, std::size_t chosen) const
{
  const ShiningTriangle::Seen seen = this->Shape(chosen).From(point, u, v);
  return seen.perLumen > 0.0 ? Incidence(point, seen.place, seen.perLumen) : Incidence();
}

} // namespace PhotonTransport
