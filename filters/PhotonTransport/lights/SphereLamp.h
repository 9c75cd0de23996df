// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/LampKind.h"

namespace PhotonTransport
{

/// Lambertian photons from the outside of a sphere.
struct SphereEmitter : LuminaireColoured
{
  glm::dvec3 centre;
  double radius;
  Ray Emit(const PhotonSample& sample, const Share&) const;
  static constexpr PlaceNumbers Numbers = PlaceNumbers::Two;
  Incidence Arriving(const glm::dvec3& point, float u, float v) const;
  std::optional<double> Unobstructed(const glm::dvec3& point, const glm::dvec3& normal) const;
};

/// A ball of uniform luminance that stops no photons itself.
struct SphereLamp
{
  glm::dvec3 centre{ 0.0 };
  double radius = 1.0;
  double flux = 1000.0;

  static constexpr const char* Name = "Sphere";
  static constexpr LampClass Class = LampClass::Area;
  template <typename Fields>
  void Describe(const Fields& fields)
  {
    fields("LuminairePosition", this->centre);
    fields("LuminaireSize", this->radius);
    fields("LuminousFlux", this->flux);
  }
  std::optional<glm::dvec3> Place() const { return this->centre; }
  void Move(const Similarity& motion);
  LampNotes Notes(const std::string&) const { return {}; }
  Prepared<SphereEmitter> Prepare(const Scene& scene) const;
};

} // namespace PhotonTransport
