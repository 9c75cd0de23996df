// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace PhotonTransport
{

/// A value for each of three channels: linear, with the primaries and the white of ITU-R BT.709
/// (sRGB). Grey has three equal values.
using Colour = glm::vec3;

/// What a channel contributes to luminance; ITU-R BT.709, item 3.2. They sum to 1.
constexpr Colour LuminousWeights{ 0.2126f, 0.7152f, 0.0722f };

inline bool IsGrey(const Colour& colour)
{
  return colour.x == colour.y && colour.y == colour.z;
}

/// The value that stands for a colour where there is one channel: its share of white light.
inline float Luminous(const Colour& colour)
{
  return IsGrey(colour) ? colour.x : glm::dot(LuminousWeights, colour);
}

} // namespace PhotonTransport
