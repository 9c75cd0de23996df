// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/SecondPass.h"

#include "PhotonTransport/gathering/CellLengths.h"
#include "PhotonTransport/lights/Emitter.h"
#include "PhotonTransport/materials/Colour.h"
#include "PhotonTransport/threads/Threads.h"

#include <cmath>
#include <utility>

namespace PhotonTransport
{

PhotonCounts CountsOf(const ReplicateSums& counted)
{
  PhotonCounts counts{ {}, counted.layers.lampCells };
  for (const IlluminationSums& replicate : counted.replicates)
  {
    counts.replicates.push_back(
      { &replicate.cells, static_cast<double>(replicate.Balance().emitted) });
  }
  return counts;
}

std::unique_ptr<const FacetCells> SecondPass::CellsFor(
  const Scene& scene, const TraceSettings& settings)
{
  Validate(settings);
  std::unique_ptr<const FacetCells> cells;
  if (settings.method == Method::FinalGathering)
  {
    Threads(settings.threads)
      .Run(
        [&]
        {
          cells = std::make_unique<FacetCells>(
            scene, CellLengths(scene), FacetCells::MostFor(scene.Facets().size()));
        });
  }
  return cells;
}

SecondPass::SecondPass(const Scene& scene, const FacetCells& cells, const PhotonTracer& tracer,
  const TraceSettings& settings, Openings openings)
  : CellsOfScene(cells)
  , Tracer(tracer)
  , WantedRays(settings.gatherRays)
  , ToSky(std::move(openings))
  , Gathering(scene, cells, tracer.Source(), this->ToSky, tracer.EffectsInUse(),
      GatherSettings{ settings.seed, settings.maximumPathLength, settings.registerBackSide,
        settings.lampsApart, settings.threads })
{
}

std::uint32_t SecondPass::Rays(const ReplicateSums& counted) const
{
  return this->WantedRays > 0 ? this->WantedRays : RaysFor(counted.Balance().emitted);
}

bool SecondPass::Gather(const ReplicateSums& counted, const FinalGathering::Progress& progress)
{
  const bool done = this->Gathering.Gather(CountsOf(counted), this->Rays(counted), progress);
  if (done)
  {
    this->GatheredPhotons = counted.Balance().emitted;
  }
  return done;
}

void SecondPass::Run(
  const ReplicateSums& counted, const std::function<void(const GatherPass& pass)>& work)
{
  this->Gathering.Run(CountsOf(counted), this->Rays(counted), work);
}

IlluminationMap SecondPass::Together(IlluminationMap map, const GatheredMap& gathered) const
{
  map.caustic = map.indirect;
  if (gathered.direct.empty())
  {
    return map;
  }
  for (std::size_t v = 0; v < map.direct.size(); ++v)
  {
    map.direct[v] += gathered.direct[v];
    map.indirect[v] += gathered.gathered[v];
    map.standardError[v] = std::hypot(
      this->Tracer.CountsCaustics() ? map.standardError[v] : 0.0, gathered.standardError[v]);
  }
  return map;
}

std::vector<std::array<double, 3>> SecondPass::Together(
  std::vector<std::array<double, 3>> map, const GatheredMap& gathered)
{
  for (std::size_t v = 0; v < gathered.channels.size(); ++v)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      map[v][c] += gathered.channels[v][c] / double{ LuminousWeights[static_cast<int>(c)] };
    }
  }
  return map;
}

std::vector<double> SecondPass::Together(
  std::vector<double> map, const GatheredMap& gathered, std::size_t lamp)
{
  if (!gathered.ofLamps.empty())
  {
    const std::size_t lamps = gathered.ofLamps.size() / gathered.direct.size();
    for (std::size_t v = 0; v < map.size(); ++v)
    {
      map[v] += gathered.ofLamps[v * lamps + lamp];
    }
  }
  return map;
}

} // namespace PhotonTransport
