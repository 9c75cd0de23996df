// SPDX-License-Identifier: BSD-3-Clause
#include "RandomChoices.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace PhotonTransport;

namespace
{

/// On one of the points, or anywhere about them, near or far.
glm::dvec3 LampPlace(const Surface& surface, const Site& site)
{
  if (OneIn(4))
  {
    return surface.points[static_cast<std::size_t>(Below(static_cast<int>(surface.points.size())))];
  }
  return site.origin +
    (OneIn(32) ? 1e100 : OneOf({ 1.0, 1.0, 1.0, 1e3, 1e9, 1e17 })) * site.size * Place();
}

/// Angles that rise from the first on, to the last at most.
std::vector<double> Rising(double first, double last)
{
  std::vector<double> angles{ first };
  const int wanted = 2 + Below(5);
  while (static_cast<int>(angles.size()) < wanted)
  {
    const double next = angles.back() + OneOf({ 30.0, 1.0, 90.0, 180.0, 1e-6, 1e-13 });
    angles.push_back(next > angles.back() && next <= last ? next : last);
    if (angles.back() == last)
    {
      break;
    }
  }
  return angles;
}

PhotometricSolid DrawSolid()
{
  PhotometricSolid solid;
  solid.type =
    OneOf({ PhotometricSolid::Type::C, PhotometricSolid::Type::B, PhotometricSolid::Type::A });
  solid.polar = Rising(OneOf({ 0.0, 45.0, 1e-300 }), OneOf({ 180.0, 90.0 }));
  const double azimuth = OneOf({ 0.0, -90.0, 90.0, 22.5 });
  solid.azimuth = Rising(azimuth, azimuth + 360.0);
  const bool extreme = OneIn(8);
  for (std::size_t i = 0; i < solid.polar.size() * solid.azimuth.size(); ++i)
  {
    solid.candela.push_back(extreme ? OneOf({ 1.0, 1e-300, 1e300, 0.0 })
                                    : OneOf({ 100.0, 0.0, 1e-12, 1e6, std::fabs(Anywhere()) }));
  }
  return solid;
}

EmittingMesh DrawMesh(const Surface& surface, const Site& site)
{
  EmittingMesh mesh;
  const int points = 3 + Below(4);
  const glm::dvec3 origin = LampPlace(surface, site);
  const double size = site.size * (OneIn(16) ? 1e-50 : OneOf({ 1.0, 1e-3, 1e3 }));
  for (int p = 0; p < points; ++p)
  {
    mesh.points.push_back(origin + size * Place());
  }
  const int facets = 1 + Below(6);
  for (int f = 0; f < facets; ++f)
  {
    const int a = Below(points);
    mesh.facets.emplace_back(a, (a + 1) % points, OneIn(8) ? a : (a + 2) % points);
    mesh.exitance.push_back(OneOf({ 100.0f, 1e-12f, 1e12f, 0.0f }));
  }
  return mesh;
}

CieSky DrawSky(double illuminance)
{
  glm::dvec3 up = Direction();
  up /= std::max({ std::fabs(up.x), std::fabs(up.y), std::fabs(up.z) });
  const glm::dvec3 away(Anywhere(), Anywhere(), Anywhere());
  // Above the horizon, at times just so.
  const double height = glm::dot(away, up);
  const glm::dvec3 sun = away + (OneOf({ 1.0, 1e-3, 1e-9 }) - height) / glm::dot(up, up) * up;
  return { up, 1 + Below(16), OneIn(4) ? up : sun, illuminance };
}

Lamp DrawLamp(const Surface& surface, const Site& site)
{
  const glm::dvec3 place = LampPlace(surface, site);
  const glm::dvec3 direction = Direction();
  const double flux =
    OneIn(16) ? OneOf({ 1e-300, 1e-200, 1e200, 1e300 }) : OneOf({ 0.0, 1e-12, 1000.0, 1e12 });
  const double width = site.size * OneOf({ 0.0, 1e-6, 0.5, 1e3 });
  switch (Below(surface.exitance.empty() ? 12 : 13))
  {
    case 0:
      return PointLamp{ place, flux };
    case 1:
      return LambertianPointLamp{ place, direction, flux };
    case 2:
      return OneIn(2)
        ? SpotLamp{ place, direction, OneOf({ 1e-9, 0.1, 1.5, 3.14159265358979 }), 0.0, flux }
        : SpotLamp{ place, direction, OneOf({ 1e-9, 0.1, 1.5 }), OneOf({ 0.5, 3.0, 1e4 }), flux };
    case 3:
      return RectangleLamp{ place, direction, width, site.size * std::fabs(Anywhere()), flux };
    case 4:
      return DiskLamp{ place, direction, width, flux };
    case 5:
      return UniformSky{ direction, flux, OneIn(2) };
    case 6:
      return ParallelLight{ direction, flux };
    case 7:
      return SphereLamp{ place, width, flux };
    case 8:
      return LineLamp{ place, direction, width, flux };
    case 9:
      return PhotometricLamp{ place, direction, OneOf({ 0.0, 1.0, -1e9 }), DrawSolid(),
        OneOf({ 1.0, 0.0, 1e-6 }) };
    case 10:
      return DrawMesh(surface, site);
    case 11:
      return DrawSky(flux);
    default:
      return EmittingFacets{};
  }
}

} // namespace

