// SPDX-License-Identifier: BSD-3-Clause
// How a luminaire travels through a pipeline: as field data of its visible geometry.
#ifndef LuminaireFields_h
#define LuminaireFields_h

#include "PhotonTransport/lights/Lamp.h"

#include <optional>
#include <string>

class vtkFieldData;
class vtkPolyData;

namespace Illumination
{

/// Adds field arrays that hold a luminaire: LuminaireType and LuminaireName (text), LuminaireColour
/// (3 components), LuminaireDimming (a factor on its light) and what its type needs. Throws
/// InputError for emitting surfaces, which are not described by field data.
void AddLuminaire(vtkFieldData* fields, const PhotonTransport::Luminaire& luminaire);

/// Adds the field array LuminaireError, which says why there is no description. ReadLuminaire
/// refuses the data with these words.
void AddLuminaireError(vtkFieldData* fields, const std::string& error);

/// Whether the field data hold LuminaireType or LuminaireError.
bool HasLuminaireFields(vtkFieldData* fields);

/// The luminaire that AddLuminaire has written into a data set's field data, moved as the points
/// were moved since (see LuminairePlace.h). Without such fields, a surface with a cell array
/// "Exitance" (lm/m^2, 1 component or 3) as PhotonTransport::EmittingMesh. Nothing if there is
/// neither. Throws InputError for fields or arrays that are invalid or contradict each other, for
/// data with both, for LuminaireError, for a photometric lamp that was mirrored and is not
/// symmetric, and as MotionOf does.
std::optional<PhotonTransport::Luminaire> ReadLuminaire(vtkPolyData* data);

} // namespace Illumination

#endif
