// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/filtration/Filtration.h"

#include "PhotonTransport/filtration/DarkRegions.h"
#include "PhotonTransport/filtration/ExpectedError.h"
#include "PhotonTransport/filtration/NoiseModel.h"
#include "PhotonTransport/filtration/ScaleSelection.h"
#include "PhotonTransport/filtration/SpectralFilter.h"
#include "PhotonTransport/filtration/VertexOrder.h"
#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/threads/Threads.h"
#include "PhotonTransport/transport/TraceSettings.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <string>

namespace PhotonTransport
{
namespace
{

using Values = std::vector<double>;

void RequireWithin(const char* name, double value, double most)
{
  if (!(value >= 0.0 && value <= most))
  {
    throw InvalidInput(InvalidInput::Where::TraceSettings, 0,
      std::string("the ") + name + " is " + std::to_string(value) + "; it must be within [0, " +
        std::to_string(static_cast<int>(most)) + "]");
  }
}

void RequireFinite(const std::string& name, const Values& values)
{
  for (std::size_t v = 0; v < values.size(); ++v)
  {
    if (!(values[v] >= 0.0) || !std::isfinite(values[v]))
    {
      throw InvalidInput(InvalidInput::Where::Point, v,
        name + " is " + std::to_string(values[v]) + "; it must be a finite number >= 0");
    }
  }
}

void RequireFinite(const NoisyMap& part)
{
  RequireFinite(part.name, part.values);
  RequireFinite("the standard error of " + part.name, part.standardError);
  for (std::size_t v = 0; v < part.groups.size(); ++v)
  {
    for (const double value : part.groups[v])
    {
      if (!std::isfinite(value))
      {
        throw InvalidInput(
          InvalidInput::Where::Point, v, "a group mean of " + part.name + " is not finite");
      }
    }
  }
}

Values SumOf(const std::vector<NoisyMap>& parts)
{
  Values sum(parts.front().values.size(), 0.0);
  for (const NoisyMap& part : parts)
  {
    std::transform(sum.begin(), sum.end(), part.values.begin(), sum.begin(), std::plus<>());
  }
  return sum;
}

/// What a squared error counts, by how bright the neighbourhood is: errors are seen relative to
/// the light around them, but those in the dark don't count without bound.
std::vector<float> Importance(
  const SmoothingGraph& graph, const Values& total, const FiltrationMonitor& monitor)
{
  constexpr double Neighbourhood = 2.0;
  constexpr double Floor = 0.3;
  Columns<4> light(total.size());
  std::transform(total.begin(), total.end(), light.begin(),
    [](double value) { return std::array<float, 4>{ static_cast<float>(value) }; });
  light = Pool(graph, Neighbourhood, std::move(light), monitor);
  const Values& areas = graph.VertexAreas();
  const double flux = std::inner_product(areas.begin(), areas.end(), total.begin(), 0.0);
  const double mean = flux / std::accumulate(areas.begin(), areas.end(), 0.0);
  std::vector<float> importance(total.size(), 1.0f);
  if (mean > 0.0)
  {
    std::transform(light.begin(), light.end(), importance.begin(),
      [&](const std::array<float, 4>& value)
      { return static_cast<float>(1.0 / (std::max(0.0, double{ value[0] }) / mean + Floor)); });
  }
  return importance;
}

GroupColumns GroupsOf(
  const SmoothingGraph& graph, const NoisyMap& part, const FiltrationMonitor& monitor)
{
  if (part.groups.empty())
  {
    return GroupsFromStandardError(graph, part.values,
      part.standardError.empty() ? StandardErrorFromRoughness(graph, part.values, monitor)
                                 : part.standardError);
  }
  GroupColumns columns(part.groups.size());
  std::transform(part.groups.begin(), part.groups.end(), columns.begin(),
    [](const GroupValues& values)
    {
      std::array<float, Groups> column;
      std::transform(values.begin(), values.end(), column.begin(),
        [](double value) { return static_cast<float>(value); });
      return column;
    });
  return columns;
}

/// Marks the regions that the part certainly does not light; empty if there are none.
std::vector<std::uint8_t> DarkRegionsOf(
  const SmoothingGraph& graph, const Values& part, const Values& total, const Values& hits)
{
  if (hits.empty())
  {
    return {};
  }
  Values ofPart(part.size(), 0.0);
  for (std::size_t v = 0; v < part.size(); ++v)
  {
    ofPart[v] = part[v] > 0.0 ? hits[v] * part[v] / total[v] : 0.0;
  }
  return FindDarkRegions(graph, ofPart);
}

/// The graph without the edges into regions; none if there are no regions.
std::optional<SmoothingGraph> Without(
  const SmoothingGraph& graph, const std::vector<std::uint8_t>& regions)
{
  std::optional<SmoothingGraph> cut;
  if (!regions.empty())
  {
    cut = graph;
    cut->CutAround(regions);
  }
  return cut;
}

/// No value below 0, and the flux of each smooth patch as it was: by a factor, so that dark stays
/// dark.
void Conserve(const SmoothingGraph& graph, const Values& before, Values& after)
{
  Values had(graph.Patches(), 0.0);
  Values has(graph.Patches(), 0.0);
  for (std::size_t v = 0; v < before.size(); ++v)
  {
    after[v] = std::max(0.0, after[v]);
    had[graph.PatchOfVertex()[v]] += graph.VertexAreas()[v] * before[v];
    has[graph.PatchOfVertex()[v]] += graph.VertexAreas()[v] * after[v];
  }
  ForEach(before.size(),
    [&](std::size_t v)
    {
      const std::uint32_t patch = graph.PatchOfVertex()[v];
      after[v] = has[patch] > 0.0 ? after[v] * (had[patch] / has[patch]) : before[v];
    });
}

Selection SmoothEvenly(const SmoothingGraph& graph, const GroupColumns& map, double width,
  const FiltrationMonitor& monitor)
{
  Selection selection{
    Apply<Groups>(graph, { SpectralFilter::Heat(0.5 * width * width) }, map, monitor).front(),
    Values(map.size()), std::vector<float>(map.size(), static_cast<float>(width))
  };
  ForEach(map.size(),
    [&](std::size_t v) { selection.change[v] = MeanOf(selection.groups[v]) - MeanOf(map[v]); });
  return selection;
}

/// The share of all the work from the shares of the filters that are applied one after the other.
FiltrationMonitor ShareOfAll(
  const std::vector<NoisyMap>& parts, FiltrationMethod method, const FiltrationMonitor& monitor)
{
  double filters = 1.0; // for the importance
  for (const NoisyMap& part : parts)
  {
    filters += method == FiltrationMethod::Adaptive ? 8.0 : 3.0;
    filters += part.groups.empty() && part.standardError.empty() ? 2.0 : 0.0;
  }
  return [filters, monitor, begun = 0.0](double share) mutable
  {
    begun += share == 0.0 ? 1.0 : 0.0;
    monitor(std::min(1.0, (begun - 1.0 + share) / filters));
  };
}

Selection Unchanged(const GroupColumns& map)
{
  return { map, Values(map.size(), 0.0), std::vector<float>(map.size(), 0.0f) };
}

/// What the parts of a map share.
struct WholeMap
{
  const SmoothingGraph& graph;
  const Values& total;
  const Values& hits;
  const std::vector<float>& importance;
};

FilteredMap FiltratePart(const NoisyMap& part, const WholeMap& whole,
  const FiltrationSettings& settings, const FiltrationMonitor& monitor)
{
  const std::vector<std::uint8_t> dark =
    DarkRegionsOf(whole.graph, part.values, whole.total, whole.hits);
  const std::optional<SmoothingGraph> cut = Without(whole.graph, dark);
  const SmoothingGraph& graph = cut ? *cut : whole.graph;
  const GroupColumns map = GroupsOf(graph, part, monitor);
  const PhotonNoise photons(graph,
    whole.hits.empty() ? LumensPerPhoton(graph, map)
                       : LumensPerPhoton(graph, whole.total, whole.hits));
  const Selection selection = settings.method == FiltrationMethod::Adaptive
    ? SelectWidths(graph, map, photons, { whole.importance, settings.strength }, monitor)
    : settings.method == FiltrationMethod::Diffusion
    ? SmoothEvenly(graph, map, settings.width, monitor)
    : Unchanged(map);
  FilteredMap result{ part.values,
    ExpectedSquaredError(graph, { map, selection, photons, dark }, monitor), selection.width };
  std::transform(result.values.begin(), result.values.end(), selection.change.begin(),
    result.values.begin(), std::plus<>());
  Conserve(whole.graph, part.values, result.values);
  return result;
}

} // namespace

void Validate(const FiltrationSettings& settings)
{
  RequireWithin("strength", settings.strength, 10.0);
  RequireWithin("width", settings.width, 50.0);
  RequireWithin("number of threads", settings.threads, MostThreads);
}

std::vector<FilteredMap> Filtrate(const SmoothingGraph& graph, const std::vector<NoisyMap>& parts,
  const std::vector<double>& hits, const FiltrationSettings& settings,
  const FiltrationMonitor& caller)
{
  Validate(settings);
  std::for_each(parts.begin(), parts.end(), [](const NoisyMap& part) { RequireFinite(part); });
  const FiltrationMonitor monitor = ShareOfAll(parts, settings.method, caller);
  const VertexOrder order = graph.BreadthFirstOrder();
  const SmoothingGraph ordered(graph, order);
  const Values total = order.Ordered(SumOf(parts));
  const Values orderedHits = order.Ordered(hits);
  const std::vector<float> importance = Importance(ordered, total, monitor);
  std::vector<FilteredMap> filtered;
  for (const NoisyMap& part : parts)
  {
    const NoisyMap own{ part.name, order.Ordered(part.values), order.Ordered(part.groups),
      order.Ordered(part.standardError) };
    const FilteredMap result =
      FiltratePart(own, { ordered, total, orderedHits, importance }, settings, monitor);
    filtered.push_back({ order.Restored(result.values), order.Restored(result.squaredError),
      order.Restored(result.width) });
  }
  return filtered;
}

} // namespace PhotonTransport
