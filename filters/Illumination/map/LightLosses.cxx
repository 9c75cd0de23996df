// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/map/LightLosses.h"

#include "Illumination/luminaires/LampPlace.h"
#include "Illumination/map/SceneBlocks.h"

#include "PhotonTransport/scene/FacetSide.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <utility>

namespace Illumination
{
namespace
{

using PhotonTransport::Arrivals;
using PhotonTransport::Luminaire;

/// See MissingLight.
constexpr double MostOnBacks = 0.1;
constexpr double MostEscaped = 0.99;
constexpr double MostLostInClosed = 0.1;
constexpr double LeastOfOutdoorLight = 1e-4;

/// What a lamp's light meets.
struct SceneAround
{
  bool closed;
  bool backSide; ///< Whether backs are registered.
};

/// Whether every edge of the surface belongs to two facets or more, by the places of its points.
bool HasNoBoundary(const PhotonTransport::Surface& surface)
{
  using Point = std::array<double, 3>;
  std::vector<std::pair<Point, Point>> edges;
  edges.reserve(3 * surface.facets.size());
  for (const glm::uvec3& facet : surface.facets)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const glm::dvec3& a = surface.points[facet[corner]];
      const glm::dvec3& b = surface.points[facet[(corner + 1) % 3]];
      const std::pair<Point, Point> ends(Point{ a.x, a.y, a.z }, Point{ b.x, b.y, b.z });
      edges.push_back(std::minmax(ends.first, ends.second));
    }
  }
  std::sort(edges.begin(), edges.end());
  for (auto edge = edges.begin(); edge != edges.end();)
  {
    const auto next = std::upper_bound(edge, edges.end(), *edge);
    if (next - edge == 1)
    {
      return false;
    }
    edge = next;
  }
  return true;
}

/// Whether the fronts of a surface without a boundary look inward, as those of a room do and those
/// of bodies in the open do not: the volume inside is then less than 0.
bool LooksInward(const PhotonTransport::Surface& surface)
{
  const glm::dvec3& origin = surface.points[surface.facets.front().x];
  double volume = 0.0;
  for (const glm::uvec3& facet : surface.facets)
  {
    const glm::dvec3 a = surface.points[facet.x] - origin;
    const glm::dvec3 b = surface.points[facet.y] - origin;
    const glm::dvec3 c = surface.points[facet.z] - origin;
    const glm::dvec3 area = glm::cross(b - a, c - a);
    const PhotonTransport::FacetSide side = PhotonTransport::SideOf(
      area, { surface.normals[facet.x], surface.normals[facet.y], surface.normals[facet.z] });
    volume += (side.turned ? -1.0 : 1.0) * glm::dot(a, area);
  }
  return volume < 0.0;
}

/// Whether the surface is closed, so that fronts see nothing but the surface: less than one in a
/// thousand of at least a thousand scattered photons left the scene. From those that left, the
/// photons are subtracted that missed the surface or first arrived on a back. Where fewer photons
/// are scattered, the surface is closed if it has no boundary and its fronts look inward.
bool IsClosed(const TracedScene& traced)
{
  const PhotonTransport::PhotonBalance balance = traced.run.Balance();
  std::uint64_t fromOutside = 0;
  for (const Arrivals& lamp : traced.run.ArrivalsByLamp())
  {
    fromOutside += lamp.escaped + lamp.back;
  }
  const std::uint64_t scattered = balance.segments - balance.emitted;
  const std::uint64_t escaped = balance.escaped - std::min(balance.escaped, fromOutside);
  constexpr std::uint64_t Enough = 1000;
  const PhotonTransport::Surface& surface = traced.blocks.Surface();
  return scattered >= Enough ? escaped * Enough < scattered
                             : LooksInward(surface) && HasNoBoundary(surface);
}

Loss LossFromOutside(const Arrivals& light, const SceneAround& around)
{
  const std::uint64_t onBacks = around.backSide ? 0 : light.back;
  const std::uint64_t met = light.Emitted() - light.escaped;
  if (met == 0 && light.escaped > 0)
  {
    return Loss::OutsideMissed;
  }
  const bool closed = Share(light.front, met) < LeastOfOutdoorLight && 2 * onBacks > met;
  return closed ? Loss::OutsideClosed : Loss::None;
}

