// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/PhotonTracer.h"

#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/transport/ParallelFor.h"
#include "PhotonTransport/transport/Walk.h"

#include <oneapi/tbb/global_control.h>
#include <oneapi/tbb/info.h>
#include <oneapi/tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
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

template <Registration Kind, bool Interreflection, bool BackSide>
void TraceBlock(const Job& job, std::uint64_t first, std::uint64_t last, IlluminationSums& sums)
{
  const Registrar<Kind, BackSide> registrar(job.walk.scene, job.weightBound, sums);
  WalkPhotons<Interreflection>(job.walk, first, last, registrar, sums.balance);
}

using BlockTracer = void (*)(const Job&, std::uint64_t, std::uint64_t, IlluminationSums&);

template <Registration Kind>
BlockTracer ChooseFor(const Effects& effects)
{
  if (effects.interreflection)
  {
    return effects.backSide ? TraceBlock<Kind, true, true> : TraceBlock<Kind, true, false>;
  }
  return effects.backSide ? TraceBlock<Kind, false, true> : TraceBlock<Kind, false, false>;
}

/// The walk compiled for just these effects.
BlockTracer Choose(const Effects& effects)
{
  switch (effects.registration)
  {
    case Registration::Flat:
      return ChooseFor<Registration::Flat>(effects);
    case Registration::FacetRatio:
      return ChooseFor<Registration::FacetRatio>(effects);
    case Registration::VertexNormalised:
      break;
  }
  return ChooseFor<Registration::VertexNormalised>(effects);
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

PhotonTracer::PhotonTracer(const Scene& scene, const Lamp& lamp, const TraceSettings& settings)
  : Surroundings(scene)
  , Settings(Validated(settings))
  , Source(lamp, scene)
  , Answer(AnalyseEffects(scene, settings))
  , Pool(std::make_unique<Workers>(ThreadCount(settings)))
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
  return { this->Surroundings.Vertices().size(), this->Settings.registerBackSide };
}

bool PhotonTracer::Trace(std::uint32_t replicate, std::uint64_t first, std::uint64_t count,
  IlluminationSums& sums, const Monitor& monitor)
{
  const Job job{ { this->Surroundings, this->Source,
                   { this->Settings.seed, replicate, this->Settings.sampling },
                   this->Settings.interreflection ? this->Settings.maximumPathLength : 1u },
    this->Settings.weightBound };
  const BlockTracer traceBlock = Choose(this->Answer);
  std::atomic<bool> goOn{ true };
  std::atomic<std::uint64_t> done{ 0 };
  const std::thread::id caller = std::this_thread::get_id();

  const auto work = [&](const tbb::blocked_range<std::uint64_t>& blocks)
  {
    IlluminationSums& own =
      this->Pool->sums[static_cast<std::size_t>(tbb::this_task_arena::current_thread_index())];
    for (std::uint64_t block = blocks.begin(); block < blocks.end() && goOn; ++block)
    {
      traceBlock(job, block * PhotonBlock, (block + 1) * PhotonBlock, own);
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
  return goOn;
}

} // namespace PhotonTransport
