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
using PhotonTransport::ArrivedFlux;
using PhotonTransport::Luminaire;
using PhotonTransport::ShareOfLight;

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
  std::uint64_t unscattered = 0;
  for (const Arrivals& lamp : traced.run.ArrivalsByLamp())
  {
    fromOutside += lamp.escaped + lamp.back;
    unscattered += lamp.Emitted();
  }
  const std::uint64_t scattered = balance.segments - std::min(balance.segments, unscattered);
  const std::uint64_t escaped = balance.escaped - std::min(balance.escaped, fromOutside);
  constexpr std::uint64_t Enough = 1000;
  const PhotonTransport::Surface& surface = traced.blocks.Surface();
  return scattered >= Enough ? escaped * Enough < scattered
                             : LooksInward(surface) && HasNoBoundary(surface);
}

/// Light of one lamp, by where it first arrived.
struct LampLight
{
  ArrivedFlux flux;    ///< lm
  ArrivedFlux squares; ///< Of the flux of each photon, lm^2.

  ShareOfLight OnBacks(bool backSide) const
  {
    return { backSide ? 0.0 : this->flux.back, MetBy(this->flux),
      backSide ? 0.0 : this->squares.back, MetBy(this->squares) };
  }
  ShareOfLight Escaped() const
  {
    return { this->flux.escaped, this->flux.Emitted(), this->squares.escaped,
      this->squares.Emitted() };
  }
  /// On backs or escaped.
  ShareOfLight Lost(bool backSide) const
  {
    const ShareOfLight onBacks = this->OnBacks(backSide), escaped = this->Escaped();
    return { onBacks.part + escaped.part, escaped.whole, onBacks.squaredPart + escaped.squaredPart,
      escaped.squaredWhole };
  }
};

std::vector<LampLight> LightByLamp(const TracedScene& traced)
{
  const std::vector<ArrivedFlux> flux = traced.run.FluxArrivedByLamp();
  const std::vector<ArrivedFlux> squares = traced.run.SquaredFluxArrivedByLamp();
  std::vector<LampLight> lamps;
  for (std::size_t lamp = 0; lamp < flux.size(); ++lamp)
  {
    lamps.push_back({ flux[lamp], squares[lamp] });
  }
  return lamps;
}

Loss LossFromOutside(const LampLight& light, const SceneAround& around)
{
  const double met = MetBy(light.flux);
  if (met == 0.0 && light.flux.escaped > 0.0)
  {
    return Loss::OutsideMissed;
  }
  const bool closed = Share(light.flux.front, met) < LeastOfOutdoorLight &&
    light.OnBacks(around.backSide).SurelyExceeds(0.5);
  return closed ? Loss::OutsideClosed : Loss::None;
}

Loss LossFromInside(const LampLight& light, const SceneAround& around)
{
  const ShareOfLight onBacks = light.OnBacks(around.backSide), escaped = light.Escaped();
  if (escaped.SurelyExceeds(MostEscaped))
  {
    return Loss::Escaped;
  }
  if (onBacks.SurelyExceeds(MostOnBacks))
  {
    return Loss::OnBacks;
  }
  if (around.closed && light.Lost(around.backSide).SurelyExceeds(MostLostInClosed))
  {
    return onBacks.part > escaped.part ? Loss::OnBacks : Loss::Escaped;
  }
  return Loss::None;
}

/// Whether a lamp in the scene loses so much that it matters whether the surface is closed.
bool ClosednessMatters(const TracedScene& traced)
{
  const std::vector<LampLight> lights = LightByLamp(traced);
  for (std::size_t lamp = 0; lamp < lights.size(); ++lamp)
  {
    if (!ComesFromOutside(traced.lighting.luminaires[lamp]) &&
      LossFromInside(lights[lamp], { true, traced.backSide }) !=
        LossFromInside(lights[lamp], { false, traced.backSide }))
    {
      return true;
    }
  }
  return false;
}

} // namespace

double Share(double part, double whole)
{
  return whole > 0.0 ? part / whole : 0.0;
}

double MetBy(const ArrivedFlux& light)
{
  return light.front + light.back + light.absorbed + light.cutOff;
}

bool ComesFromOutside(const Luminaire& luminaire)
{
  const PhotonTransport::LampClass kind = ClassOf(luminaire.lamp);
  return kind == PhotonTransport::LampClass::Parallel || kind == PhotonTransport::LampClass::Sky;
}

std::vector<Loss> LossesByLamp(const TracedScene& traced)
{
  const std::vector<LampLight> lights = LightByLamp(traced);
  const SceneAround around{ ClosednessMatters(traced) && IsClosed(traced), traced.backSide };
  std::vector<Loss> losses;
  for (std::size_t lamp = 0; lamp < lights.size(); ++lamp)
  {
    losses.push_back(ComesFromOutside(traced.lighting.luminaires[lamp])
        ? LossFromOutside(lights[lamp], around)
        : LossFromInside(lights[lamp], around));
  }
  return losses;
}

Lost AllThatLost(Loss way, const std::vector<Loss>& losses, const TracedScene& traced)
{
  const std::vector<ArrivedFlux> arrivals = traced.run.FluxArrivedByLamp();
  const auto missing = [](const ArrivedFlux& lamp) { return lamp.back + lamp.escaped; };
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

PhotonTransport::ShareOfLight ScatteredLightOnBacks(const TracedScene& traced)
{
  PhotonTransport::ShareOfLight share = traced.run.ScatteredLightOnBacks();
  if (traced.backSide || (traced.run.EffectsInUse().present & PhotonTransport::Transmissions) != 0)
  {
    share.part = share.squaredPart = 0.0;
  }
  return share;
}

} // namespace Illumination
