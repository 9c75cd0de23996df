// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/gathering/LightPieces.h"

#include "PhotonTransport/geometry/Pi.h"

#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <type_traits>
#include <variant>

namespace PhotonTransport
{
namespace
{

template <class E>
constexpr bool IsSky = std::is_same_v<E, SkyEmitter> || std::is_same_v<E, TableSkyEmitter>;
template <class E>
constexpr bool IsSurface = std::is_same_v<E, FacetEmitter> || std::is_same_v<E, MeshEmitter>;

LightBounds Facing(const glm::dvec3& centre, const glm::dvec3& half, const glm::dvec3& axis)
{
  return { centre, half, axis, 1.0, 0.0, 0.0 };
}

LightBounds BoundsOf(const ConeEmitter& lamp)
{
  // A cone of up to a right angle shines in front of a plane, as what is flat does.
  return lamp.cosMax >= 0.0f ? Facing(lamp.position, glm::dvec3(0.0), glm::dvec3(lamp.axis.normal))
                             : LightBounds{ lamp.position };
}

LightBounds BoundsOf(const TableEmitter& lamp)
{
  return { lamp.position };
}

LightBounds BoundsOf(const PanelEmitter& lamp)
{
  const glm::dvec3 u = glm::abs(glm::dvec3(lamp.acrossU)), v = glm::abs(glm::dvec3(lamp.acrossV));
  const glm::dvec3 half = lamp.round ? glm::sqrt(u * u + v * v) : u + v;
  return Facing(lamp.centre, half, glm::dvec3(lamp.frame.normal));
}

LightBounds BoundsOf(const SphereEmitter& lamp)
{
  return { lamp.centre, glm::dvec3(lamp.radius) };
}

LightBounds BoundsOf(const LineEmitter& lamp)
{
  return { lamp.centre, glm::abs(glm::dvec3(lamp.halfAxis)) };
}

LightBounds BoundsOf(const ParallelEmitter&)
{
  return {};
}

LightBounds BoundsOf(const ShiningTriangle& triangle)
{
  const glm::dvec3 low = glm::min(glm::dvec3(0.0), glm::min(triangle.u, triangle.v));
  const glm::dvec3 high = glm::max(glm::dvec3(0.0), glm::max(triangle.u, triangle.v));
  return Facing(triangle.corner + 0.5 * (low + high), 0.5 * (high - low), triangle.normal);
}

/// The area by which an intensity is divided for the luminance, scene units squared, or 0. What
/// shines by Lambert's law has the luminance flux / (pi area) from all sides.
double AreaOf(const PanelEmitter& lamp)
{
  return (lamp.round ? Pi : 4.0) * glm::length(glm::cross(lamp.acrossU, lamp.acrossV));
}
double AreaOf(const SphereEmitter& lamp)
{
  return 4.0 * Pi * lamp.radius * lamp.radius;
}
double AreaOf(const ShiningTriangle& triangle)
{
  return 0.5 * glm::length(glm::cross(triangle.u, triangle.v));
}

double LambertianLuminance(double area)
{
  return area > 0.0 ? 1.0 / (Pi * area) : 0.0;
}

/// The colour of one triangle, or nullptr where it has that of the luminaire.
const Colour* ColourOf(const FacetEmitter& emitter, std::size_t chosen)
{
  return &emitter.scene->Exitance()[emitter.facets[chosen]];
}
const Colour* ColourOf(const MeshEmitter&, std::size_t)
{
  return nullptr;
}

std::size_t Triangles(const FacetEmitter& emitter)
{
  return emitter.facets.size();
}
std::size_t Triangles(const MeshEmitter& emitter)
{
  return emitter.triangles.size();
}

template <class Surface>
void AddTriangles(
  const Surface& surface, std::uint32_t lamp, const Emitter& emitter, std::vector<LightPiece>& to)
{
  for (std::size_t t = 0; t < Triangles(surface); ++t)
  {
    LightBounds bounds = BoundsOf(surface.Shape(t));
    bounds.flux = emitter.Flux(lamp) * (surface.table.End(t) - surface.table.Begin(t));
    if (bounds.flux > 0.0)
    {
      to.push_back({ lamp, static_cast<std::uint32_t>(t), Surface::Numbers,
        emitter.ChannelShares(lamp, ColourOf(surface, t)), bounds });
    }
  }
}

} // namespace

LightPieces::LightPieces(const Emitter& emitter)
  : Lamps(emitter)
{
  for (std::uint32_t lamp = 0; lamp < emitter.Lamps(); ++lamp)
  {
    std::visit(
      [&](const auto& from)
      {
        using E = std::decay_t<decltype(from)>;
        if constexpr (IsSky<E>)
        {
          this->SkyLamps.push_back(lamp);
        }
        else if constexpr (IsSurface<E>)
        {
          AddTriangles(from, lamp, emitter, this->NearOnes);
        }
        else if (emitter.Flux(lamp) > 0.0)
        {
          LightBounds bounds = BoundsOf(from);
          bounds.flux = emitter.Flux(lamp);
          constexpr bool IsFar = std::is_same_v<E, ParallelEmitter>;
          (IsFar ? this->FarOnes : this->NearOnes)
            .push_back({ lamp, 0, E::Numbers, emitter.ChannelShares(lamp), bounds });
        }
      },
      emitter.OfLamp(lamp));
  }
}

Incidence LightPieces::Arriving(
  const LightPiece& piece, const glm::dvec3& point, const glm::vec2& place) const
{
  return std::visit(
    [&](const auto& from) -> Incidence
    {
      using E = std::decay_t<decltype(from)>;
      if constexpr (IsSky<E>)
      {
        return {};
      }
      else if constexpr (IsSurface<E>)
      {
        return from.Arriving(point, place.x, place.y, piece.part);
      }
      else
      {
        return from.Arriving(point, place.x, place.y);
      }
    },
    this->Lamps.OfLamp(piece.lamp));
}

std::optional<double> LightPieces::Unobstructed(
  const LightPiece& piece, const glm::dvec3& point, const glm::dvec3& normal) const
{
  return std::visit(
    [&](const auto& from) -> std::optional<double>
    {
      using E = std::decay_t<decltype(from)>;
      if constexpr (IsSky<E>)
      {
        return std::nullopt;
      }
      else if constexpr (IsSurface<E>)
      {
        return from.Shape(piece.part).Unobstructed(point, normal);
      }
      else if constexpr (E::Numbers != PlaceNumbers::None)
      {
        return from.Unobstructed(point, normal);
      }
      else
      {
        return std::nullopt;
      }
    },
    this->Lamps.OfLamp(piece.lamp));
}

double LightPieces::LuminancePerLumen(const LightPiece& piece, const Incidence& light) const
{
  return std::visit(
    [&](const auto& from)
    {
      using E = std::decay_t<decltype(from)>;
      if constexpr (IsSurface<E>)
      {
        return LambertianLuminance(AreaOf(from.Shape(piece.part)));
      }
      else if constexpr (std::is_same_v<E, PanelEmitter> || std::is_same_v<E, SphereEmitter>)
      {
        return LambertianLuminance(AreaOf(from));
      }
      else if constexpr (std::is_same_v<E, TableEmitter>)
      {
        const double area = from.SeenArea(glm::dvec3(light.towards));
        const double distance = light.distance;
        return area > 0.0 ? light.perLumen * distance * distance / area : 0.0;
      }
      else
      {
        return 0.0;
      }
    },
    this->Lamps.OfLamp(piece.lamp));
}

double LightPieces::SkyPerLumen(std::uint32_t lamp, const glm::vec3& towards) const
{
  return std::visit(
    [&](const auto& from)
    {
      if constexpr (IsSky<std::decay_t<decltype(from)>>)
      {
        return from.RadiancePerLumen(towards);
      }
      else
      {
        return 0.0;
      }
    },
    this->Lamps.OfLamp(lamp));
}

} // namespace PhotonTransport
