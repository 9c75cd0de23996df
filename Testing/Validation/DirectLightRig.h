// SPDX-License-Identifier: BSD-3-Clause
// Direct light by shadow rays at any point, for tests.
#pragma once

#include "References.h"

#include "PhotonTransport/gathering/DirectLight.h"

#include "Shapes.h"

#include <glm/vec3.hpp>

#include <functional>
#include <vector>

/// Direct light of one lighting on a surface.
class DirectLightRig
{
public:
  DirectLightRig(const PhotonTransport::Surface& surface, const PhotonTransport::Lighting& lighting,
    bool colour = false,
    PhotonTransport::ScatteringSet switchedOn = PhotonTransport::AllScatterings);

  /// A receiver in the data's coordinates that has one place where rays start.
  PhotonTransport::Receiver ReceiverAt(const glm::dvec3& point, const glm::dvec3& normal) const;

  PhotonTransport::DirectResult At(const glm::dvec3& point, const glm::dvec3& normal,
    unsigned samples, std::uint32_t seed = 1, std::uint64_t index = 7) const;

  const PhotonTransport::Scene scene;
  const PhotonTransport::Emitter emitter;
  const PhotonTransport::FacetRoulettes materials;
  const PhotonTransport::DirectLight light;
};

/// The sum over all lamps and channels, lx.
double Total(const PhotonTransport::DirectResult& result);

/// Means over independent estimates.
struct MeanOfSeeds
{
  double mean = 0.0;
  double standardError = 0.0; ///< Of the mean, from the spread.
  double toldVariance = 0.0;  ///< Mean of what the estimates tell of themselves.
  double spread = 0.0;        ///< Variance of the estimates.
  double largest = 0.0;
};
MeanOfSeeds Repeat(const std::function<PhotonTransport::DirectResult(std::uint32_t seed)>& estimate,
  std::uint32_t seeds);

/// The same of single samples, by stratified numbers. Strata only lower the error of the mean.
MeanOfSeeds RepeatSamples(const DirectLightRig& rig, const glm::dvec3& point,
  const glm::dvec3& normal, std::uint32_t samples);

/// The part of a polygon on the side of a plane through `point` to which `normal` points.
std::vector<glm::dvec3> Clipped(
  const std::vector<glm::dvec3>& polygon, const glm::dvec3& point, const glm::dvec3& normal);

/// Illuminance of a receiver by what it sees of a Lambertian polygon of 1 lm/m^2, by Lambert's
/// formula. The receiver is in front of the polygon.
double UnitExitance(
  const glm::dvec3& point, const glm::dvec3& normal, const std::vector<glm::dvec3>& polygon);
