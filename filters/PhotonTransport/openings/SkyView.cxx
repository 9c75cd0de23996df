// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/openings/SkyView.h"

#include "PhotonTransport/geometry/Frame.h"
#include "PhotonTransport/materials/Scattering.h"
#include "PhotonTransport/sampling/Philox.h"
#include "PhotonTransport/sampling/Warps.h"
#include "PhotonTransport/scene/HitPoint.h"

#include <glm/geometric.hpp>

#include <array>
#include <numeric>
#include <vector>

namespace PhotonTransport
{
namespace
{

/// Rays start so many offsets (OriginOffset) from the polygon, clear of facets in its place.
constexpr float Clearance = 16.0f;
/// No more panes than these are looked through.
constexpr int MostPanes = 16;

float Uniform(std::uint32_t bits)
{
  return static_cast<float>(bits >> 8) * 0x1p-24f;
}

/// Rays from the polygon, the same directions to both sides.
struct Bundle
{
  std::vector<Ray> front, back;
  std::vector<Ray> through; ///< From the start of each front ray to that of the one behind.
};

Bundle RaysFrom(const Opening& polygon, const Scene& scene)
{
  constexpr std::uint32_t Key = 0x4f70656eu;
  Bundle bundle;
  const Frame frame(polygon.normal);
  for (std::uint32_t i = 0; i < SkyRays; ++i)
  {
    const std::array<std::uint32_t, 4> random = Philox({ i, 0, 0, 0 }, { Key, 0 });
    const glm::vec3 point = polygon.PointAt(Uniform(random[0]), Uniform(random[1]));
    const glm::vec3 direction = CosineHemisphere(Uniform(random[2]), Uniform(random[3]));
    const float clear = Clearance * OriginOffset * scene.Reach(point) +
      2.0f * static_cast<float>(scene.GetRounding().Along(polygon.normal, point));
    const glm::vec3 offset = clear * polygon.normal;
    bundle.front.push_back({ point + offset, frame.ToWorld(direction) });
    const glm::vec3 mirrored(direction.x, direction.y, -direction.z);
    bundle.back.push_back({ point - offset, frame.ToWorld(mirrored) });
    bundle.through.push_back({ point + offset, -polygon.normal });
  }
  return bundle;
}

/// What rays meet first that is no pane. They pass through panes straight on.
std::vector<Hit> HitsBehindPanes(const Scene& scene, const std::vector<Ray>& rays)
{
  std::vector<Hit> hits(rays.size());
  std::vector<Ray> onward = rays;
  std::vector<std::size_t> places(rays.size()); // of those that go on
  std::iota(places.begin(), places.end(), std::size_t{ 0 });
  for (int pane = 0; pane <= MostPanes && !onward.empty(); ++pane)
  {
    std::vector<Hit> found(onward.size());
    scene.Intersect(onward.data(), found.data(), onward.size());
    std::size_t kept = 0;
    for (std::size_t i = 0; i < found.size(); ++i)
    {
      const Hit& hit = found[i];
      hits[places[i]] = hit;
      if (hit && PassesStraightOn(scene.Materials()[scene.MaterialOfFacet()[hit.facet]]))
      {
        const glm::vec3 direction = onward[i].direction;
        const bool front = glm::dot(scene.Facets()[hit.facet].normal, direction) > 0.0f;
        onward[kept] = { scene.SafeOrigin(hit, front), direction };
        places[kept++] = places[i];
      }
    }
    onward.resize(kept);
  }
  return hits;
}

std::size_t CountSky(const Scene& scene, const std::vector<Ray>& rays,
  const std::function<bool(const glm::vec3&)>& isSky)
{
  const std::vector<Hit> hits = HitsBehindPanes(scene, rays);
  std::size_t count = 0;
  for (std::size_t i = 0; i < rays.size(); ++i)
  {
    count += !hits[i] && (!isSky || isSky(rays[i].direction)) ? 1 : 0;
  }
  return count;
}

std::size_t CountCovered(const Scene& scene, const Bundle& bundle)
{
  const std::vector<Hit> hits = HitsBehindPanes(scene, bundle.through);
  std::size_t count = 0;
  for (std::size_t i = 0; i < hits.size(); ++i)
  {
    const glm::vec3& start = bundle.through[i].origin;
    count += hits[i] &&
        glm::distance(PointOf(scene, hits[i]), start) <= glm::distance(bundle.back[i].origin, start)
      ? 1
      : 0;
  }
  return count;
}

} // namespace

SkyView ViewOfSky(
  const Opening& polygon, const Scene& scene, const std::function<bool(const glm::vec3&)>& isSky)
{
  const Bundle bundle = RaysFrom(polygon, scene);
  SkyView view;
  view.front = CountSky(scene, bundle.front, isSky);
  view.back = CountSky(scene, bundle.back, isSky);
  view.covered = CountCovered(scene, bundle);
  return view;
}

} // namespace PhotonTransport
