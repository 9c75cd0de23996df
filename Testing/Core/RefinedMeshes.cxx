// SPDX-License-Identifier: BSD-3-Clause
#include "RefinedMeshes.h"

#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace RefinedMeshes
{

const RefinementLimits Fine{ RefinementLimits::None, RefinementLimits::None, glm::radians(7.0) };

TriangleMesh MeshOf(const Surface& surface)
{
  return { surface.points, surface.normals, surface.facets };
}

RefinedMesh Refined(const Surface& surface, const RefinementLimits& limits)
{
  return PhotonTransport::Refinement(MeshOf(surface), limits).Make();
}

std::size_t OpenEdges(const std::vector<glm::dvec3>& points, const std::vector<glm::uvec3>& facets)
{
  std::map<std::pair<Place, Place>, int> edges;
  for (const glm::uvec3& facet : facets)
  {
    for (int i = 0; i < 3; ++i)
    {
      const glm::dvec3 &p = points[facet[i]], &q = points[facet[(i + 1) % 3]];
      const Place a{ p.x, p.y, p.z }, b{ q.x, q.y, q.z };
      edges[{ std::min(a, b), std::max(a, b) }] += a < b ? 1 : -1;
    }
  }
  return static_cast<std::size_t>(
    std::count_if(edges.begin(), edges.end(), [](const auto& edge) { return edge.second != 0; }));
}

std::size_t OpenEdges(const RefinedMesh& mesh)
{
  return OpenEdges(mesh.points, mesh.facets);
}

double Volume(const RefinedMesh& mesh)
{
  double sixVolumes = 0.0;
  for (const glm::uvec3& f : mesh.facets)
  {
    sixVolumes += glm::dot(mesh.points[f.x], glm::cross(mesh.points[f.y], mesh.points[f.z]));
  }
  return sixVolumes / 6.0;
}

glm::dvec3 AreaVector(const std::vector<glm::dvec3>& points, const glm::uvec3& f)
{
  return 0.5 * glm::cross(points[f.y] - points[f.x], points[f.z] - points[f.x]);
}

std::size_t TurnedParts(const Surface& surface, const RefinedMesh& mesh)
{
  std::size_t turned = 0;
  for (std::size_t f = 0; f < mesh.facets.size(); ++f)
  {
    const glm::dvec3 part = AreaVector(mesh.points, mesh.facets[f]);
    const glm::dvec3 whole = AreaVector(surface.points, surface.facets[mesh.origins[f].facet]);
    turned += !(glm::dot(part, whole) > 0.0);
  }
  return turned;
}

Surface CappedCylinder(int around, double height)
{
  Surface surface;
  surface.materials.resize(1);
  const auto add = [&](const glm::dvec3& point, const glm::dvec3& normal)
  {
    surface.points.push_back(point);
    surface.normals.push_back(normal);
    return static_cast<unsigned>(surface.points.size() - 1);
  };
  const auto rim = [&](int i, double z)
  {
    const double angle = 2.0 * glm::pi<double>() * (i % around) / around;
    return glm::dvec3(std::cos(angle), std::sin(angle), z);
  };
  const unsigned bottom = add({ 0, 0, 0 }, { 0, 0, -1 }), top = add({ 0, 0, height }, { 0, 0, 1 });
  for (int i = 0; i < around; ++i)
  {
    const glm::dvec3 down(0, 0, -1), up(0, 0, 1);
    const glm::dvec3 out0 = rim(i, 0), out1 = rim(i + 1, 0);
    const unsigned a = add(rim(i, 0), out0), b = add(rim(i + 1, 0), out1);
    const unsigned c = add(rim(i, height), out0), d = add(rim(i + 1, height), out1);
    surface.facets.insert(surface.facets.end(), { { a, b, d }, { a, d, c } });
    surface.facets.emplace_back(bottom, add(rim(i + 1, 0), down), add(rim(i, 0), down));
    surface.facets.emplace_back(top, add(rim(i, height), up), add(rim(i + 1, height), up));
  }
  surface.materialOfFacet.assign(surface.facets.size(), 0);
  return surface;
}

std::size_t Gaps(const Surface& surface, const RefinedMesh& mesh)
{
  const auto key = [](const glm::dvec3& p, const glm::dvec3& q)
  {
    const Place a{ p.x, p.y, p.z }, b{ q.x, q.y, q.z };
    return std::pair(std::min(a, b), std::max(a, b));
  };
  const auto way = [](const glm::dvec3& p, const glm::dvec3& q) {
    return Place{ p.x, p.y, p.z } < Place{ q.x, q.y, q.z } ? 1 : -1;
  };
  std::map<std::pair<Place, Place>, int> coarse, fine;
  std::map<std::pair<Place, Place>, std::pair<Place, Place>> partOf;
  for (const glm::uvec3& f : surface.facets)
  {
    for (int i = 0; i < 3; ++i)
    {
      const glm::dvec3 &p = surface.points[f[i]], &q = surface.points[f[(i + 1) % 3]];
      coarse[key(p, q)] += way(p, q);
    }
  }
  for (std::size_t f = 0; f < mesh.facets.size(); ++f)
  {
    const glm::uvec3& whole = surface.facets[mesh.origins[f].facet];
    for (int i = 0; i < 3; ++i)
    {
      const int next = (i + 1) % 3;
      const glm::dvec3 &p = mesh.points[mesh.facets[f][i]], &q = mesh.points[mesh.facets[f][next]];
      const glm::vec3& b = mesh.origins[f].corners[static_cast<std::size_t>(i)];
      const glm::vec3& c = mesh.origins[f].corners[static_cast<std::size_t>(next)];
      int direction = way(p, q);
      for (int side = 0; side < 3; ++side)
      {
        if (b[side] == 0.0f && c[side] == 0.0f)
        {
          const glm::dvec3& from = surface.points[whole[(side + 1) % 3]];
          const glm::dvec3& to = surface.points[whole[(side + 2) % 3]];
          partOf[key(p, q)] = key(from, to);
          direction = way(from, to);
        }
      }
      fine[key(p, q)] += direction;
    }
  }
  return static_cast<std::size_t>(std::count_if(fine.begin(), fine.end(),
    [&](const auto& edge)
    {
      const auto whole = partOf.find(edge.first);
      return edge.second != (whole == partOf.end() ? 0 : coarse[whole->second]);
    }));
}

} // namespace RefinedMeshes
