// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/materials/MaterialProperties.h"

#include "PhotonTransport/materials/ValueText.h"

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{
namespace
{

constexpr std::size_t Channels = 3;

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

// One property to and from its place in MaterialValues.

void Put(float* place, const Colour& share)
{
  std::copy(&share.x, &share.x + Channels, place);
}
void Put(float* place, float number)
{
  *place = number;
}
void Put(float* place, bool flag)
{
  *place = flag ? 1.0f : 0.0f;
}

void Take(const float* place, Colour& share)
{
  share = { place[0], place[1], place[2] };
}
void Take(const float* place, float& number)
{
  number = *place;
}
void Take(const float* place, bool& flag)
{
  flag = *place != 0.0f;
}

} // namespace

std::string RangeOf(const MaterialProperty& property)
{
  return IsFlag(property) ? ValueText(property.least, " or ", property.largest)
                          : ValueText("within ", property.aboveLeast ? "(" : "[", property.least,
                              ", ", property.largest, "]");
}

MaterialValues ValuesOf(const Material& material)
{
  MaterialValues values{};
  for (std::size_t p = 0; p < MaterialProperties.size(); ++p)
  {
    std::visit([&](auto member) { Put(&values[Channels * p], material.*member); },
      MaterialProperties[p].member);
  }
  return values;
}

Material MaterialOf(const MaterialValues& values)
{
  Material material;
  for (std::size_t p = 0; p < MaterialProperties.size(); ++p)
  {
    std::visit([&](auto member) { Take(&values[Channels * p], material.*member); },
      MaterialProperties[p].member);
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
        return ValueText(property.name, IsShare(property) ? NameOfChannel(c, grey) : "", " is ",
          value, "; it must be ", RangeOf(property));
      }
      sums[c] += IsShare(property) ? double{ value } : 0.0;
    }
  }
  constexpr double Rounding = 1e-6; // of five numbers up to 1 in single precision: 5 * 6e-8
  const auto sum = std::max_element(sums.begin(), sums.end());
  return *sum <= 1.0 + Rounding
    ? ""
    : ValueText("the reflectances and transmittances",
        NameOfChannel(static_cast<std::size_t>(sum - sums.begin()), grey), " sum to ", *sum,
        "; they must not exceed 1 together");
}

std::string ProblemOf(const Material& material)
{
  return ProblemOf(ValuesOf(material));
}

} // namespace PhotonTransport
