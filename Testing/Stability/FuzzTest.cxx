// SPDX-License-Identifier: BSD-3-Clause
// What must hold for any scene at all, however little sense it makes. Thousands of scenes that
// rapidcheck draws; a million with ILLUMINATION_LONG_TESTS=1. RC_PARAMS="seed=..." draws others.
#include "RandomScene.h"

#include "PhotonTransport/scene/CurvedSurface.h"
#include "PhotonTransport/scene/InvalidInput.h"
#include "TracedMap.h"

#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <iterator>
#include <numeric>
#include <string>

namespace
{

using namespace PhotonTransport;

/// A hit may add up to the bound times its barycentric coordinates, whose sum is 1 within 2^-24
/// (two roundings of numbers below 1); the products round by 2^-24 each, and each of the three
/// corners is rounded to a multiple of 2^-28.
constexpr double WeightRounding = 0x1p-22;
constexpr double SumRounding = 3.0 * 0x1p-28;

/// Sanitizers make it ten times slower.
#ifdef __SANITIZE_ADDRESS__
constexpr const char* Draws = "seed=5 max_success=5000";
#else
constexpr const char* Draws = "seed=5 max_success=20000";
#endif

/// How many scenes; RC_PARAMS goes before.
const bool Configured = []
{
  const char* longTests = std::getenv("ILLUMINATION_LONG_TESTS");
  const bool isLong = longTests && std::string(longTests) == "1";
  setenv("RC_PARAMS", isLong ? "seed=5 max_success=1000000" : Draws, 0);
  return true;
}();

/// All sizes of scenes from the start: rapidcheck's own size begins at 0, where all choices are the
/// first one.
RandomScene Drawn(RandomScene (*draw)())
{
  return *rc::gen::resize(rc::kNominalSize, rc::gen::exec(draw)).as("scene");
}

bool AllFinite(const std::vector<double>& values)
{
  return std::all_of(values.begin(), values.end(),
    [](double value) { return std::isfinite(value) && value >= 0.0; });
}

bool AllFinite(const IlluminationMap& map)
{
  return AllFinite(map.direct) && AllFinite(map.indirect) && AllFinite(map.standardError);
}

double FluxOf(const IlluminationMap& map, const std::vector<double>& areas)
{
  double flux = 0.0;
  for (std::size_t v = 0; v < map.direct.size(); ++v)
  {
    flux += areas[v] * (map.direct[v] + map.indirect[v]);
  }
  return flux;
}

std::uint64_t HitsOf(const IlluminationMap& map)
{
  return std::accumulate(map.photonHits.begin(), map.photonHits.end(), std::uint64_t{ 0 });
}

/// A scene without light or surface, or one whose numbers no longer fit.
bool MayBeRefused(const std::string& message)
{
  const char* reasons[] = { "every triangle has zero area", "has an exitance above 0 lm/m^2",
    "photometric solid has no intensity above 0 cd", "times the size of the surface",
    "beyond what a number can hold" };
  return std::any_of(std::begin(reasons), std::end(reasons),
    [&](const char* reason) { return message.find(reason) != std::string::npos; });
}

/// The light that is kept apart adds up to all of it: photons are integers, then there are a few
/// roundings. What leaves a cell is kept in single precision, once for all lamps together and once
/// by lamp, and takes a few roundings of 2^-24 on the way to a sum.
void CheckLayers(const IlluminationRun& run, const IlluminationMap& front, const RandomScene& drawn)
{
  const std::size_t lamps = drawn.settings.lampsApart ? drawn.lighting.luminaires.size() : 0;
  const auto byColour = run.FrontByColour();
  RC_ASSERT(byColour.empty() != run.EffectsInUse().colour);
  std::vector<double> byLamp(front.direct.size(), 0.0);
  for (std::size_t lamp = 0; lamp < lamps; ++lamp)
  {
    const std::vector<double> own = run.FrontOfLamp(lamp);
    std::transform(own.begin(), own.end(), byLamp.begin(), byLamp.begin(), std::plus<>());
  }
  const double Rounding =
    drawn.settings.method == Method::FinalGathering ? 8.0 * 0x1p-24 : 32.0 * 0x1p-53;
  for (std::size_t v = 0; v < front.direct.size(); ++v)
  {
    const double whole = front.direct[v] + front.indirect[v];
    RC_ASSERT(lamps == 0 || std::fabs(byLamp[v] - whole) <= Rounding * whole);
    if (!byColour.empty())
    {
      double sum = 0.0;
      for (std::size_t c = 0; c < 3; ++c)
      {
        sum += double{ LuminousWeights[static_cast<int>(c)] } * byColour[v][c];
      }
      RC_ASSERT(std::fabs(sum - whole) <= Rounding * whole);
    }
  }
}

/// Every hit registers, and brings no more flux than arrived. In the second pass photons register
/// caustics alone.
void CheckHits(const IlluminationRun& run, const Scene& scene, const RandomScene& drawn,
  const IlluminationMap& front, const IlluminationMap& back)
{
  if (drawn.settings.method == Method::FinalGathering)
  {
    RC_ASSERT(AllFinite(front.caustic) && AllFinite(back.caustic));
    for (std::size_t v = 0; v < front.direct.size(); ++v)
    {
      RC_ASSERT(front.caustic[v] <= front.indirect[v]);
    }
    return;
  }
  const bool bothSides = drawn.settings.registerBackSide;
  const PhotonBalance balance = run.Balance();
  const std::uint64_t hits = balance.segments - balance.escaped;
  const std::size_t places = MostFacetsInOnePlace(scene);
  RC_ASSERT(HitsOf(front) + HitsOf(back) <= 3 * hits * places);
  const FluxBalance flux = run.BalanceOfFlux(); // photons may differ in their flux
  const double arrived = flux.segments - flux.escaped;
  const double registered = FluxOf(front, scene.VertexAreas()) + FluxOf(back, scene.VertexAreas());
  const bool flat = drawn.settings.registration == Registration::Flat;
  const double bound = flat ? 1.0 : double{ drawn.settings.weightBound };
  const double most = arrived * static_cast<double>(places);
  const double rounded =
    SumRounding * run.FluxOf(hits) * static_cast<double>(places); // however little a photon has
  RC_ASSERT(registered <= most * bound * (1.0 + WeightRounding) + rounded);
  if (bothSides)
  {
    RC_ASSERT(HitsOf(front) + HitsOf(back) >= 3 * hits);
    RC_ASSERT(!flat || registered >= arrived * (1.0 - WeightRounding) - rounded);
  }
}

/// The surface that is traced. Normals are arbitrary, so patches have hundreds of parts.
Surface SurfaceOf(const RandomScene& drawn)
{
  constexpr std::uint64_t MostFacets = 1000;
  return drawn.settings.curvedSurface ? CurvedSurface(drawn.surface, MostFacets) : drawn.surface;
}

/// The whole of what is promised of one run.
void CheckRun(const RandomScene& drawn)
{
  const Scene scene(SurfaceOf(drawn));
  IlluminationRun run(scene, drawn.lighting, drawn.settings);
  run.Advance({ drawn.photons });

  const PhotonBalance balance = run.Balance();
  RC_ASSERT(balance.emitted == drawn.photons);
  RC_ASSERT(balance.emitted == balance.absorbed + balance.escaped + balance.cutOff);
  Arrivals arrivals;
  for (const Arrivals& lamp : run.ArrivalsByLamp())
  {
    arrivals += lamp;
  }
  RC_ASSERT(balance.emitted == arrivals.Emitted());
  RC_ASSERT(arrivals.escaped <= balance.escaped);
  RC_ASSERT(arrivals.absorbed <= balance.absorbed);
  RC_ASSERT(arrivals.cutOff <= balance.cutOff);
  RC_ASSERT(balance.segments >= balance.emitted);
  RC_ASSERT(balance.segments <= balance.emitted * drawn.settings.maximumPathLength);

  RC_ASSERT(std::accumulate(balance.switchedOff.begin(), balance.switchedOff.end(),
              std::uint64_t{ 0 }) <= balance.cutOff);

  const bool bothSides = drawn.settings.registerBackSide;
  const IlluminationMap front = run.Front();
  const IlluminationMap back = bothSides ? run.Back() : IlluminationMap();
  RC_ASSERT(AllFinite(front) && AllFinite(back));
  RC_ASSERT(AllFinite(scene.VertexAreas()));
  RC_ASSERT(std::isfinite(run.Rounds().back().relativeError));
  RC_ASSERT(std::isfinite(run.Flux()) && std::isfinite(run.FluxCutByWeightBound()));

  CheckLayers(run, front, drawn);
  CheckHits(run, scene, drawn, front, back);
}

/// Multiplies all lengths.
struct Enlarge
{
  double factor;

