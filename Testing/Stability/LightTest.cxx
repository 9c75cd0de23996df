// SPDX-License-Identifier: BSD-3-Clause
// Cases 1 and 7: grazing light, and lamps in odd places.
#include "CoreTools.h"

#include "PhotonTransport/scene/InvalidInput.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

using namespace PhotonTransport;
using Shapes::Facing;

namespace
{

constexpr double Pi = 3.14159265358979323846;

ParallelLight Slanted(double degrees)
{
  const double angle = degrees * Pi / 180.0;
  return { { std::sin(angle), 0.0, -std::cos(angle) }, 1000.0 };
}

Shapes::Surface Plane(int cells)
{
  return Shapes::Rectangle({ -1.0, -1.0, 0.0 }, { 2.0, 0.0, 0.0 }, { 0.0, 2.0, 0.0 }, cells);
}

using Case1 = EveryWay;
using Case7 = EveryWay;

} // namespace

INSTANTIATE_TEST_SUITE_P(Stability, Case1, AllWays(), NameOfWay);
INSTANTIATE_TEST_SUITE_P(Stability, Case7, AllWays(), NameOfWay);

// All facets of a plane show what its normal says, so that every registration gives E cos(angle) in
// all; a single tilted facet is such a plane.
TEST_P(Case1, GrazingLightOnAPlaneAndOnATiltedFacet)
{
  Shapes::Surface facet = Plane(1);
  facet.facets.resize(1);
  facet.materialOfFacet.resize(1);
  struct Flat
  {
    Shapes::Surface surface;
    double area;
  };
  double largest = 0.0;
  for (const Flat& flat : { Flat{ Plane(4), 4.0 }, Flat{ facet, 2.0 } })
  {
    for (const double degrees : { 60.0, 80.0, 89.0, 89.9, 89.99, 89.999 })
    {
      const TracedMap run(flat.surface, Slanted(degrees), GetParam().Settings(), 50'000);
      const double expected = 1000.0 * flat.area * std::cos(degrees * Pi / 180.0);
      const double off = run.RegisteredFlux(run.front) - expected;
      // Rays start from a disk around the plane's shadow: the share that hits is binomial.
      const double share = expected / run.flux;
      const double error =
        run.flux * std::sqrt(share * (1.0 - share) / static_cast<double>(run.balance.emitted));
      // A float direction is off by 2^-24 of a right angle's sine, which is light of its own there.
      const double rounding = 1000.0 * flat.area * 0x1p-23;
      EXPECT_NEAR(off, 0.0, 4.0 * error + rounding) << degrees << " degrees";
      largest = std::max(largest, std::fabs(off) / (error + rounding));
    }
  }
  char text[80];
  std::snprintf(
    text, sizeof(text), "60 to 89.999 degrees: at most %.1f standard errors off", largest);
  Report("light that barely touches a plane is lost or blown up", text);
}

TEST_P(Case1, LightAlongAPlaneLeavesItDark)
{
  const TracedMap run(Plane(4), Slanted(90.0), GetParam().Settings(), 50'000);
  const double most = std::max(run.RegisteredFlux(run.front), run.RegisteredFlux(run.back));
  EXPECT_LE(most, 4000.0 * 0x1p-23 * 10.0); // the direction's rounding, times compensation
  Report(
    "division by a cosine of 0", "light at 90 degrees registers no more than rounding lets in");
}

TEST_P(Case1, GrazingLightOnCurvedShapes)
{
  double cut = 0.0;
  double error = 0.0;
  for (const Shapes::Surface& surface : { Shapes::Octasphere(3, Facing::Outward),
         Shapes::Tube(24, 4, Facing::Outward), Shapes::Torus(24, 8, Facing::Outward) })
  {
    for (const double degrees : { 0.0, 60.0, 89.999, 90.0 })
    {
      const TracedMap run(surface, Slanted(degrees), GetParam().Settings(), 50'000);
      cut = std::max(cut, run.fluxCut / run.flux);
      error = std::max(error, run.FluxError() / run.flux);
      if (GetParam().registration == Registration::VertexNormalised)
      {
        EXPECT_LE(run.fluxCut, run.FluxError()) << degrees << " degrees";
      }
    }
  }
  char text[80];
  std::snprintf(
    text, sizeof(text), "cut off at most %.1g of the flux, standard error %.1g", cut, error);
  Report("weights without bound where facets turn away from the light", text);
}

// A sphere in light of luminance L from everywhere: pi L at each point. FacetRatio registers only
// (1 + cos)/2 of it where a facet is tilted, and its weights have no variance but for the bound.
TEST_P(Case1, LightFromAllSidesOnACoarseSphere)
{
  const UniformSky sky{ { 0.0, 0.0, 1.0 }, 1000.0, true };
  const TracedMap run(Shapes::Icosphere(1, Facing::Outward), sky, GetParam().Settings(), 400'000);
  double area = 0.0;
  double square = 0.0;
  for (std::size_t v = 0; v < run.scene.VertexAreas().size(); ++v)
  {
    area += run.scene.VertexAreas()[v];
    square += std::pow(run.scene.VertexAreas()[v] * run.front.standardError[v], 2);
  }
  const double mean = run.RegisteredFlux(run.front) / area / (1000.0 * Pi);
  const double error = std::sqrt(3.0 * square) / area / (1000.0 * Pi);
  if (GetParam().registration == Registration::VertexNormalised)
  {
    // The ring sees every direction that the smooth surface sees, but those within the facets'
    // tilt of the horizon, where its cosine is below the sine of the tilt, some from one facet
    // only.
    EXPECT_NEAR(mean, 1.0, 4.0 * error + run.fluxCut / run.flux);
  }
  EXPECT_LE(mean, 1.0 + 4.0 * error);
  char text[80];
  std::snprintf(text, sizeof(text), "%.4f of the exact mean, standard error %.4f", mean, error);
  Report("infinite variance under light from everywhere", text);
}

TEST_P(Case7, LampsInOddPlaces)
{
  const Shapes::Surface box = Shapes::WithReflectance(
    Shapes::Together(Shapes::Box({ -1, -1, -1 }, { 1, 1, 1 }, 4, Facing::Inward),
      Shapes::Box({ -0.2, -0.2, -0.2 }, { 0.2, 0.2, 0.2 }, 2, Facing::Outward)),
    0.5f);
  const glm::dvec3 down(0.0, 0.0, -1.0);
  const glm::dvec3 any(0.3, 0.4, 0.5);
  const std::vector<std::pair<const char*, Lamp>> lamps{
    { "on the surface", PointLamp{ { 1.0, 0.3, 0.3 }, 1000.0 } },
    { "on a vertex", PointLamp{ { 1.0, 1.0, 1.0 }, 1000.0 } },
    { "on an edge", SpotLamp{ { 1.0, 1.0, 0.0 }, { -1.0, -1.0, 0.0 }, 0.5, 0.0, 1000.0 } },
    { "inside a solid", PointLamp{ { 0.0, 0.0, 0.0 }, 1000.0 } },
    { "panel on the ceiling", RectangleLamp{ { 0.0, 0.0, 1.0 }, down, 1.0, 1.0, 1000.0 } },
    { "no size", RectangleLamp{ any, down, 0.0, 0.0, 1000.0 } },
    { "no width", RectangleLamp{ any, down, 0.0, 1.0, 1000.0 } },
    { "no radius", DiskLamp{ any, down, 0.0, 1000.0 } },
    { "no flux", PointLamp{ any, 0.0 } },
    { "larger than the scene", DiskLamp{ { 0.0, 0.0, 5.0 }, down, 1e6, 1000.0 } },
    { "turned away", LambertianPointLamp{ { 0.0, 0.0, 5.0 }, { 0.0, 0.0, 1.0 }, 1000.0 } },
    { "far away", PointLamp{ { 1e9, 0.0, 0.0 }, 1000.0 } },
    { "a direction of 1e-30", SpotLamp{ any, { 0.0, 0.0, -1e-30 }, 0.5, 0.0, 1000.0 } },
    { "a direction of 1e30", SpotLamp{ any, { 0.0, 1e30, 0.0 }, 0.5, 0.0, 1000.0 } },
    { "all round", SpotLamp{ any, down, Pi, 0.0, 1000.0 } },
    { "a hair's cone", SpotLamp{ any, down, 1e-6, 0.0, 1000.0 } },
    { "an exponent of 1e6", SpotLamp{ any, down, 0.5, 1e6, 1000.0 } },
  };
  for (const auto& [what, lamp] : lamps)
  {
    SCOPED_TRACE(what);
    const TracedMap run(box, lamp, GetParam().Settings(), 4'000);
    EXPECT_GT(run.balance.emitted, 0u);
  }
  Report("lamps where nobody would put them", std::to_string(lamps.size()) + " lamps: sound maps");
}

TEST_P(Case7, LampsThatAreNoneAreRefused)
{
  const Shapes::Surface plane = Plane(2);
  const glm::dvec3 down(0.0, 0.0, -1.0);
  const std::vector<Lamp> lamps{ ParallelLight{ {}, 1.0 }, SpotLamp{ {}, {}, 0.5, 0.0, 1.0 },
    SpotLamp{ {}, down, 0.0, 0.0, 1.0 }, SpotLamp{ {}, down, 4.0, 0.0, 1.0 }, PointLamp{ {}, -1.0 },
    PointLamp{ { std::nan(""), 0.0, 0.0 }, 1.0 }, EmittingFacets{} };
  for (std::size_t i = 0; i < lamps.size(); ++i)
  {
    EXPECT_THROW(TracedMap(plane, lamps[i], GetParam().Settings(), 1), InvalidInput)
      << "lamp " << i;
  }
  Report(
    "a lamp without direction, cone, sign or place", std::to_string(lamps.size()) + " refused");
}
