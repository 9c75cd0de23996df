// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/PhotonTracer.h"

#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/threads/Threads.h"
#include "PhotonTransport/transport/CompiledWalks.h"

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

} // namespace

struct PhotonTracer::Implementation
{
  Implementation(const Scene& scene, const Lighting& lighting, const Effects& effects,
    const TraceSettings& settings)
    : source(lighting, scene, effects.colour)
    , walk(settings.mostGeneralWalk ? Walk::General : WalkFor(effects))
    , materials(MakeRoulettes(scene, this->walk, effects.colouredFacets))
    , workers(settings.threads)
    , workerSums(ThreadCount(settings.threads))
  {
  }

  Emitter source;
  Walk walk;
  FacetRoulettes materials;
  Threads workers;
  /// Each thread has sums of its own: sharing one map by atomic additions costs 16 %.
  PerThread<IlluminationSums> workerSums;
};

PhotonTracer::PhotonTracer(
  const Scene& scene, const Lighting& lighting, const TraceSettings& settings)
  : LitScene(scene)
  , Settings(Validated(settings))
  , EffectsFound(AnalyseEffects(scene, lighting, settings))
  , Impl(std::make_unique<Implementation>(scene, lighting, this->EffectsFound, settings))
{
  RequireIlluminanceInRange(scene, this->Flux());
  this->Impl->workerSums.Fill(this->EmptySums());
}

PhotonTracer::~PhotonTracer() = default;

double PhotonTracer::Flux() const
{
  return this->Impl->source.Flux();
}

IlluminationSums PhotonTracer::EmptySums() const
{
  const std::size_t vertices = this->LitScene.NumberOfMapVertices();
  const std::size_t lamps = this->Impl->source.Lamps();
  return { vertices, this->Settings.registerBackSide, lamps,
    { vertices, this->EffectsFound.colour, this->Settings.lampsApart ? lamps : 0 } };
}

std::optional<glm::uvec3> PhotonTracer::CornersLitFromBehind(std::uint32_t lamp) const
{
  constexpr std::uint64_t Tries = 1u << 16;
  PhotonSample sample({ this->Settings.seed, 0, this->Settings.sampling }, 0);
  for (std::uint64_t photon = 0; photon < Tries; ++photon, sample.Advance())
  {
    const Emission emission = this->Impl->source.Emit(sample);
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
    const bool translucent = !this->Impl->materials.ofFacet.empty() &&
      this->Impl->materials.roulettes[this->Impl->materials.ofFacet[hit.facet]].translucent;
    if (!front && !translucent)
    {
      return this->LitScene.GivenVertices(hit.facet);
    }
  }
  return std::nullopt;
}

bool PhotonTracer::Trace(std::uint32_t replicate, std::uint64_t first, std::uint64_t count,
  IlluminationSums& sums, const Monitor& monitor, LightLayers* layers)
{
  const WalkSettings walk{ this->LitScene, this->Impl->materials, this->Impl->source,
    { this->Settings.seed, replicate, this->Settings.sampling }, this->Settings.maximumPathLength,
    this->EffectsFound.simulated };
  const BlockTracer traceBlock = CompiledWalk(this->Impl->walk,
    this->Settings.mostGeneralWalk ? this->Settings.registration : this->EffectsFound.registration,
    this->Settings.registerBackSide);
  std::atomic<bool> goOn{ true };
  std::atomic<std::uint64_t> done{ 0 };
  const std::thread::id caller = std::this_thread::get_id();

  const auto work = [&](std::uint64_t begin, std::uint64_t end)
  {
    IlluminationSums& own = this->Impl->workerSums.Own();
    for (std::uint64_t block = begin; block < end && goOn; ++block)
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
  this->Impl->workers.Run([&] { ParallelFor(first, first + count, work); });
  for (IlluminationSums& own : this->Impl->workerSums)
  {
    MoveInto(sums, layers ? *layers : sums.layers, own);
  }
  return goOn;
}

} // namespace PhotonTransport
