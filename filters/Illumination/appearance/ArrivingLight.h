// SPDX-License-Identifier: BSD-3-Clause
#ifndef ArrivingLight_h
#define ArrivingLight_h

#include "Illumination/surface/SurfaceParts.h"

#include "vtkType.h"

#include <glm/vec3.hpp>

#include <string>

class vtkDataArray;

namespace Illumination
{

/// The light that arrives at the points of a lit surface, by its point arrays, lx by channel.
class ArrivingLight
{
public:
  /// @param array Of one component, which gets the colour that IlluminanceRGB tells of, where the
  /// block has that; or of three. Throws InputError if there is no such array of numbers.
  ArrivingLight(const NamedSurface& block, const std::string& array);

  /// Throws InputError, which names point, array and value, for light that is not finite or below
  /// 0.
  glm::dvec3 OnFront(vtkIdType point) const;
  /// 0 if the block has no IlluminanceBack, which is white.
  glm::dvec3 OnBack(vtkIdType point) const;

  bool HasColour() const { return this->Rgb != nullptr; }
  bool HasBack() const { return this->Back != nullptr; }

private:
  double Checked(vtkDataArray* array, vtkIdType point, int component) const;

  std::string Block;
  vtkDataArray* Total; ///< Null if the array has three components.
  vtkDataArray* Rgb;   ///< Null if the light is white.
  vtkDataArray* Back;
  bool RgbIsScaled; ///< Whether Total is another array than the luminous sum of Rgb.
};

} // namespace Illumination

#endif
