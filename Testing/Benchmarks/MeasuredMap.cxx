// SPDX-License-Identifier: BSD-3-Clause
#include "MeasuredMap.h"

#include "Measurement.h"

#include "PhotonTransport/filtration/Filtration.h"
#include "PhotonTransport/threads/Threads.h"
#include "PhotonTransport/transport/IlluminationRun.h"
#include "PhotonTransport/transport/SkyOpenings.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>

using namespace PhotonTransport;

namespace
{

constexpr double CreaseAngle = 40.0 * 3.14159265358979323846 / 180.0;

void Smooth(const Surface& surface, const IlluminationRun& run, int threads, MeasuredMap& result)
{
  const IlluminationMap map = run.Front();
  const GroupMeans groups = run.FrontByGroups();
  FiltrationSettings settings;
  settings.threads = threads;
  const std::vector<double> hits(map.photonHits.begin(), map.photonHits.end());
  const SmoothingGraph graph(surface.points, surface.facets, CreaseAngle);
  if (groups.direct.empty()) // of the second pass: the whole map, by its standard error
  {
    std::vector<double> whole = map.direct;
    std::transform(whole.begin(), whole.end(), map.indirect.begin(), whole.begin(), std::plus<>());
    const std::vector<FilteredMap> filtered =
      Filtrate(graph, { { "whole", whole, {}, map.standardError } }, {}, settings, [](double) {});
    result.lux = filtered.front().values;
    for (const double squared : filtered.front().squaredError)
    {
      result.standardError.push_back(std::sqrt(squared));
    }
    return;
  }
  const std::vector<FilteredMap> parts = Filtrate(graph,
    { { "direct", map.direct, groups.direct, {} },
      { "indirect", map.indirect, groups.indirect, {} } },
    hits, settings, [](double) {});
  for (std::size_t v = 0; v < map.direct.size(); ++v)
  {
    result.lux.push_back(parts[0].values[v] + parts[1].values[v]);
    result.standardError.push_back(std::sqrt(parts[0].squaredError[v] + parts[1].squaredError[v]));
  }
}

void TracePhotons(
  const ReferenceScene& what, const Scene& scene, const MapSettings& settings, MeasuredMap& result)
{
  TraceSettings trace;
  trace.seed = settings.seed;
  trace.threads = settings.threads;
  trace.method = settings.gathered ? Method::FinalGathering : Method::PhotonTracing;
  trace.gatherRays = settings.rays;
  Openings openings;
  if (settings.openings)
  {
    openings = OpeningsToSkies(what.surface, scene, what.lighting, trace).openings;
  }
  IlluminationRun run(scene, what.lighting, trace, openings);
  StopRules rules;
  rules.photons = settings.photons;
  run.Advance(rules);
  if (settings.smoothed)
  {
    Smooth(what.surface, run, settings.threads, result);
    return;
  }
  const IlluminationMap map = run.Front();
  result.standardError = map.standardError;
  for (std::size_t v = 0; v < map.direct.size(); ++v)
  {
    result.lux.push_back(map.direct[v] + map.indirect[v]);
  }
}

} // namespace

MeasuredMap MakeMap(const ReferenceScene& what, const MapSettings& settings)
{
  MeasuredMap result;
  Threads threads(settings.threads);
  result.seconds = Measurement::Seconds(
    [&]
    {
      std::unique_ptr<Scene> scene;
      result.secondsOfScene = Measurement::Seconds(
        [&] { threads.Run([&] { scene = std::make_unique<Scene>(what.surface); }); });
      TracePhotons(what, *scene, settings, result);
    });
  return result;
}
