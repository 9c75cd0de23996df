// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/registration/Registration.h"

#include <string>
#include <vector>

namespace PhotonTransport
{

struct TraceSettings;

/// Which effects a scene calls for. The walk is compiled for each combination; what is absent costs
/// nothing.
struct Effects
{
  Registration registration = Registration::VertexNormalised;
  bool interreflection = true;
  bool backSide = false;
  /// The answer in words: "interreflection: on, 10 of 12 triangles reflect".
  std::vector<std::string> reasons;
};

Effects AnalyseEffects(const Scene& scene, const TraceSettings& settings);

} // namespace PhotonTransport
