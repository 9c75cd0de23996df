// SPDX-License-Identifier: BSD-3-Clause
// A luminaire's place travels with the points of its glyph: each point remembers where it was when
// the description was true, so that filters that move points move the luminaire.
#ifndef LuminairePlace_h
#define LuminairePlace_h

#include "Illumination/luminaires/GlyphMotion.h"

class vtkPolyData;

/// Adds to a glyph whose field data describe a luminaire the point array LuminairePoint (x, y, z
/// and the luminaire's key) and the field array LuminaireGlyph (that key, area and length of the
/// cells). Four components, because filters turn arrays of three as vectors.
void RememberPlace(vtkPolyData* glyph);

/// How the glyph was moved since. None for data that never remembered a place. Throws InputError
/// for a glyph that lost its memory, parts of it, or holds another luminaire too, and for motions
/// that no lamp can follow.
GlyphMotion MotionOf(vtkPolyData* glyph);

/// Whether points remember that they belong to a luminaire.
bool HasLuminairePoints(vtkPolyData* data);

#endif
