// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/geometry/Frame.h"
#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/sampling/PhotonSample.h"
#include "PhotonTransport/scene/Scene.h"

#include <variant>
#include <vector>

namespace PhotonTransport
{

/// Photons in one direction, from a disk that just covers the scene.
struct ParallelEmitter
{
  glm::vec3 centre;
  glm::vec3 acrossU, acrossV; ///< The disk's half-axes.
  glm::vec3 direction;
  Ray Emit(const PhotonSample& sample) const;
};

/// Photons from a point, intensity I_0 cos^n within a cone.
struct ConeEmitter
{
  glm::dvec3 position;
  Frame axis;
  float exponent;
  float cosMax;
  Ray Emit(const PhotonSample& sample) const;
};

/// Lambertian photons from a flat lamp.
struct PanelEmitter
{
  glm::dvec3 centre;
  Frame frame;
  glm::dvec3 acrossU, acrossV; ///< Half-axes.
  bool round;
  Ray Emit(const PhotonSample& sample) const;
};

/// Lambertian photons from the scene's own facets, each chosen by its share of the flux.
struct FacetEmitter
{
  const Scene* scene;
  std::vector<std::uint32_t> facets;  ///< Those that shine.
  std::vector<double> cumulativeFlux; ///< Of them, normalised to end at 1.
  /// For each of as many equal parts of [0, 1): the first facet that it may choose. A search that
  /// starts there takes one step on average (Chen and Asau 1974), and keeps the numbers' order.
  std::vector<std::uint32_t> firstOfPart;
  Ray Emit(const PhotonSample& sample) const;
};

/// Photons of uniform luminance from a hemisphere or sphere of directions onto the bounding ball.
struct SkyEmitter
{
  Frame up;
  bool wholeSphere;
  float radius; ///< Of the ball about the scene's origin that holds all facets.
  Ray Emit(const PhotonSample& sample) const;
};

/// A lamp made ready: emits photons in the scene's coordinates.
class Emitter
{
public:
  /// Throws InvalidInput for a lamp that makes no sense (names the value).
  /// @param scene Must outlive the emitter.
  Emitter(const Lamp& lamp, const Scene& scene);

  /// Total luminous flux of the photons, lm. For light from outside: what enters the disk or ball
  /// from which photons start.
  double Flux() const { return this->TotalFlux; }

  Ray Emit(const PhotonSample& sample) const
  {
    return std::visit([&](const auto& source) { return source.Emit(sample); }, this->Source);
  }

private:
  std::variant<ParallelEmitter, ConeEmitter, PanelEmitter, FacetEmitter, SkyEmitter> Source;
  double TotalFlux = 0.0;
};

} // namespace PhotonTransport