Loss LossFromInside(const Arrivals& lamp, const SceneAround& around)
{
  const std::uint64_t onBacks = around.backSide ? 0 : lamp.back;
  const std::uint64_t met = lamp.Emitted() - lamp.escaped;
  if (Share(lamp.escaped, lamp.Emitted()) > MostEscaped)
  {
    return Loss::Escaped;
  }
  if (Share(onBacks, met) > MostOnBacks)
  {
    return Loss::OnBacks;
  }
  if (around.closed && Share(onBacks + lamp.escaped, lamp.Emitted()) > MostLostInClosed)
  {
    return onBacks > lamp.escaped ? Loss::OnBacks : Loss::Escaped;
  }
  return Loss::None;
}

/// Whether a lamp in the scene loses so much that it matters whether the surface is closed.
bool ClosednessMatters(const TracedScene& traced)
{
  const std::vector<Arrivals> arrivals = traced.run.ArrivalsByLamp();
  for (std::size_t lamp = 0; lamp < arrivals.size(); ++lamp)
  {
    if (!ComesFromOutside(traced.lighting.luminaires[lamp]) &&
      LossFromInside(arrivals[lamp], { true, traced.backSide }) !=
        LossFromInside(arrivals[lamp], { false, traced.backSide }))
    {
      return true;
    }
  }
  return false;
}

} // namespace

double Share(std::uint64_t part, std::uint64_t whole)
{
  return whole > 0 ? static_cast<double>(part) / static_cast<double>(whole) : 0.0;
}

bool ComesFromOutside(const Luminaire& luminaire)
{
  const PhotonTransport::LampClass kind = ClassOf(luminaire.lamp);
  return kind == PhotonTransport::LampClass::Parallel || kind == PhotonTransport::LampClass::Sky;
}

std::vector<Loss> LossesByLamp(const TracedScene& traced)
{
  const std::vector<Arrivals> arrivals = traced.run.ArrivalsByLamp();
  const SceneAround around{ ClosednessMatters(traced) && IsClosed(traced), traced.backSide };
  std::vector<Loss> losses;
  for (std::size_t lamp = 0; lamp < arrivals.size(); ++lamp)
  {
    losses.push_back(ComesFromOutside(traced.lighting.luminaires[lamp])
        ? LossFromOutside(arrivals[lamp], around)
        : LossFromInside(arrivals[lamp], around));
  }
  return losses;
}

Lost AllThatLost(Loss way, const std::vector<Loss>& losses, const TracedScene& traced)
{
  const std::vector<Arrivals> arrivals = traced.run.ArrivalsByLamp();
  const auto missing = [](const Arrivals& lamp) { return lamp.back + lamp.escaped; };
  Lost lost;
  for (std::size_t lamp = 0; lamp < arrivals.size(); ++lamp)
  {
    if (losses[lamp] == way)
    {
      if (lost.lamps.empty() || missing(arrivals[lamp]) > missing(arrivals[lost.worst]))
      {
        lost.worst = lamp;
      }
      lost.lamps.push_back(lamp);
      lost.sum += arrivals[lamp];
    }
  }
  return lost;
}

ScatteredLight ScatteredLightOf(const TracedScene& traced)
{
  const PhotonTransport::PhotonBalance balance = traced.run.Balance();
  Arrivals first;
  for (const Arrivals& lamp : traced.run.ArrivalsByLamp())
  {
    first += lamp;
  }
  const bool throughBacks =
    (traced.run.EffectsInUse().present & PhotonTransport::Transmissions) != 0;
  ScatteredLight scattered;
  scattered.met = (balance.segments - balance.escaped) - (balance.emitted - first.escaped);
  scattered.onBacks = traced.backSide || throughBacks ? 0 : balance.onBacks - first.back;
  return scattered;
}

} // namespace Illumination
