// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/LampKind.h"

namespace PhotonTransport
{

/// Photons from a point, intensity I_0 cos^n within a cone.
struct ConeEmitter : LuminaireColoured
{
  glm::dvec3 position;
  Frame axis;
  float exponent;
  float cosMax;
  Ray Emit(const PhotonSample& sample, const Share&) const;
  static constexpr PlaceNumbers Numbers = PlaceNumbers::None;
  Incidence Arriving(const glm::dvec3& point, float, float) const;
};

/// The same intensity in all directions: I = flux / (4 pi).
struct PointLamp
{
  glm::dvec3 position{ 0.0 };
  double flux = 1000.0;

  static constexpr const char* Name = "Point";
  static constexpr LampClass Class = LampClass::Point;
  template <typename Fields>
  void Describe(const Fields& fields)
  {
    fields("LuminairePosition", this->position);
    fields("LuminousFlux", this->flux);
  }
  std::optional<glm::dvec3> Place() const { return this->position; }
  void Move(const Similarity& motion) { this->position = motion.Point(this->position); }
  LampNotes Notes(const std::string&) const { return {}; }
  Prepared<ConeEmitter> Prepare(const Scene& scene) const;
};

/// A small flat lamp: I = flux / pi * cos(theta) about the direction.
struct LambertianPointLamp
{
  glm::dvec3 position{ 0.0 };
  glm::dvec3 direction{ 0.0, 0.0, -1.0 };
  double flux = 1000.0;

  static constexpr const char* Name = "Lambertian Point";
  static constexpr LampClass Class = LampClass::Point;
  template <typename Fields>
  void Describe(const Fields& fields)
  {
    fields("LuminairePosition", this->position);
    fields("LuminaireDirection", this->direction);
    fields("LuminousFlux", this->flux);
  }
  std::optional<glm::dvec3> Place() const { return this->position; }
  void Move(const Similarity& motion);
  LampNotes Notes(const std::string&) const { return {}; }
  Prepared<ConeEmitter> Prepare(const Scene& scene) const;
};

/// I = I_0 cos^n(theta) within the half-angle, nothing outside.
struct SpotLamp
{
  glm::dvec3 position{ 0.0 };
  glm::dvec3 direction{ 0.0, 0.0, -1.0 };
  double halfAngle = 0.5; ///< Axis to edge, radians, (0, pi]; at most pi/2 if the exponent is > 0.
  double exponent = 0.0;  ///< n >= 0; 0 is even light.
  double flux = 1000.0;

  static constexpr const char* Name = "Spot";
  static constexpr LampClass Class = LampClass::Point;
  template <typename Fields>
  void Describe(const Fields& fields)
  {
    fields("LuminairePosition", this->position);
    fields("LuminaireDirection", this->direction);
    DescribeAngle(fields, "SpotHalfAngle", this->halfAngle);
    fields("SpotExponent", this->exponent);
    fields("LuminousFlux", this->flux);
  }
  std::optional<glm::dvec3> Place() const { return this->position; }
  void Move(const Similarity& motion);
  LampNotes Notes(const std::string&) const { return {}; }
  Prepared<ConeEmitter> Prepare(const Scene& scene) const;
};

} // namespace PhotonTransport
