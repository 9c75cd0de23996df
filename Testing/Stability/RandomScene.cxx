// SPDX-License-Identifier: BSD-3-Clause
#include "RandomScene.h"

#include <rapidcheck.h>

#include <cmath>
#include <limits>

namespace
{

using namespace PhotonTransport;

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NoNumber = std::numeric_limits<double>::quiet_NaN();

int Below(int end)
{
  return *rc::gen::inRange(0, end);
}

bool OneIn(int many)
{
  return Below(many) == many - 1;
}

template <typename Value>
Value OneOf(std::initializer_list<Value> values)
{
  return values.begin()[Below(static_cast<int>(values.size()))];
}

/// Within [-1, 1].
double Anywhere()
{
  constexpr int Steps = 1 << 20;
  return static_cast<double>(*rc::gen::inRange(-Steps, Steps + 1)) / Steps;
}

/// Few values in a lattice: coincident points, coplanar and overlapping facets are frequent.
double LatticePlace()
{
  return 0.5 * (Below(5) - 2);
}

double Coordinate()
{
  switch (Below(8))
  {
    case 0:
    case 1:
      return Anywhere();
    case 2: // almost on the lattice: needles, slivers, sheets that nearly coincide
      return LatticePlace() + OneOf({ 1e-5, 1e-7, 1e-9, 1e-16 }) * Anywhere();
    case 3:
      return OneOf({ 1e-3, 1e-12, 1e-25, 1e-40 }) * Anywhere();
    default:
      return LatticePlace();
  }
}

glm::dvec3 Place()
{
  const double x = Coordinate();
  const double y = Coordinate();
  return { x, y, Coordinate() };
}

glm::dvec3 AnyNormal()
{
  const glm::dvec3 direction(Anywhere(), Anywhere(), Anywhere());
  switch (Below(12))
  {
    case 0:
      return glm::dvec3(0.0);
    case 1:
      return { NoNumber, 0.0, 1.0 };
    case 2:
      return { Infinity, direction.y, direction.z };
    case 3:
      return OneOf({ 1e-310, 1e-200, 1e-20, 1e20, 1e200 }) * direction;
    case 4:
    case 5:
      return { 0.0, 0.0, OneIn(2) ? -1.0 : 1.0 };
    default:
      return direction;
  }
}

glm::dvec3 Direction()
{
  const glm::dvec3 along(LatticePlace(), LatticePlace(), LatticePlace());
  switch (Below(4))
  {
    case 0: // almost along an axis
      return { 1e-9 * Anywhere(), 1.0, 1e-9 * Anywhere() };
    case 1:
      return OneOf({ 1e-200, 1e-20, 1.0, 1e200 }) * glm::dvec3(1.0, Anywhere(), Anywhere());
    default:
      return along == glm::dvec3(0.0) ? glm::dvec3(0.0, 0.0, -1.0) : along;
  }
}

/// Where a scene stands and how large it is.
struct Site
{
  double size;
  glm::dvec3 origin;
};

Surface DrawSurface(const Site& site)
{
  Surface surface;
  const int points = 3 + Below(14);
  for (int p = 0; p < points; ++p)
  {
    surface.points.push_back(site.origin + site.size * Place());
    surface.normals.push_back(AnyNormal());
  }
  const int facets = 1 + Below(20);
  const bool emits = OneIn(4);
  for (int f = 0; f < facets; ++f)
  {
    const int a = Below(points);
    // Mostly three different corners; a facet that uses a point twice has no area.
    const int b = (a + (OneIn(16) ? 0 : 1 + Below(points - 1))) % points;
    const int c = Below(points);
    surface.facets.emplace_back(a, b, c);
    surface.reflectance.push_back(
      OneOf({ 0.0f, 0.5f, 0.95f, 0.999f, 1.0f, static_cast<float>(std::fabs(Anywhere())) }));
    if (emits)
    {
      surface.exitance.push_back(OneOf({ 0.0f, 1e-12f, 100.0f, 1e12f }));
    }
  }
  surface.metresPerUnit = OneOf({ 1.0, 1.0, 1e-3, 0.0254, 1e3 });
  return surface;
}

/// On one of the points, or anywhere about them, near or far.
glm::dvec3 LampPlace(const Surface& surface, const Site& site)
{
  if (OneIn(4))
  {
    return surface.points[static_cast<std::size_t>(Below(static_cast<int>(surface.points.size())))];
  }
  return site.origin +
    (OneIn(16) ? 1e100 : OneOf({ 1.0, 1.0, 1.0, 1e3, 1e9, 1e17 })) * site.size * Place();
}

Lamp DrawLamp(const Surface& surface, const Site& site)
{
  const glm::dvec3 place = LampPlace(surface, site);
  const glm::dvec3 direction = Direction();
  const double flux =
    OneIn(8) ? OneOf({ 1e-300, 1e-200, 1e200, 1e300 }) : OneOf({ 0.0, 1e-12, 1000.0, 1e12 });
  const double width = site.size * OneOf({ 0.0, 1e-6, 0.5, 1e3 });
  switch (Below(surface.exitance.empty() ? 7 : 8))
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
    default:
      return EmittingFacets{};
  }
}

