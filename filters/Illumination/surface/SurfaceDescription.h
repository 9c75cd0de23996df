// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceDescription_h
#define SurfaceDescription_h

#include "PhotonTransport/materials/Material.h"

#include <string>

namespace Illumination
{

/// What the arrays and properties say about the surface.
struct SurfaceDescription
{
  PhotonTransport::Material material; ///< Where no array says otherwise.
  std::string reflectanceArray;       ///< Empty: DiffuseReflectance, where materialArrays.
  /// Whether arrays named as MaterialProperties count, and the array Opening.
  bool materialArrays = true;
  std::string exitanceArray; ///< Empty: nothing emits.
  double metresPerUnit = 1.0;
  double featureAngle = 30.0; ///< Degrees.
};

} // namespace Illumination

#endif
