// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/SkyOpenings.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <type_traits>

namespace PhotonTransport
{
namespace
{

/// Where a sky shines from: the half space on one side of the horizon, or everywhere.
struct HalfSpace
{
  glm::dvec3 up{ 0.0 };
  bool everywhere = false;
};

std::vector<HalfSpace> SkiesOf(const Lighting& lighting)
{
  std::vector<HalfSpace> skies;
  for (const Luminaire& luminaire : lighting.luminaires)
  {
    std::visit(
      [&](const auto& lamp)
      {
        using Kind = std::decay_t<decltype(lamp)>;
        if constexpr (std::is_same_v<Kind, UniformSky>)
        {
          skies.push_back({ lamp.up, lamp.wholeSphere });
        }
        else if constexpr (std::is_same_v<Kind, CieSky>)
        {
          skies.push_back({ lamp.up, false });
        }
      },
      luminaire.lamp);
  }
  return skies;
}

bool SunShines(const Lighting& lighting)
{
  return std::any_of(lighting.luminaires.begin(), lighting.luminaires.end(),
    [](const Luminaire& luminaire)
    { return std::holds_alternative<ParallelLight>(luminaire.lamp); });
}

} // namespace

bool HasSky(const Lighting& lighting)
{
  return !SkiesOf(lighting).empty();
}

bool UsesOpenings(const Lighting& lighting, const TraceSettings& settings)
{
  return HasSky(lighting) || (settings.method == Method::PhotonTracing && SunShines(lighting));
}

FoundOpenings OpeningsToSkies(const Surface& surface, const Scene& scene, const Lighting& lighting,
  const TraceSettings& settings)
{
  if (!UsesOpenings(lighting, settings))
  {
    return {};
  }
  std::vector<HalfSpace> skies = SkiesOf(lighting);
  if (skies.empty()) // only the sun: wherever it stands
  {
    skies.push_back({ glm::dvec3(0.0), true });
  }
  return FindOpenings(surface, scene,
    [&](const glm::vec3& direction)
    {
      return std::any_of(skies.begin(), skies.end(),
        [&](const HalfSpace& sky)
        { return sky.everywhere || glm::dot(sky.up, glm::dvec3(direction)) > 0.0; });
    });
}

} // namespace PhotonTransport
