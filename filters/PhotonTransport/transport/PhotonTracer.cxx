// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/PhotonTracer.h"

#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/scene/ParallelFor.h"
#include "PhotonTransport/transport/CompiledWalks.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <thread>

namespace PhotonTransport
{
namespace
{

/// A roulette for each material, if the walk needs them.
FacetRoulettes MakeRoulettes(const Scene& scene, Walk walk, bool colour)
{
  FacetRoulettes made;
  if (walk == Walk::Ends || walk == Walk::Diffuse)
  {
    return made;
  }
  made.ofFacet = scene.MaterialOfFacet();
  for (const Material& material : scene.Materials())
  {
    made.roulettes.push_back(MakeRoulette(material, colour));
  }
  return made;
}

const TraceSettings& Validated(const TraceSettings& settings)
{
  Validate(settings);
  return settings;
}

/// Every illuminance must be a number with all its digits, from that of one photon in 10^10 at the
/// least weight, 2^-28, to that of all photons at the largest factor.
void RequireIlluminanceInRange(const Scene& scene, double flux)
{
  constexpr double LeastShare = 0x1p-62;
  double least = std::numeric_limits<double>::max();
  double largest = 0.0;
  for (const double area : scene.VertexAreas())
  {
    least = area > 0.0 ? std::min(least, area) : least;
    largest = std::max(largest, area);
  }
  const double brightest = flux / least * double{ LargestFactor };
  const double faintest = flux * LeastShare / largest;
  if (!std::isfinite(brightest) || (flux > 0.0 && !std::isnormal(faintest)))
  {
    std::ostringstream message;
    message << "a luminous flux of " << flux << " lm on areas around points of " << least << " to "
            << largest << " m^2 is an illuminance beyond what a number can hold";
    throw InvalidInput(InvalidInput::Where::LampSettings, 0, message.str());
  }
}

int ThreadCount(const TraceSettings& settings)
{
  return settings.threads > 0 ? settings.threads : tbb::info::default_concurrency();
}

} // namespace

/// The threads, each with its own sums: one map shared by atomic additions would cost 16 %.
struct PhotonTracer::Workers
{
  explicit Workers(int threads)
    : limit(MoreThanCores(threads))
    , arena(threads)
    , sums(static_cast<std::size_t>(threads))
  {
  }

  /// oneTBB by itself never runs more threads than there are cores.
  static std::unique_ptr<tbb::global_control> MoreThanCores(int threads)
  {
    constexpr auto Limit = tbb::global_control::max_allowed_parallelism;
    const auto wanted = static_cast<std::size_t>(threads);
    return wanted > tbb::global_control::active_value(Limit)
      ? std::make_unique<tbb::global_control>(Limit, wanted)
      : nullptr;
  }

  std::unique_ptr<tbb::global_control> limit;
  tbb::task_arena arena;
  std::vector<IlluminationSums> sums;
};

PhotonTracer::PhotonTracer(
  const Scene& scene, const Lighting& lighting, const TraceSettings& settings)
  : LitScene(scene)
  , Settings(Validated(settings))
  , EffectsFound(AnalyseEffects(scene, lighting, settings))
  , Source(lighting, scene, this->EffectsFound.colour)
  , OwnWalk(settings.mostGeneralWalk ? Walk::General : WalkFor(this->EffectsFound))
  , Materials(MakeRoulettes(scene, this->OwnWalk, this->EffectsFound.colouredFacets))
  , Pool(MakeProcessPtr<Workers>(ThreadCount(settings)))
{
  RequireIlluminanceInRange(scene, this->Flux());
  for (IlluminationSums& sums : this->Pool->sums)
  {
    sums = this->EmptySums();
  }
}

PhotonTracer::~PhotonTracer() = default;

IlluminationSums PhotonTracer::EmptySums() const
{
  const std::size_t vertices = this->LitScene.Vertices().size();
  const std::size_t lamps = this->Source.Lamps();
  return { vertices, this->Settings.registerBackSide, lamps,
    { vertices, this->EffectsFound.colour, this->Settings.lampsApart ? lamps : 0 } };
}

std::optional<glm::uvec3> PhotonTracer::CornersLitFromBehind(std::uint32_t lamp) const
{
  constexpr std::uint64_t Tries = 1u << 16;
  PhotonSample sample({ this->Settings.seed, 0, this->Settings.sampling }, 0);
  for (std::uint64_t photon = 0; photon < Tries; ++photon, sample.Advance())
  {
    const Emission emission = this->Source.Emit(sample);
    if (emission.lamp != lamp)
    {
      continue;
    }
    Hit hit;
    this->LitScene.Intersect(&emission.ray, &hit, 1);
    if (!hit)
    {
      continue;
    }
    const Facet& facet = this->LitScene.Facets()[hit.facet];
    const bool front = glm::dot(emission.ray.direction, facet.normal) < 0.0f ||
      this->LitScene.PreferFront(emission.ray, hit);
    const bool translucent = !this->Materials.ofFacet.empty() &&
      this->Materials.roulettes[this->Materials.ofFacet[hit.facet]].translucent;
    if (!front && !translucent)
    {
      return facet.vertices;
    }
  }
  return std::nullopt;
}

bool PhotonTracer::Trace(std::uint32_t replicate, std::uint64_t first, std::uint64_t count,
  IlluminationSums& sums, const Monitor& monitor, LightLayers* layers)
{
  const WalkSettings walk{ this->LitScene, this->Materials, this->Source,
    { this->Settings.seed, replicate, this->Settings.sampling }, this->Settings.maximumPathLength,
    this->EffectsFound.simulated };
  const BlockTracer traceBlock = CompiledWalk(this->OwnWalk,
    this->Settings.mostGeneralWalk ? this->Settings.registration : this->EffectsFound.registration,
    this->Settings.registerBackSide);
  std::atomic<bool> goOn{ true };
  std::atomic<std::uint64_t> done{ 0 };
  const std::thread::id caller = std::this_thread::get_id();

  const auto work = [&](const tbb::blocked_range<std::uint64_t>& blocks)
  {
    const auto thread = static_cast<std::size_t>(tbb::this_task_arena::current_thread_index());
    IlluminationSums& own = this->Pool->sums[thread];
    for (std::uint64_t block = blocks.begin(); block < blocks.end() && goOn; ++block)
    {
      traceBlock(
        walk, this->Settings.weightBound, block * PhotonBlock, (block + 1) * PhotonBlock, own);
      ++done;
      if (monitor && std::this_thread::get_id() == caller && !monitor(done))
      {
        goOn = false;
      }
    }
  };
  this->Pool->arena.execute([&] { ParallelFor(first, first + count, work); });
  for (IlluminationSums& own : this->Pool->sums)
  {
    MoveInto(sums, layers ? *layers : sums.layers, own);
  }
  return goOn;
}

} // namespace PhotonTransport
