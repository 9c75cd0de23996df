// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/PhotonTracer.h"

#include "PhotonTransport/lights/Emitter.h"
#include "PhotonTransport/registration/FacetCells.h"
#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/threads/Threads.h"
#include "PhotonTransport/transport/CompiledWalks.h"
#include "PhotonTransport/transport/OpeningPhotons.h"
#include "PhotonTransport/transport/PhotonShares.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>
#include <thread>
#include <utility>

namespace PhotonTransport
{
namespace
{

/// A roulette for each material, if the walk needs them.
FacetRoulettes RoulettesFor(const Scene& scene, Walk walk, bool colour)
{
  return walk == Walk::Ends || walk == Walk::Diffuse
    ? FacetRoulettes()
    : MakeRoulettes(scene.Materials(), scene.MaterialOfFacet(), colour);
}

const TraceSettings& Validated(const TraceSettings& settings)
{
  Validate(settings);
  return settings;
}

} // namespace

Lighting Undimmed(Lighting lighting, const TraceSettings& settings)
{
  for (Luminaire& luminaire : lighting.luminaires)
  {
    luminaire.dimming = CanBeRelit(settings) ? 1.0 : luminaire.dimming;
  }
  return lighting;
}

struct PhotonTracer::Implementation
{
  Implementation(const Scene& scene, const Lighting& lighting, const Effects& effects,
    const TraceSettings& settings, Openings toSky)
    : source(Undimmed(lighting, settings), scene, effects.colour, std::move(toSky))
    , walk(settings.mostGeneralWalk ? Walk::General : WalkFor(effects))
    , materials(RoulettesFor(scene, this->walk, effects.colouredFacets))
    , workers(settings.threads)
    , workerSums(static_cast<std::size_t>(ThreadCount(settings.threads)))
  {
    std::vector<double> shares;
    if (this->source.Sources() > this->source.Lamps())
    {
      this->openings = std::make_unique<OpeningPhotons>(scene, this->source,
        OutdoorWays{ effects.simulated, settings.maximumPathLength, effects.colouredFacets,
          LetsLightThrough(this->walk) });
      shares = PhotonShares(scene, this->source, *this->openings, settings.registerBackSide);
    }
    if (CanBeRelit(settings) && this->source.Lamps() > 1)
    {
      shares = SharesForLampsApart(this->source, std::move(shares));
    }
    if (!shares.empty())
    {
      this->source.SetPhotonShares(shares);
    }
  }

  Emitter source;
  Walk walk;
  FacetRoulettes materials;
  std::unique_ptr<OpeningPhotons> openings; ///< Null where no light comes through any.
  Threads workers;
  /// Each thread has sums of its own: sharing one map by atomic additions costs 16 %.
  PerThread<IlluminationSums> workerSums;
  bool hasSums = false; ///< Whether those of threads have room.
};

PhotonTracer::PhotonTracer(const Scene& scene, const Lighting& lighting,
  const TraceSettings& settings, const FacetCells* cells, Openings openings)
  : LitScene(scene)
  , Settings(Validated(settings))
  , Cells(cells)
  , EffectsFound(AnalyseEffects(scene, lighting, settings))
  , ColoursByLamp(
      PhotonTransport::LampsTellColours(lighting, settings, this->EffectsFound.colouredFacets))
  , Impl(std::make_unique<Implementation>(
      scene, lighting, this->EffectsFound, settings, std::move(openings)))
{
  this->RequireIlluminanceInRange(this->Flux());
}

PhotonTracer::~PhotonTracer() = default;

double PhotonTracer::Flux() const
{
  return this->Impl->source.Flux();
}

/// Every illuminance must be a number with all its digits, from that of one photon in 10^10 at the
/// least weight, 2^-28, to that of all photons at the largest factor.
void PhotonTracer::RequireIlluminanceInRange(double flux) const
{
  constexpr double LeastShare = 0x1p-62;
  double least = std::numeric_limits<double>::max();
  double largest = 0.0;
  for (const double area : this->LitScene.VertexAreas())
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

const Emitter& PhotonTracer::Source() const
{
  return this->Impl->source;
}

const std::vector<float>& PhotonTracer::StartWeights() const
{
  return this->Impl->source.StartWeights();
}

const OpeningPhotons* PhotonTracer::OpeningsInUse() const
{
  return this->Impl->openings.get();
}

bool PhotonTracer::CountsCaustics() const
{
  return (this->EffectsFound.simulated & ~DiffuseScatterings) != 0;
}

IlluminationSums PhotonTracer::EmptySums() const
{
  const std::size_t vertices = this->LitScene.NumberOfMapVertices();
  const std::size_t lamps = this->Impl->source.Lamps();
  const std::size_t apart = this->Settings.lampsApart ? lamps : 1;
  const bool colour = this->EffectsFound.colour && !this->LampsTellColours();
  IlluminationSums sums{ vertices, this->Settings.registerBackSide, this->Impl->source.Sources(),
    { vertices * apart, colour }, apart };
  if (this->Cells)
  {
    const std::size_t channels = this->EffectsFound.colour ? LightLayers::Channels : 1;
    sums.cells = { this->Cells->Number(), channels, this->CountsCaustics() };
    if (this->Settings.lampsApart)
    {
      sums.layers.lampCells = { lamps, sums.cells };
    }
  }
  return sums;
}

void PhotonTracer::MakeSums()
{
  if (!this->Impl->hasSums)
  {
    for (IlluminationSums& own : this->Impl->workerSums)
    {
      own = this->EmptySums();
    }
    this->Impl->hasSums = true;
  }
}

void PhotonTracer::FreeSums()
{
  for (IlluminationSums& own : this->Impl->workerSums)
  {
    own = {};
  }
  this->Impl->hasSums = false;
}

std::optional<glm::uvec3> PhotonTracer::CornersLitFromBehind(std::uint32_t lamp) const
{
  constexpr std::uint64_t Tries = 1u << 16;
  PhotonSequence sample({ this->Settings.seed, 0, this->Settings.sampling }, 0);
  for (std::uint64_t photon = 0; photon < Tries; ++photon, sample.Advance())
  {
    const Emission emission = this->Impl->source.Emit(sample);
    if (emission.source != lamp)
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
  IlluminationSums& sums, const Monitor& monitor)
{
  return this->Trace(
    replicate, first, count, [&](IlluminationSums& part) { MoveInto(sums, part); }, monitor);
}

bool PhotonTracer::Trace(std::uint32_t replicate, std::uint64_t first, std::uint64_t count,
  const std::function<void(IlluminationSums& part)>& add, const Monitor& monitor)
{
  const WalkSettings walk{ this->LitScene, this->Impl->materials, this->Impl->source,
    { this->Settings.seed, replicate, this->Settings.sampling }, this->Settings.maximumPathLength,
    this->EffectsFound.simulated, this->Cells, this->Impl->openings.get() };
  const BlockTracer traceBlock = CompiledWalk(this->Impl->walk,
    { this->Settings.mostGeneralWalk ? this->Settings.registration
                                     : this->EffectsFound.registration,
      this->Settings.registerBackSide, this->Cells != nullptr });
  std::atomic<bool> goOn{ true };
  std::atomic<std::uint64_t> done{ 0 };
  const std::thread::id caller = std::this_thread::get_id();

  this->MakeSums();
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
  this->Impl->workers.Run(
    [&]
    {
      ParallelFor(first, first + count, work);
      for (IlluminationSums& own : this->Impl->workerSums)
      {
        add(own);
      }
    });
  return goOn;
}

} // namespace PhotonTransport
