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

IlluminationMap SecondPass::Together(Parts<IlluminationMap> parts) const
{
  IlluminationMap& map = parts.caustics;
  map.caustic = map.indirect;
  for (std::size_t v = 0; v < map.direct.size() && !parts.gathered.direct.empty(); ++v)
  {
    map.direct[v] += parts.factor * parts.gathered.direct[v];
    map.indirect[v] += parts.factor * parts.gathered.gathered[v];
    map.standardError[v] = std::hypot(this->Tracer.CountsCaustics() ? map.standardError[v] : 0.0,
      parts.factor * parts.gathered.standardError[v]);
  }
  return std::move(map);
}

std::vector<std::array<double, 3>> SecondPass::Together(
  Parts<std::vector<std::array<double, 3>>> parts)
{
  for (std::size_t v = 0; v < parts.gathered.channels.size(); ++v)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      parts.caustics[v][c] += parts.factor * parts.gathered.channels[v][c] /
        double{ LuminousWeights[static_cast<int>(c)] };
    }
  }
  return std::move(parts.caustics);
}

std::vector<double> SecondPass::Together(Parts<std::vector<double>> parts, std::size_t lamp)
{
  const std::vector<double>& ofLamps = parts.gathered.ofLamps;
  if (!ofLamps.empty())
  {
    const std::size_t lamps = ofLamps.size() / parts.gathered.direct.size();
    for (std::size_t v = 0; v < parts.caustics.size(); ++v)
    {
      parts.caustics[v] += parts.factor * ofLamps[v * lamps + lamp];
    }
  }
  return std::move(parts.caustics);
}

} // namespace PhotonTransport
