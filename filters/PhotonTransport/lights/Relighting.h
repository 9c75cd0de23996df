// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Lamp.h"

#include <optional>
#include <vector>

namespace PhotonTransport
{

/// How one lighting differs from another with the same lamps in the same places.
struct Relighting
{
  /// [luminaire] Its light, Luminaire::dimming included, over that of the other one; finite, >= 0.
  std::vector<double> factors;
  bool sameColours = true;

  /// Whether nothing differs.
  bool IsNone() const;
};

/// What makes `wanted` of `other`. Nothing if lamps differ in more than their light and its colour:
/// in number, order, kind, place, size or distribution; nor if a lamp without light would have to
/// get some. Names do not count. A luminaire that is a mesh may have all its exitances multiplied
/// by a number, up to their rounding to single precision.
std::optional<Relighting> RelightingOf(const Lighting& other, const Lighting& wanted);

} // namespace PhotonTransport
