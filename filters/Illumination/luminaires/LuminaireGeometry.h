// SPDX-License-Identifier: BSD-3-Clause
#ifndef LuminaireGeometry_h
#define LuminaireGeometry_h

#include "PhotonTransport/lights/Lamp.h"

#include "vtkSmartPointer.h"

class vtkPolyData;

/// Stands for what has no size of its own.
struct LuminaireGlyph
{
  glm::dvec3 position{ 0.0 }; ///< Of lamps without one: parallel light and skies.
  double size = 0.1;          ///< Data's length unit, > 0.
};

/// What to show of a lamp, in the data's length unit: panels, balls and lines as they are (those of
/// size 0 as points, by the glyph's), panels with a line along their light; an arrow along parallel
/// light and from a Lambertian point, a ball for a point, an open cone with its axis for a spot
/// with its edge one glyph size away, a dome for a sky, and the polar diagram of a photometric
/// solid with its largest intensity one glyph size long. Where the lamp depends on how it is
/// turned, the points tell it. Finite for a lamp with finite values; nothing for emitting surfaces.
vtkSmartPointer<vtkPolyData> LuminaireGeometry(
  const PhotonTransport::Lamp& lamp, const LuminaireGlyph& glyph);

#endif
