// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/PhotonTracer.h"

#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/scene/ParallelFor.h"
#include "PhotonTransport/transport/Walk.h"

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

struct Job
{
  WalkSettings walk;
  float weightBound;
};

/// Flattened: with so many walks in one file, compilers stop inlining what is hot in each.
template <Registration Kind, bool BackSide, Walk Way>
[[gnu::flatten]] void TraceBlock(const Job& job, std::uint64_t first, std::uint64_t last,
  IlluminationSums& sums, LightLayers& layers)
{
  const Registrar<Kind, BackSide> registrar(job.walk.scene, job.weightBound, sums, layers);
  WalkPhotons<Way>(job.walk, first, last, registrar, sums.balance, sums.arrivals.data());
}

using BlockTracer = void (*)(
  const Job&, std::uint64_t, std::uint64_t, IlluminationSums&, LightLayers&);

template <Registration Kind, bool BackSide>
BlockTracer Choose(Walk way)
{
  switch (way)
  {
    case Walk::Ends:
      return TraceBlock<Kind, BackSide, Walk::Ends>;
    case Walk::Diffuse:
      return TraceBlock<Kind, BackSide, Walk::Diffuse>;
    case Walk::Coloured:
      return TraceBlock<Kind, BackSide, Walk::Coloured>;
    case Walk::Reflecting:
      return TraceBlock<Kind, BackSide, Walk::Reflecting>;
    case Walk::Transmitting:
      return TraceBlock<Kind, BackSide, Walk::Transmitting>;
    case Walk::General:
      break;
  }
  return TraceBlock<Kind, BackSide, Walk::General>;
}

template <Registration Kind>
BlockTracer Choose(Walk way, bool backSide)
{
  return backSide ? Choose<Kind, true>(way) : Choose<Kind, false>(way);
}

/// The walk compiled for just these effects.
BlockTracer Choose(Registration registration, Walk way, bool backSide)
{
  switch (registration)
  {
    case Registration::Flat:
      return Choose<Registration::Flat>(way, backSide);
    case Registration::FacetRatio:
      return Choose<Registration::FacetRatio>(way, backSide);
    case Registration::VertexNormalised:
      break;
  }
  return Choose<Registration::VertexNormalised>(way, backSide);
}

/// The walk that a scene needs. Effects that are switched off count, too: the walk must still find
/// the photons that would have taken that way, and end them.
Walk WalkFor(const Effects& effects, const TraceSettings& settings)
{
  if (settings.mostGeneralWalk)
  {
    return Walk::General;
  }
  const bool reflects = (effects.present & Reflections) != 0;
  const bool transmits = (effects.present & Transmissions) != 0;
  if (reflects || transmits)
  {
    return reflects && transmits ? Walk::General
                                 : (reflects ? Walk::Reflecting : Walk::Transmitting);
  }
  if (effects.present == 0)
  {
    return Walk::Ends;
  }
  return effects.colouredFacets ? Walk::Coloured : Walk::Diffuse;
}

/// A roulette for each material, or, where there are no materials, for each reflectance.
FacetRoulettes MakeRoulettes(const Scene& scene, Walk way, bool colour)
{
  FacetRoulettes made;
  if (way == Walk::Ends || way == Walk::Diffuse)
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

/// From one photon of 10^10 at the least weight, 2^-28, to all of them at the largest factor: every
/// illuminance must be a number with all its digits.
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

/// The threads, each with sums of its own: sharing one map by atomic additions costs 16 %.
struct PhotonTracer::Workers
{
  explicit Workers(int threads)
    : limit(MoreThanCores(threads))
    , arena(threads)
    , sums(static_cast<std::size_t>(threads))
    , layers(static_cast<std::size_t>(threads))
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
  std::vector<LightLayers> layers;
};

PhotonTracer::PhotonTracer(
  const Scene& scene, const Lighting& lighting, const TraceSettings& settings)
  : Surroundings(scene)
  , Settings(Validated(settings))
  , Answer(AnalyseEffects(scene, lighting, settings))
  , Source(lighting, scene, this->Answer.colour)
  , Materials(MakeRoulettes(scene, WalkFor(this->Answer, settings), this->Answer.colouredFacets))
  , Pool(MakeProcessPtr<Workers>(ThreadCount(settings)))
{
  RequireIlluminanceInRange(scene, this->Flux());
  for (IlluminationSums& sums : this->Pool->sums)
  {
    sums = this->EmptySums();
  }
  for (LightLayers& layers : this->Pool->layers)
  {
    layers = this->EmptyLayers();
  }
}

PhotonTracer::~PhotonTracer() = default;

IlluminationSums PhotonTracer::EmptySums() const
{
  return { this->Surroundings.Vertices().size(), this->Settings.registerBackSide,
    this->Source.Lamps() };
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
    this->Surroundings.Intersect(&emission.ray, &hit, 1);
    if (!hit)
    {
      continue;
    }
    const Facet& facet = this->Surroundings.Facets()[hit.facet];
    const bool front = glm::dot(emission.ray.direction, facet.normal) < 0.0f ||
      this->Surroundings.PreferFront(emission.ray, hit);
    const bool translucent = !this->Materials.ofFacet.empty() &&
      this->Materials.roulettes[this->Materials.ofFacet[hit.facet]].translucent;
    if (!front && !translucent)
    {
      return facet.vertices;
    }
  }
  return std::nullopt;
}

LightLayers PhotonTracer::EmptyLayers() const
{
  return { this->Surroundings.Vertices().size(), this->Answer.colour,
    this->Settings.lampsApart ? this->Source.Lamps() : 0 };
}

bool PhotonTracer::Trace(std::uint32_t replicate, std::uint64_t first, std::uint64_t count,
  IlluminationSums& sums, const Monitor& monitor, LightLayers* layers)
{
  const Job job{ { this->Surroundings, this->Materials, this->Source,
                   { this->Settings.seed, replicate, this->Settings.sampling },
                   this->Settings.maximumPathLength, this->Answer.simulated },
    this->Settings.weightBound };
  const BlockTracer traceBlock =
    Choose(this->Settings.mostGeneralWalk ? this->Settings.registration : this->Answer.registration,
      WalkFor(this->Answer, this->Settings), this->Answer.backSide);
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
        job, block * PhotonBlock, (block + 1) * PhotonBlock, own, this->Pool->layers[thread]);
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
    MoveInto(sums, own);
  }
  for (LightLayers& own : this->Pool->layers)
  {
    LightLayers unwanted = layers ? LightLayers() : own;
    MoveInto(layers ? *layers : unwanted, own);
  }
  return goOn;
}

} // namespace PhotonTransport