TraceSettings DrawSettings()
{
  TraceSettings settings;
  settings.replicates = 2;
  settings.seed = static_cast<std::uint32_t>(Below(1000));
  settings.sampling = OneIn(2) ? Sampling::Random : Sampling::Sobol;
  settings.registration =
    OneOf({ Registration::VertexNormalised, Registration::FacetRatio, Registration::Flat });
  settings.scatterings = OneIn(8) ? 0u : AllScatterings;
  settings.registerBackSide = OneIn(2);
  settings.weightBound = OneOf({ 16.0f, 1.0f, 2.5f, 0x1p20f });
  settings.maximumPathLength = OneOf({ 20u, 1u, 2u, 200u });
  settings.threads = 1 + Below(2);
  return settings;
}

void SpoilSurface(RandomScene& scene)
{
  Surface& surface = scene.surface;
  const auto f = static_cast<std::size_t>(Below(static_cast<int>(surface.facets.size())));
  switch (Below(6))
  {
    case 0:
      surface.facets[f].y = OneIn(2) ? static_cast<unsigned>(surface.points.size()) : 0xffffffffu;
      scene.mistake = "uses point";
      break;
    case 1:
      surface.points[surface.facets[f].z].y = OneOf({ NoNumber, Infinity, -Infinity });
      scene.mistake = "are not finite";
      break;
    case 2:
      surface.reflectance[f] =
        static_cast<float>(OneOf({ NoNumber, Infinity, -1e-9, 1.0000001, 2.0 }));
      scene.mistake = "is outside [0, 1]";
      break;
    case 3:
      surface.exitance.assign(surface.facets.size(), 1.0f);
      surface.exitance[f] = static_cast<float>(OneOf({ NoNumber, Infinity, -1.0 }));
      scene.mistake = "is not a finite number >= 0";
      break;
    case 4:
      surface.metresPerUnit = OneOf({ 0.0, -1.0, NoNumber, Infinity });
      scene.mistake = "metres per unit";
      break;
    default:
      surface.normals.pop_back();
      scene.mistake = "normals for";
  }
}

void SpoilLamp(RandomScene& scene)
{
  const double bad = OneOf({ NoNumber, Infinity, -Infinity });
  switch (Below(4))
  {
    case 0:
      scene.lamp = PointLamp{ { 0.0, bad, 0.0 }, 1.0 };
      scene.mistake = "lamp position";
      break;
    case 1:
      scene.lamp = ParallelLight{ glm::dvec3(OneIn(2) ? bad : 0.0), 1.0 };
      scene.mistake = "lamp direction";
      break;
    case 2:
      scene.lamp = PointLamp{ {}, OneIn(2) ? bad : -1.0 };
      scene.mistake = "luminous flux";
      break;
    default:
      scene.lamp = SpotLamp{ {}, { 0.0, 0.0, 1.0 }, OneIn(2) ? bad : 0.0, 0.0, 1.0 };
      scene.mistake = "spot half-angle";
  }
}

} // namespace

RandomScene DrawScene()
{
  const double size = OneIn(8) ? OneOf({ 1e-310, 1e-200, 1e-100, 1e100, 1e200, 1e300 })
                               : OneOf({ 1.0, 1.0, 1e-6, 1e6, 1e-30, 1e30 });
  const double far = size * OneOf({ 0.0, 0.0, 1.0, 1e3, 1e7 });
  const Site site{ size, far * glm::dvec3(1.0, -0.7, 0.3) };
  RandomScene scene;
  scene.surface = DrawSurface(site);
  scene.lamp = DrawLamp(scene.surface, site);
  scene.settings = DrawSettings();
  scene.photons = 512;
  return scene;
}

RandomScene DrawSceneWithMistake()
{
  RandomScene scene = DrawScene();
  if (OneIn(2))
  {
    SpoilSurface(scene);
    return scene;
  }
  // The surface is looked at before the lamp, so it must not be refused.
  scene.surface.points = { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } };
  scene.surface.normals.resize(3);
  scene.surface.facets.assign(scene.surface.facets.size(), { 0, 1, 2 });
  SpoilLamp(scene);
  return scene;
}
