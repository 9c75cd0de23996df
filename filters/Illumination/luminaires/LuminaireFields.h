// SPDX-License-Identifier: BSD-3-Clause
// How a luminaire travels through a pipeline: as field data of its visible geometry.
#ifndef LuminaireFields_h
#define LuminaireFields_h

#include "PhotonTransport/lights/Lamp.h"

#include <optional>
#include <string>

class vtkFieldData;
class vtkPolyData;

/// Adds field arrays that hold a luminaire: LuminaireType and LuminaireName (text), LuminaireColour
/// (3) and what its type needs. Emitting surfaces are not described by field data.
void AddLuminaire(vtkFieldData* fields, const PhotonTransport::Luminaire& luminaire);

/// Says in place of a description why there is none: whoever reads it refuses with these words.
void AddLuminaireError(vtkFieldData* fields, const std::string& error);

/// Whether the field data describe a luminaire, or say why they do not.
bool HasLuminaireFields(vtkFieldData* fields);

/// The luminaire that AddLuminaire has written into a data set's field data, moved as its points
/// were (see LuminairePlace.h); or else, for a surface with a cell array "Exitance" (lm/m^2, 1
/// component or 3), that surface as PhotonTransport::EmittingMesh. Nothing where there is neither.
/// Throws InputError for fields or arrays that contradict themselves, and for a luminaire that lost
/// its place.
std::optional<PhotonTransport::Luminaire> ReadLuminaire(vtkPolyData* data);

#endif
