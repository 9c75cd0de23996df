// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/LampKind.h"

namespace PhotonTransport
{

/// Photons in one direction, from a disk that just covers the scene.
struct ParallelEmitter : LuminaireColoured
{
  glm::vec3 centre;
  glm::vec3 acrossU, acrossV; ///< The disk's half-axes.
  glm::vec3 direction;
  double area; ///< Of the disk.
  Ray Emit(const PhotonSample& sample, const Share&) const;
  static constexpr PlaceNumbers Numbers = PlaceNumbers::None;
  Incidence Arriving(const glm::dvec3&, float, float) const
  {
    return Incidence::FromAfar(-this->direction, 1.0 / this->area);
  }
};

/// Light from infinitely far away, over the whole scene.
struct ParallelLight
{
  glm::dvec3 direction{ 0.0, 0.0, -1.0 };
  double illuminance = 1000.0; ///< lx on a plane perpendicular to the light.

  static constexpr const char* Name = "Parallel";
  static constexpr LampClass Class = LampClass::Parallel;
  template <typename Fields>
  void Describe(const Fields& fields)
  {
    fields("LuminaireDirection", this->direction);
    fields("LuminaireIlluminance", this->illuminance);
  }
  std::optional<glm::dvec3> Place() const { return std::nullopt; }
  void Move(const Similarity& motion) { this->direction = motion.Direction(this->direction); }
  LampNotes Notes(const std::string&) const { return {}; }
  Prepared<ParallelEmitter> Prepare(const Scene& scene) const;
};

} // namespace PhotonTransport
