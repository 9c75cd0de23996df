// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/LampKind.h"

namespace PhotonTransport
{

/// Lambertian photons from a tube too thin to have a radius.
struct LineEmitter : LuminaireColoured
{
  glm::dvec3 centre;
  glm::dvec3 halfAxis;
  Frame frame; ///< About the axis.
  Ray Emit(const PhotonSample& sample, const Share&) const;
  static constexpr PlaceNumbers Numbers = PlaceNumbers::One;
  Incidence Arriving(const glm::dvec3& point, float u, float) const;
  std::optional<double> Unobstructed(const glm::dvec3& point, const glm::dvec3& normal) const;
};

/// A thin diffuse tube: intensity falls as the sine of the angle to its axis.
struct LineLamp
{
  glm::dvec3 centre{ 0.0 };
  glm::dvec3 axis{ 1.0, 0.0, 0.0 };
  double length = 1.0;
  double flux = 1000.0;

  static constexpr const char* Name = "Line";
  static constexpr LampClass Class = LampClass::Area;
  template <typename Fields>
  void Describe(const Fields& fields)
  {
    fields("LuminairePosition", this->centre);
    fields("LuminaireDirection", this->axis);
    fields("LuminaireSize", this->length);
    fields("LuminousFlux", this->flux);
  }
  std::optional<glm::dvec3> Place() const { return this->centre; }
  void Move(const Similarity& motion);
  LampNotes Notes(const std::string&) const { return {}; }
  Prepared<LineEmitter> Prepare(const Scene& scene) const;
};

} // namespace PhotonTransport
