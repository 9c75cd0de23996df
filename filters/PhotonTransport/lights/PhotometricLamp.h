// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/LampKind.h"
#include "PhotonTransport/photometry/PhotometricSolid.h"

#include <functional>
#include <memory>

namespace PhotonTransport
{

class DirectionTable;

/// Photons from a point by a table of intensities.
struct TableEmitter : LuminaireColoured
{
  glm::dvec3 position;
  glm::dvec3 azimuth0, azimuth90, pole; ///< Orthonormal.
  std::shared_ptr<const DirectionTable> table;
  glm::dvec3 aim{ 0.0 }; ///< Unit.
  double openArea = 0.0; ///< Of the luminous opening across the aim, scene units squared.
  double sideArea = 0.0; ///< Of its sides as seen across the aim: the mean over all azimuths.
  Ray Emit(const PhotonSample& sample, const Share&) const;
  static constexpr PlaceNumbers Numbers = PlaceNumbers::None;
  Incidence Arriving(const glm::dvec3& point, float, float) const;
  /// The area of the luminous opening as it is seen, scene units squared; 0 if the file gives none.
  /// @param direction Unit, to or from the lamp.
  double SeenArea(const glm::dvec3& direction) const;
};

/// The names of PhotometricSolid::Type in fields.
std::string SolidTypeName(PhotometricSolid::Type type);

/// Calls `refuse` with the name of a field and what is wrong with it, where that breaks a promise
/// of PhotometricSolid.
void CheckFields(const PhotometricSolid& solid,
  const std::function<void(const char* name, const std::string& message)>& refuse);

/// Describes a solid to fields that hold its values one by one.
template <typename Fields>
void DescribeFields(const Fields& fields, PhotometricSolid& solid)
{
  std::string type = SolidTypeName(solid.type);
  fields("PhotometricType", type);
  solid.type = PhotometricSolid::Type::C;
  for (const auto known : { PhotometricSolid::Type::B, PhotometricSolid::Type::A })
  {
    solid.type = type == SolidTypeName(known) ? known : solid.type;
  }
  if (type != SolidTypeName(solid.type))
  {
    fields.Refuse("PhotometricType", "is '" + type + "'; C, B and A are known");
  }
  fields("PhotometricPolar", solid.polar);
  fields("PhotometricAzimuth", solid.azimuth);
  fields("PhotometricCandela", solid.candela);
  CheckFields(solid, Fields::Refuse);
  fields("PhotometricRatedFlux", solid.ratedFlux);
  fields("PhotometricInputPower", solid.inputPower);
  glm::dvec3 opening{ solid.width, solid.length, solid.height };
  fields("PhotometricOpening", opening);
  solid.width = opening.x;
  solid.length = opening.y;
  solid.height = opening.z;
  fields("PhotometricDescription", solid.description);
  fields("PhotometricNotes", solid.notes);
}

/// A point-like lamp with the intensities of a photometric file.
struct PhotometricLamp
{
  glm::dvec3 position{ 0.0 };
  /// Where the lamp aims: the nadir of type C, the centre of types A and B. For a lamp that aims
  /// along -z with rotation 0, azimuth 0 of type C is +x and azimuth 90 degrees is +y. Another aim
  /// turns the lamp there by the shortest way (about x for +z).
  glm::dvec3 direction{ 0.0, 0.0, -1.0 };
  /// Radians by which the lamp is turned about its aim, from +x towards +y, while it aims along -z.
  double rotation = 0.0;
  PhotometricSolid solid;
  double scale = 1.0; ///< Factor on the solid's intensities, >= 0.

  /// The aim, and what were +x and +y of the lamp before it was turned; orthonormal. Throws
  /// InvalidInput for a direction that is none.
  struct LampAxes
  {
    glm::dvec3 aim, x, y;
  };
  LampAxes Axes() const;

  static constexpr const char* Name = "Photometric";
  static constexpr LampClass Class = LampClass::Photometric;
  template <typename Fields>
  void Describe(const Fields& fields)
  {
    fields("LuminairePosition", this->position);
    fields("LuminaireDirection", this->direction);
    DescribeAngle(fields, "LuminaireRotation", this->rotation);
    fields("PhotometricScale", this->scale);
    fields("PhotometricSolid", this->solid);
  }
  std::optional<glm::dvec3> Place() const { return this->position; }
  /// Throws InvalidInput if the motion mirrors intensities that are symmetric neither left and
  /// right nor fore and aft.
  void Move(const Similarity& motion);
  LampNotes Notes(const std::string& name) const;
  Prepared<TableEmitter> Prepare(const Scene& scene) const;
};

} // namespace PhotonTransport
