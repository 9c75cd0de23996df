// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/materials/Material.h"

#include <array>
#include <cstddef>
#include <string>
#include <variant>

namespace PhotonTransport
{

/// One property of a material. Cell arrays, the filters that write and read them, checks and
/// messages all go by the rows of MaterialProperties.
struct MaterialProperty
{
  const char* name; ///< Of the cell array and of the filters' properties.
  std::variant<Colour Material::*, float Material::*, bool Material::*> member;
  float least;
  float largest;
  bool aboveLeast; ///< Whether the least value itself is refused.
};

constexpr std::array<MaterialProperty, 8> MaterialProperties{ {
  { "DiffuseReflectance", &Material::diffuseReflectance, 0.0f, 1.0f, false },
  { "SpecularReflectance", &Material::specularReflectance, 0.0f, 1.0f, false },
  { "GlossyReflectance", &Material::glossyReflectance, 0.0f, 1.0f, false },
  { "DiffuseTransmittance", &Material::diffuseTransmittance, 0.0f, 1.0f, false },
  { "ClearTransmittance", &Material::clearTransmittance, 0.0f, 1.0f, false },
  { "Roughness", &Material::roughness, 0.0f, 1.0f, true },
  { "RefractiveIndex", &Material::refractiveIndex, 1.0f, 4.0f, false },
  { "SolidBody", &Material::solid, 0.0f, 1.0f, false },
} };

/// Colours are shares of the light: in each channel all of them sum to at most 1.
constexpr bool IsShare(const MaterialProperty& property)
{
  return std::holds_alternative<Colour Material::*>(property.member);
}

/// 3 for a colour, else 1.
constexpr int ComponentsOf(const MaterialProperty& property)
{
  return IsShare(property) ? 3 : 1;
}

/// "within [0, 1]", "0 or 1".
std::string RangeOf(const MaterialProperty& property);

/// All values of a material, three a property; properties of one component use the first and leave
/// the others at 0.
using MaterialValues = std::array<float, 3 * MaterialProperties.size()>;

MaterialValues ValuesOf(const Material& material);
Material MaterialOf(const MaterialValues& values);

/// What is wrong with a material, in words; empty if nothing is.
std::string ProblemOf(const MaterialValues& values);
std::string ProblemOf(const Material& material);

} // namespace PhotonTransport
