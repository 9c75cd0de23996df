// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/LampKind.h"

#include <memory>

namespace PhotonTransport
{

class DirectionTable;

/// Photons of uniform luminance from a hemisphere or sphere of directions onto the bounding ball.
struct SkyEmitter : LuminaireColoured
{
  Frame up;
  bool wholeSphere;
  float radius; ///< Of the ball about the scene's origin that holds all facets.
  Ray Emit(const PhotonSample& sample, const Share&) const;
  double RadiancePerLumen(const glm::vec3& towards) const;
};

/// Photons from a sky whose luminance a table gives, onto the bounding ball.
struct TableSkyEmitter : LuminaireColoured
{
  glm::dvec3 azimuth0, azimuth90, up; ///< Orthonormal.
  float radius;                       ///< As SkyEmitter's.
  std::shared_ptr<const DirectionTable> table;
  Ray Emit(const PhotonSample& sample, const Share&) const;
  double RadiancePerLumen(const glm::vec3& towards) const;
};

/// Uniform luminance from every direction within 90 degrees of `up` (or from everywhere).
struct UniformSky
{
  glm::dvec3 up{ 0.0, 0.0, 1.0 };
  double luminance = 1000.0; ///< cd/m^2; an unshaded facet that faces up receives pi times this.
  bool wholeSphere = false;

  static constexpr const char* Name = "Uniform Sky";
  static constexpr LampClass Class = LampClass::Sky;
  template <typename Fields>
  void Describe(const Fields& fields)
  {
    fields("SkyUp", this->up);
    fields("SkyLuminance", this->luminance);
    fields("SkyIsWholeSphere", this->wholeSphere);
  }
  std::optional<glm::dvec3> Place() const { return std::nullopt; }
  void Move(const Similarity& motion) { this->up = motion.Direction(this->up); }
  LampNotes Notes(const std::string&) const { return {}; }
  Prepared<SkyEmitter> Prepare(const Scene& scene) const;
};

/// The sky by ISO 15469:2004 / CIE S 011:2003, above the horizon only.
struct CieSky
{
  glm::dvec3 up{ 0.0, 0.0, 1.0 };
  int type = 1;                       ///< 1 to 15; 16 is the traditional overcast sky.
  glm::dvec3 sun{ 0.0, -1.0, 1.0 };   ///< From the ground to the sun, above the horizon.
  double horizontalIlluminance = 1e4; ///< lx of an unshaded horizontal plane, without the sun.

  static constexpr const char* Name = "CIE Sky";
  static constexpr LampClass Class = LampClass::Sky;
  template <typename Fields>
  void Describe(const Fields& fields)
  {
    fields("SkyUp", this->up);
    fields("SkyType", this->type, 1, 16);
    fields("SunDirection", this->sun);
    fields("LuminaireIlluminance", this->horizontalIlluminance);
  }
  std::optional<glm::dvec3> Place() const { return std::nullopt; }
  void Move(const Similarity& motion);
  LampNotes Notes(const std::string&) const { return {}; }
  Prepared<TableSkyEmitter> Prepare(const Scene& scene) const;

  /// Luminances, cd/m^2, towards points of the sky. Throws InvalidInput as Prepare does.
  /// @param towards From the ground; of any length but 0. Those below the horizon get the luminance
  /// of the horizon.
  std::vector<double> Luminance(const std::vector<glm::dvec3>& towards) const;
};

} // namespace PhotonTransport
