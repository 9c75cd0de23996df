// SPDX-License-Identifier: BSD-3-Clause
#ifndef LuminaireGeometry_h
#define LuminaireGeometry_h

#include "PhotonTransport/lights/Lamp.h"

#include "vtkSmartPointer.h"

class vtkPolyData;

namespace Illumination
{

/// How lamps are drawn that have no size of their own.
struct LuminaireGlyph
{
  glm::dvec3 position{ 0.0 }; ///< Where parallel light and skies are drawn.
  double size = 0.1;          ///< Data's length unit, > 0.
};

/// What to show of a lamp, in the data's length unit. Panels, balls and lines are drawn as they
/// are, panels with a line along their light. Panels and lines of size 0 are drawn as an arrow,
/// balls of radius 0 as a point lamp. Parallel light and a Lambertian point are an arrow of one
/// glyph size, a point a ball of that diameter, a spot an open cone with its axis and with its rim
/// one glyph size from the lamp, a sky a dome of that radius. A photometric solid is its polar
/// diagram, with the largest intensity one glyph size from the lamp. If turning a lamp changes its
/// light, it moves the points, too. The points are finite for a lamp with finite values. Emitting
/// surfaces give no points.
vtkSmartPointer<vtkPolyData> LuminaireGeometry(
  const PhotonTransport::Lamp& lamp, const LuminaireGlyph& glyph);

} // namespace Illumination

#endif
