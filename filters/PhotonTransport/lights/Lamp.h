// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/ConeLamps.h"
#include "PhotonTransport/lights/EmittingSurfaces.h"
#include "PhotonTransport/lights/LineLamp.h"
#include "PhotonTransport/lights/PanelLamps.h"
#include "PhotonTransport/lights/ParallelLight.h"
#include "PhotonTransport/lights/PhotometricLamp.h"
#include "PhotonTransport/lights/Skies.h"
#include "PhotonTransport/lights/SphereLamp.h"
#include "PhotonTransport/materials/Colour.h"

#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace PhotonTransport
{

/// A lamp as the user describes it. Positions and sizes are in the data's length unit, directions
/// point the way the light travels and may have any length but zero, fluxes are in lumens. See
/// LampKind.h for what a kind of lamp has.
using Lamp =
  std::variant<ParallelLight, PointLamp, LambertianPointLamp, SpotLamp, RectangleLamp, DiskLamp,
    SphereLamp, LineLamp, UniformSky, CieSky, PhotometricLamp, EmittingFacets, EmittingMesh>;

/// The ways in which photons of lamps start.
using LampEmitter = std::variant<ParallelEmitter, ConeEmitter, TableEmitter, PanelEmitter,
  SphereEmitter, LineEmitter, FacetEmitter, MeshEmitter, SkyEmitter, TableSkyEmitter>;

/// A lamp of each kind, in the order of Lamp.
template <std::size_t... Kind>
std::vector<Lamp> LampOfEachKind(std::index_sequence<Kind...>)
{
  return { Lamp(std::in_place_index<Kind>)... };
}
inline std::vector<Lamp> LampOfEachKind()
{
  return LampOfEachKind(std::make_index_sequence<std::variant_size_v<Lamp>>());
}

/// A lamp of a kind, by its number in Lamp, with the values that `fields` gives; see LampKind.h.
template <typename Fields>
Lamp DescribedLamp(std::size_t kind, const Fields& fields)
{
  Lamp lamp = LampOfEachKind().at(kind);
  std::visit([&](auto& l) { l.Describe(fields); }, lamp);
  return lamp;
}

inline LampClass ClassOf(const Lamp& lamp)
{
  return std::visit([](const auto& l) { return l.Class; }, lamp);
}

/// A lamp with its name and the colour of its light.
struct Luminaire
{
  Lamp lamp;
  std::string name;
  /// The colour of the light, in any scale: it does not change the flux. The scene's own facets do
  /// not use it, as their exitance is a colour.
  Colour colour{ 1.0f };
  /// Factor on the light, >= 0. A run that keeps lamps apart traces with 1 and applies it to what
  /// was traced.
  double dimming = 1.0;
};

/// All the light of a scene. At least one lamp.
struct Lighting
{
  std::vector<Luminaire> luminaires;

  Lighting() = default;
  /// A single lamp, of any kind, is a lighting too.
  template <typename AnyLamp,
    typename = std::enable_if_t<std::is_constructible_v<Lamp, const AnyLamp&>>>
  Lighting(const AnyLamp& lamp)
    : luminaires{ Luminaire{ lamp, {}, Colour(1.0f) } }
  {
  }
};

} // namespace PhotonTransport
