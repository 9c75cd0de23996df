// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/geometry/Frame.h"
#include "PhotonTransport/lights/FluxTable.h"
#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/lights/PhotonStart.h"
#include "PhotonTransport/openings/Opening.h"
#include "PhotonTransport/sampling/PhotonSample.h"
#include "PhotonTransport/scene/Ray.h"

#include <glm/vec3.hpp>

#include <functional>
#include <memory>
#include <vector>

namespace PhotonTransport
{

/// Which part of a lamp's light a photon belongs to. A path of light from afar belongs to the first
/// opening that it crosses inwards.
enum class LightPart
{
  Whole,    ///< All light of the lamp but for what the other parts have.
  Straight, ///< Light from afar that comes to an opening straight, or through panes.
  Scattered ///< Light of the sky that something outdoors has scattered before it gets to one.
};
constexpr std::size_t LightParts = 3;

/// Light as it arrives at an opening, against its direction: the photon is traced back from there,
/// and starts if this leads to where the light comes from.
///
/// Photons are drawn by a bound of the radiance and kept with the probability of radiance over
/// bound, so that all that are kept have the same flux.
class OpeningEmitter
{
public:
  virtual ~OpeningEmitter() = default;

  /// From a point of an opening outwards, where light comes from; without a direction for a photon
  /// that is not kept.
  virtual Ray Emit(const PhotonSample& sample, const Share& share) const = 0;

  /// The probability that a photon is kept which, traced back, leaves the scene in a direction.
  /// @param towards Unit, where the light comes from.
  virtual float KeptFrom(const glm::vec3& towards) const = 0;

  /// Of all photons, kept or not, for 1 lm of the lamp, lm; 0 if no light can come this way.
  double FluxPerLumen() const { return this->Flux; }

protected:
  double Flux = 0.0;
};

/// Radiance of a sky for 1 lm; see RadiancePerLumen in LampKind.h.
using SkyRadiance = std::function<double(const glm::vec3& towards)>;

/// Directions out of an opening whose density follows cosine times a bound of the sky's radiance,
/// by cells of the square that CosineHemisphere warps.
class SkyCells
{
public:
  SkyCells(const glm::vec3& outwards, const SkyRadiance& radiance);

  /// The integral of bound and cosine.
  double Integral() const { return this->Whole; }

  struct Sample
  {
    glm::vec3 direction;
    double bound;
  };
  /// Integral() must not be 0. @param u, v In [0, 1).
  Sample At(double u, double v) const;

private:
  Frame Outwards;
  std::vector<double> Bounds; ///< [row][column] Of the radiance.
  FluxTable Rows;
  std::vector<FluxTable> Columns; ///< [row] Empty in a dark row.
  double Whole = 0.0;
};

/// LightPart::Straight of a sky.
class SkyThroughOpenings : public OpeningEmitter
{
public:
  /// @param openings Must outlive it.
  SkyThroughOpenings(const Openings& openings, SkyRadiance radiance);
  Ray Emit(const PhotonSample& sample, const Share& share) const override;
  float KeptFrom(const glm::vec3&) const override { return 1.0f; }

private:
  const std::vector<Opening>& All;
  SkyRadiance Radiance;
  std::vector<std::shared_ptr<const SkyCells>> Cells; ///< [opening] Alike where they face alike.
  FluxTable Choice;
};

/// LightPart::Scattered of a sky. Outdoors the photon is traced back from one surface to another
/// until it escapes, which it does by the same laws of scattering, since they are reciprocal.
class ScatteredThroughOpenings : public OpeningEmitter
{
public:
  ScatteredThroughOpenings(const Openings& openings, SkyRadiance radiance);
  Ray Emit(const PhotonSample& sample, const Share& share) const override;
  float KeptFrom(const glm::vec3& towards) const override;

private:
  const std::vector<Opening>& All;
  SkyRadiance Radiance;
  double Largest; ///< Radiance.
  FluxTable Choice;
};

/// LightPart::Straight of parallel light.
class ParallelThroughOpenings : public OpeningEmitter
{
public:
  ParallelThroughOpenings(const Openings& openings, const ParallelEmitter& light);
  Ray Emit(const PhotonSample& sample, const Share& share) const override;
  float KeptFrom(const glm::vec3&) const override { return 1.0f; }

private:
  const std::vector<Opening>& All;
  glm::vec3 Towards;
  FluxTable Choice;
};

/// What emits a part of a lamp's light; null if it can have none.
std::shared_ptr<const OpeningEmitter> EmitterThroughOpenings(
  const Openings& openings, const LampEmitter& lamp, LightPart part);

} // namespace PhotonTransport
