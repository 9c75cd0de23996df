// SPDX-License-Identifier: BSD-3-Clause
// A luminaire's place travels with the points of its glyph. Each point has a record of where it was
// when the description was written, so that filters that move points move the luminaire.
#ifndef LuminairePlace_h
#define LuminairePlace_h

#include "PhotonTransport/geometry/Similarity.h"

class vtkPolyData;

namespace Illumination
{

/// Adds to a glyph whose field data describe a luminaire the point array LuminairePoint (x, y, z
/// and the luminaire's key) and the field array LuminaireGlyph (that key, area and length of the
/// cells). Four components, because filters turn arrays of three as vectors.
void RememberPlace(vtkPolyData* glyph);

/// How the glyph was moved since RememberPlace; no motion for data that never had these arrays.
/// Throws InputError for a glyph that lost one of them or some of its cells, or holds points of
/// another luminaire, and for motions that are none of FindMotion's.
PhotonTransport::Similarity MotionOf(vtkPolyData* glyph);

/// Whether the data have the point array LuminairePoint.
bool HasLuminairePoints(vtkPolyData* data);

} // namespace Illumination

#endif
