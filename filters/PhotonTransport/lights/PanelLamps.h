// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/LampKind.h"

#include <glm/vec2.hpp>

namespace PhotonTransport
{

/// Lambertian photons from a flat lamp.
struct PanelEmitter : LuminaireColoured
{
  glm::dvec3 centre;
  Frame frame;
  glm::dvec3 acrossU, acrossV; ///< Half-axes.
  bool round;
  Ray Emit(const PhotonSample& sample, const Share&) const;
  static constexpr PlaceNumbers Numbers = PlaceNumbers::Two;
  /// From near by places have even density by solid angle (a rectangle) or nearly so (a disk), so
  /// that the illuminance stays bounded; from far they have even density by area.
  Incidence Arriving(const glm::dvec3& point, float u, float v) const;

  std::optional<double> Unobstructed(const glm::dvec3& point, const glm::dvec3& normal) const;

private:
  bool IsNear(const glm::dvec3& way, double height) const;
  Incidence FromRectangle(
    const glm::dvec3& point, const glm::dvec3& normal, double height, float u, float v) const;
  Incidence FromDisk(
    const glm::dvec3& point, const glm::dvec3& normal, double height, float u, float v) const;
  Incidence ByArea(const glm::dvec3& point, const glm::dvec3& normal, float u, float v) const;
};

/// A Lambertian panel that shines to one side and stops no photons itself.
struct RectangleLamp
{
  glm::dvec3 centre{ 0.0 };
  glm::dvec3 direction{ 0.0, 0.0, -1.0 };
  double width = 1.0;
  double height = 1.0;
  double flux = 1000.0;
  /// The direction of the width, of any length, not along `direction`. Zero: along z x direction,
  /// or along x for vertical light. The height runs along direction x width.
  glm::dvec3 across{ 0.0 };

  /// Unit vectors along the panel's light, width and height. Throws InvalidInput for a direction
  /// that is none, or a width that runs along it.
  struct PanelAxes
  {
    glm::dvec3 aim, width, height;
  };
  PanelAxes Axes() const;

  static constexpr const char* Name = "Rectangle";
  static constexpr LampClass Class = LampClass::Area;
  template <typename Fields>
  void Describe(const Fields& fields)
  {
    fields("LuminairePosition", this->centre);
    fields("LuminaireDirection", this->direction);
    glm::dvec2 size(this->width, this->height);
    fields("LuminaireSize", size);
    this->width = size.x;
    this->height = size.y;
    fields("LuminousFlux", this->flux);
  }
  std::optional<glm::dvec3> Place() const { return this->centre; }
  void Move(const Similarity& motion);
  LampNotes Notes(const std::string&) const { return {}; }
  Prepared<PanelEmitter> Prepare(const Scene& scene) const;
};

/// A round panel, otherwise as RectangleLamp.
struct DiskLamp
{
  glm::dvec3 centre{ 0.0 };
  glm::dvec3 direction{ 0.0, 0.0, -1.0 };
  double radius = 1.0;
  double flux = 1000.0;

  static constexpr const char* Name = "Disk";
  static constexpr LampClass Class = LampClass::Area;
  template <typename Fields>
  void Describe(const Fields& fields)
  {
    fields("LuminairePosition", this->centre);
    fields("LuminaireDirection", this->direction);
    fields("LuminaireSize", this->radius);
    fields("LuminousFlux", this->flux);
  }
  std::optional<glm::dvec3> Place() const { return this->centre; }
  void Move(const Similarity& motion);
  LampNotes Notes(const std::string&) const { return {}; }
  Prepared<PanelEmitter> Prepare(const Scene& scene) const;
};

} // namespace PhotonTransport
