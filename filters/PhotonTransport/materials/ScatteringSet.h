// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace PhotonTransport
{

/// The ways in which a photon goes on from a facet.
enum class Scattering : unsigned
{
  DiffuseReflection,
  SpecularReflection,
  GlossyReflection,
  DiffuseTransmission,
  ClearTransmission, ///< Through a thin pane, or mirrored by it.
  Refraction         ///< At the surface of a solid body, reflection there included.
};
constexpr unsigned Scatterings = 6;

/// A set of them.
using ScatteringSet = unsigned;
constexpr ScatteringSet SetOf(Scattering scattering)
{
  return 1u << static_cast<unsigned>(scattering);
}
constexpr ScatteringSet DiffuseScatterings =
  SetOf(Scattering::DiffuseReflection) | SetOf(Scattering::DiffuseTransmission);
constexpr bool IsDiffuse(Scattering scattering)
{
  return (SetOf(scattering) & DiffuseScatterings) != 0;
}
constexpr ScatteringSet AllScatterings = (1u << Scatterings) - 1u;
constexpr ScatteringSet Reflections =
  SetOf(Scattering::SpecularReflection) | SetOf(Scattering::GlossyReflection);
constexpr ScatteringSet Transmissions = SetOf(Scattering::DiffuseTransmission) |
  SetOf(Scattering::ClearTransmission) | SetOf(Scattering::Refraction);
static_assert(
  (SetOf(Scattering::DiffuseReflection) | Reflections | Transmissions) == AllScatterings,
  "a walk is compiled for each way of scattering, and Scatterings counts them all");

} // namespace PhotonTransport
