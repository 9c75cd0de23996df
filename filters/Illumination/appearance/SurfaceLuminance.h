// SPDX-License-Identifier: BSD-3-Clause
#ifndef SurfaceLuminance_h
#define SurfaceLuminance_h

#include "Illumination/appearance/FacingSurface.h"

#include "PhotonTransport/appearance/DisplayTransform.h"

#include <glm/vec3.hpp>

#include <functional>
#include <string>
#include <vector>

namespace Illumination
{

class ControllerRanks;

/// How a block of a lit surface shines.
struct LuminousBlock : NamedSurface
{
  FacingSurface surface;
  std::vector<glm::dvec3> luminance; ///< [point of surface] cd/m² by channel.
};

/// A cell as an observer sees it.
struct SeenCell
{
  double area;
  double luminance; ///< cd/m², mean of the corners.
  double brightest; ///< cd/m², of a corner.
  glm::dvec3 light; ///< On its front, lx by channel.
};

/// The luminance of all blocks of a lit surface, and what an observer adapts to. That leaves out
/// cells that shine themselves, unless there are no others, and ghost cells.
struct SurfaceLuminance
{
  std::vector<LuminousBlock> blocks; ///< Those with polygons or strips.
  std::vector<SeenCell> shining;     ///< Cells that shine themselves.
  std::vector<SeenCell> others;
  double adaptation = 0.0;        ///< cd/m²; LogMeanLuminance.
  double brightest = 0.0;         ///< cd/m², of a point.
  glm::dvec3 light{ 0.0 };        ///< Mean of the light on fronts by area, lx by channel.
  bool isColoured = false;        ///< Whether light, or what cells do with it, has a colour.
  std::vector<std::string> notes; ///< What is not shown, in words.
};

/// L = (reflectance × light on the front + transmittance × light on the back + exitance) / pi, as
/// Lambert's law has it. What an observer adapts to is left to Adapt. Throws InputError, and what
/// `report` throws.
/// @param data A vtkPolyData or a composite data set. @param illuminance Point array, lx.
/// @param report Gets the share that is done.
SurfaceLuminance LuminanceOf(vtkDataObject* data, const std::string& illuminance,
  const LookDescription& description, const std::function<void(double)>& report);

/// Finds what an observer adapts to, and the notes, who sees the parts of all ranks. Throws
/// InputError if there are no cells on any.
void Adapt(ControllerRanks& ranks, SurfaceLuminance& luminance);

} // namespace Illumination

#endif