Lighting DrawLighting(const Surface& surface, const Site& site)
{
  Lighting lighting;
  const int lamps = OneIn(3) ? 2 + Below(3) : 1;
  for (int l = 0; l < lamps; ++l)
  {
    const Lamp lamp = DrawLamp(surface, site);
    const Colour colour = OneIn(3)
      ? Colour(OneOf({ 1.0f, 0.0f, 1e-40f }), OneOf({ 0.5f, 1e30f }), OneOf({ 0.0f, 0.3f }))
      : Colour(1.0f);
    lighting.luminaires.push_back({ lamp, OneIn(2) ? "lamp" : "", colour });
  }
  return lighting;
}

namespace
{

void SpoilSolid(PhotometricLamp& lamp, double bad)
{
  lamp.solid.polar = { 0.0, 90.0 };
  lamp.solid.azimuth = { 0.0, 90.0 };
  lamp.solid.candela.assign(4, 1.0);
  switch (Below(5))
  {
    case 0:
      lamp.solid.polar[1] = OneIn(2) ? bad : 0.0;
      break;
    case 1:
      lamp.solid.azimuth[1] = OneIn(2) ? bad : 361.0;
      break;
    case 2:
      lamp.solid.candela[2] = OneIn(2) ? bad : -1.0;
      break;
    case 3:
      lamp.solid.candela.assign(4, 0.0);
      break;
    default:
      lamp.solid = {};
  }
}

} // namespace

void SpoilLighting(RandomScene& scene)
{
  const double bad = OneOf({ NoNumber, Infinity, -Infinity });
  const auto spoil = [&](const Lamp& lamp, const char* mistake)
  {
    scene.lighting = lamp;
    scene.mistake = mistake;
  };
  PhotometricLamp photometric;
  EmittingMesh mesh{ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 } }, { 1.0f } };
  switch (Below(14))
  {
    case 0:
      return spoil(PointLamp{ { 0.0, bad, 0.0 }, 1.0 }, "lamp position");
    case 1:
      return spoil(ParallelLight{ glm::dvec3(OneIn(2) ? bad : 0.0), 1.0 }, "lamp direction");
    case 2:
      return spoil(PointLamp{ {}, OneIn(2) ? bad : -1.0 }, "luminous flux");
    case 3:
      return spoil(
        SpotLamp{ {}, { 0.0, 0.0, 1.0 }, OneIn(2) ? bad : 0.0, 0.0, 1.0 }, "spot half-angle");
    case 4:
      return spoil(SphereLamp{ {}, OneIn(2) ? bad : -1.0, 1.0 }, "lamp radius");
    case 5:
      return spoil(LineLamp{ {}, glm::dvec3(OneIn(2) ? bad : 0.0), 1.0, 1.0 }, "lamp axis");
    case 6:
      return spoil(LineLamp{ {}, { 1.0, 0.0, 0.0 }, OneIn(2) ? bad : -1.0, 1.0 }, "lamp length");
    case 7:
      return spoil(CieSky{ { 0, 0, 1 }, OneIn(2) ? 0 : 17, { 0, 0, 1 }, 1.0 }, "sky type");
    case 8:
      return spoil(CieSky{ { 0, 0, 1 }, 1, { 1, 0, OneIn(2) ? 0 : -1 }, 1.0 }, "the sun of a sky");
    case 9:
      SpoilSolid(photometric, bad);
      return spoil(photometric, "photometric solid");
    case 10:
      photometric.rotation = bad;
      return spoil(photometric, "lamp rotation");
    case 11:
      mesh.exitance[0] = OneIn(2) ? static_cast<float>(bad) : -1.0f;
      return spoil(mesh, "exitance");
    case 12:
      mesh.facets[0].y = OneIn(2) ? 3 : 0xffffffffu;
      return spoil(mesh, "uses point");
    default:
      spoil(PointLamp{ {}, 1.0 }, "light colour");
      scene.lighting.luminaires[0].colour =
        OneIn(2) ? Colour(0.0f) : Colour(1.0f, static_cast<float>(bad), 1.0f);
  }
}
