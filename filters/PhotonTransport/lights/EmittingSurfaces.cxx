// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/lights/EmittingSurfaces.h"

#include "PhotonTransport/lights/Clearance.h"
#include "PhotonTransport/lights/LampChecks.h"

#include <glm/geometric.hpp>

#include <string>
#include <utility>
#include <vector>

namespace PhotonTransport
{

PreparedEmitter Prepare(const EmittingFacets&, const Scene& scene)
{
  FacetEmitter emitter{ &scene, {}, {} };
  std::vector<double> fluxes;
  double sum = 0.0;
  for (std::uint32_t f = 0; f < scene.Exitance().size(); ++f)
  {
    if (scene.Exitance()[f] > 0.0f)
    {
      fluxes.push_back(scene.Exitance()[f] * double{ glm::length(scene.AreaVectors()[f]) });
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

PreparedEmitter Prepare(const EmittingMesh& lamp, const Scene& scene)
{
  if (lamp.exitance.size() != lamp.facets.size())
  {
    RefuseLamp("an emitting surface has " + std::to_string(lamp.exitance.size()) +
      " exitances for " + std::to_string(lamp.facets.size()) + " triangles");
  }
  MeshEmitter emitter;
  std::vector<double> fluxes;
  double sum = 0.0;
  for (std::size_t f = 0; f < lamp.facets.size(); ++f)
  {
    glm::dvec3 corners[3];
    for (int c = 0; c < 3; ++c)
    {
      if (lamp.facets[f][c] >= lamp.points.size())
      {
        RefuseLamp("triangle " + std::to_string(f) + " of an emitting surface uses point " +
          std::to_string(lamp.facets[f][c]) + " of " + std::to_string(lamp.points.size()));
      }
      corners[c] = CheckedPosition(lamp.points[lamp.facets[f][c]], scene);
    }
    const glm::dvec3 u = corners[1] - corners[0];
    const glm::dvec3 v = corners[2] - corners[0];
    const glm::dvec3 area = 0.5 * glm::cross(u, v);
    const double flux = CheckedAmount(lamp.exitance[f], "exitance") * glm::length(area);
    if (flux > 0.0)
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

} // namespace PhotonTransport
