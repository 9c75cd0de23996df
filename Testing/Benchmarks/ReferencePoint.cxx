// SPDX-License-Identifier: BSD-3-Clause
#include "ReferencePoint.h"

#include <glm/geometric.hpp>

#include <algorithm>

using namespace PhotonTransport;

namespace
{

/// Facets face the same way if their normals differ by less than this.
constexpr double SameNormal = 1e-5;
/// Of the way to the centroid, which is a third of the facet's height.
constexpr double Pull = 1e-3;

/// Facets around a vertex that face the same way.
struct Sector
{
  glm::dvec3 normal;
  glm::dvec3 sumOfCentroids{ 0.0 };
  double facets = 0.0;
};

std::vector<std::vector<Sector>> SectorsOfVertices(const Scene& scene)
{
  std::vector<std::vector<Sector>> sectors(scene.Vertices().size());
  for (const Facet& facet : scene.Facets())
  {
    glm::dvec3 centroid(0.0);
    for (int k = 0; k < 3; ++k)
    {
      centroid += glm::dvec3(scene.Vertices()[facet.vertices[k]].position) / 3.0;
    }
    const glm::dvec3 normal(facet.normal);
    for (int k = 0; k < 3; ++k)
    {
      std::vector<Sector>& around = sectors[facet.vertices[k]];
      auto own = std::find_if(around.begin(), around.end(),
        [&](const Sector& s) { return glm::length(s.normal - normal) < SameNormal; });
      own = own == around.end() ? around.insert(own, Sector{ normal }) : own;
      own->sumOfCentroids += centroid;
      own->facets += 1.0;
    }
  }
  return sectors;
}

} // namespace

std::vector<ReferencePoint> ReferencePoints(const Scene& scene)
{
  const std::vector<std::vector<Sector>> sectors = SectorsOfVertices(scene);
  std::vector<ReferencePoint> points(scene.NumberOfMapVertices());
  for (std::size_t v = 0; v < points.size(); ++v)
  {
    const glm::dvec3 position(scene.Vertices()[v].position);
    points[v].normal = glm::normalize(glm::dvec3(scene.Vertices()[v].normal));
    for (const Sector& sector : sectors[v])
    {
      const glm::dvec3 inside = sector.sumOfCentroids / sector.facets;
      const glm::dvec3 normal = glm::normalize(sector.normal);
      points[v].starts.push_back(
        { position + Pull * (inside - position) + ReferenceLift * normal, normal });
    }
  }
  return points;
}
