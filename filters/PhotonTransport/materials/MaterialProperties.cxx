// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/materials/MaterialProperties.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace PhotonTransport
{
namespace
{

constexpr std::size_t Channels = 3;

template <typename... Parts>
std::string Text(const Parts&... parts)
{
  std::ostringstream text;
  text.precision(std::numeric_limits<float>::max_digits10);
  (text << ... << parts);
  return text.str();
}

bool IsFlag(const MaterialProperty& property)
{
  return std::holds_alternative<bool Material::*>(property.member);
}

bool IsWithin(const MaterialProperty& property, float value)
{
  if (IsFlag(property))
  {
    return value == 0.0f || value == 1.0f;
  }
  const bool enough = property.aboveLeast ? value > property.least : value >= property.least;
  return enough && value <= property.largest; // false for NaN
}

/// " (red)" and so on; nothing where all channels are alike.
const char* NameOfChannel(std::size_t channel, bool grey)
{
  constexpr std::array<const char*, Channels> names{ " (red)", " (green)", " (blue)" };
  return grey ? "" : names[channel];
}

/// Equal, or both no number.
bool AreAlike(float a, float b)
{
  return a == b || (std::isnan(a) && std::isnan(b));
}

bool AreGrey(const MaterialValues& values)
{
  bool grey = true;
  for (std::size_t p = 0; p < MaterialProperties.size(); ++p)
  {
    const float* value = &values[Channels * p];
    grey = grey &&
      (!IsShare(MaterialProperties[p]) ||
        (AreAlike(value[0], value[1]) && AreAlike(value[0], value[2])));
  }
  return grey;
}

} // namespace

std::string RangeOf(const MaterialProperty& property)
{
  return IsFlag(property)
    ? Text(property.least, " or ", property.largest)
    : Text("within ", property.aboveLeast ? "(" : "[", property.least, ", ", property.largest, "]");
}

MaterialValues ValuesOf(const Material& material)
{
  MaterialValues values{};
  for (std::size_t p = 0; p < MaterialProperties.size(); ++p)
  {
    float* value = &values[Channels * p];
    if (const auto* colour = std::get_if<Colour Material::*>(&MaterialProperties[p].member))
    {
      const Colour& share = material.**colour;
      std::copy(&share.x, &share.x + Channels, value);
    }
    else if (const auto* number = std::get_if<float Material::*>(&MaterialProperties[p].member))
    {
      *value = material.**number;
    }
    else
    {
      *value = material.*std::get<bool Material::*>(MaterialProperties[p].member) ? 1.0f : 0.0f;
    }
  }
  return values;
}

Material MaterialOf(const MaterialValues& values)
{
  Material material;
  for (std::size_t p = 0; p < MaterialProperties.size(); ++p)
  {
    const float* value = &values[Channels * p];
    if (const auto* colour = std::get_if<Colour Material::*>(&MaterialProperties[p].member))
    {
      material.** colour = { value[0], value[1], value[2] };
    }
    else if (const auto* number = std::get_if<float Material::*>(&MaterialProperties[p].member))
    {
      material.** number = *value;
    }
    else
    {
      material.*std::get<bool Material::*>(MaterialProperties[p].member) = *value != 0.0f;
    }
  }
  return material;
}

std::string ProblemOf(const MaterialValues& values)
{
  const bool grey = AreGrey(values);
  std::array<double, Channels> sums{};
  for (std::size_t p = 0; p < MaterialProperties.size(); ++p)
  {
    const MaterialProperty& property = MaterialProperties[p];
    for (std::size_t c = 0; c < static_cast<std::size_t>(ComponentsOf(property)); ++c)
    {
      const float value = values[Channels * p + c];
      if (!IsWithin(property, value))
      {
        return Text(property.name, IsShare(property) ? NameOfChannel(c, grey) : "", " is ", value,
          "; it must be ", RangeOf(property));
      }
      sums[c] += IsShare(property) ? double{ value } : 0.0;
    }
  }
  constexpr double Rounding = 1e-6; // of five numbers up to 1 in single precision: 5 * 6e-8
  const auto sum = std::max_element(sums.begin(), sums.end());
  return *sum <= 1.0 + Rounding
    ? ""
    : Text("the reflectances and transmittances",
        NameOfChannel(static_cast<std::size_t>(sum - sums.begin()), grey), " sum to ", *sum,
        "; they must not exceed 1 together");
}

std::string ProblemOf(const Material& material)
{
  return ProblemOf(ValuesOf(material));
}

} // namespace PhotonTransport