  template <class AnyLamp>
  void operator()(AnyLamp& lamp) const
  {
    Similarity motion;
    motion.isNone = false;
    motion.scale = this->factor;
    lamp.Move(motion);
  }
  /// A motion would also say which way the width runs, in bits of its own.
  void operator()(RectangleLamp& lamp) const
  {
    lamp.centre *= this->factor;
    lamp.width *= this->factor;
    lamp.height *= this->factor;
  }
  /// A mesh does not move with a motion, since its points have moved already.
  void operator()(EmittingMesh& lamp) const
  {
    for (glm::dvec3& point : lamp.points)
    {
      point *= this->factor;
    }
  }
};

/// The same scene in a unit that is `factor` times shorter.
RandomScene InUnits(RandomScene scene, double factor)
{
  for (glm::dvec3& point : scene.surface.points)
  {
    point *= factor;
  }
  scene.surface.metresPerUnit /= factor;
  for (Luminaire& luminaire : scene.lighting.luminaires)
  {
    std::visit(Enlarge{ factor }, luminaire.lamp);
  }
  return scene;
}

} // namespace

TEST(Fuzz, AnySceneGivesABalancedAndFiniteMap)
{
  std::uint64_t traced = 0;
  std::uint64_t refused = 0;
  rc::detail::checkGTest(
    [&]
    {
      const RandomScene drawn = Drawn(DrawScene);
      try
      {
        CheckRun(drawn);
        ++traced;
      }
      catch (const InvalidInput& error)
      {
        ++refused;
        RC_ASSERT(MayBeRefused(error.what()));
      }
    });
  RecordProperty("protects", "scenes that nobody thought of: crash, NaN, light from nowhere");
  RecordProperty("measured",
    std::to_string(traced) + " random scenes traced, " + std::to_string(refused) + " refused");
  // What is drawn must be worth drawing.
  EXPECT_GT(traced, 4 * refused) << refused << " scenes refused";
}

