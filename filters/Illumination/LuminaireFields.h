// SPDX-License-Identifier: BSD-3-Clause
// How a luminaire travels through a pipeline: as field data of its visible geometry.
#ifndef LuminaireFields_h
#define LuminaireFields_h

#include "PhotonTransport/lights/Lamp.h"

#include <optional>

class vtkFieldData;
class vtkPolyData;

/// Adds field arrays that hold a luminaire: LuminaireType and LuminaireName (text), LuminaireColour
/// (3) and what its type needs. Emitting surfaces are not described by field data.
void AddLuminaire(vtkFieldData* fields, const PhotonTransport::Luminaire& luminaire);

/// The luminaire that AddLuminaire has written into a data set's field data; or else, for a surface
/// with a cell array "Exitance" (lm/m^2, 1 component or 3), that surface as
/// PhotonTransport::EmittingMesh. Nothing where there is neither. Throws InputError for fields or
/// arrays that contradict themselves.
std::optional<PhotonTransport::Luminaire> ReadLuminaire(vtkPolyData* data);

#endif
