// SPDX-License-Identifier: BSD-3-Clause
// vtkLuminaireSource's properties in the core's terms.
#ifndef LuminaireSettings_h
#define LuminaireSettings_h

#include "Illumination/luminaires/LuminaireGeometry.h"

#include "PhotonTransport/lights/Lamp.h"

class vtkLuminaireSource;

/// The lamp that the properties describe. Throws InputError with name and value of a property that
/// is out of its range and that the lamp's type uses, or for a file that can't be read.
PhotonTransport::Luminaire LuminaireOf(vtkLuminaireSource* source);

/// Throws InputError as LuminaireOf does.
LuminaireGlyph GlyphOf(vtkLuminaireSource* source);

#endif