TEST(Fuzz, AMistakeIsRefusedByName)
{
  RecordProperty("protects", "a wrong value that is traced, or blamed on something else");
  int refused = 0;
  rc::detail::checkGTest(
    [&]
    {
      const RandomScene drawn = Drawn(DrawSceneWithMistake);
      try
      {
        CheckRun(drawn);
        RC_FAIL("not refused");
      }
      catch (const InvalidInput& error)
      {
        RC_ASSERT(std::string(error.what()).find(drawn.mistake) != std::string::npos);
        ++refused;
      }
    });
  RecordProperty("measured", std::to_string(refused) + " refused, each by the name of its mistake");
}

TEST(Fuzz, ThreadsUnitsAndTheGeneralWalkDoNotChangeABit)
{
  RecordProperty("protects", "results that depend on the machine, the unit or the walk chosen");
  int same = 0;
  rc::detail::checkGTest(
    [&]
    {
      RandomScene drawn = Drawn(DrawScene);
      const double factor = std::ldexp(1.0, *rc::gen::inRange(-40, 41).as("power of two"));
      drawn.settings.threads = 1;
      try
      {
        const Scene scene(SurfaceOf(drawn));
        const TracedMap one(scene, drawn.lighting, drawn.settings, drawn.photons);
        RandomScene other = InUnits(drawn, factor);
        other.settings.threads = 2;
        other.settings.mostGeneralWalk = true;
        const Scene otherScene(SurfaceOf(other));
        const TracedMap two(otherScene, other.lighting, other.settings, other.photons);
        RC_ASSERT(one.HasTheBitsOf(two));
        ++same;
      }
      catch (const InvalidInput& error)
      {
        RC_ASSERT(MayBeRefused(error.what()));
      }
    });
  RecordProperty("measured", std::to_string(same) + " pairs with the same bits");
}
