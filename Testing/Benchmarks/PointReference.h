// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "ReferenceDirections.h"
#include "ReferenceLamps.h"
#include "ReferencePoint.h"

#include "PhotonTransport/scene/Scene.h"

#include <cstdint>
#include <vector>

/// An illuminance with its standard error, lx.
struct PointEstimate
{
  double illuminance = 0.0;
  double standardError = 0.0;
};

/// Backward path tracing of the light at single points, for matt surfaces: cosine-distributed rays,
/// next-event estimation to lamps at every vertex of a path, combined with rays that meet emitting
/// facets by the balance heuristic (Veach and Guibas, "Optimally Combining Sampling Techniques",
/// 1995, equation 14). It shares the product's rays and materials, and nothing else.
class PointReference
{
public:
  /// @param scene Must outlive this. Its materials are matt and grey.
  PointReference(const PhotonTransport::Scene& scene, const PhotonTransport::Lighting& lighting,
    const std::vector<Guide>& guides);

  /// @param waves Independent estimates of WavePaths paths each, whose spread is the standard
  /// error;
  /// >= 2. @param seed Of the numbers.
  PointEstimate At(const ReferencePoint& point, unsigned waves, std::uint64_t seed) const;

  static constexpr std::size_t WavePaths = 1024;

private:
  class Wave;

  glm::dvec3 PlaceOf(const PhotonTransport::Hit& hit) const;

  const PhotonTransport::Scene& Lit;
  ReferenceLamps Lamps;
  ReferenceDirections Directions;
};
