// SPDX-License-Identifier: BSD-3-Clause
#ifndef WholeLuminaires_h
#define WholeLuminaires_h

#include "vtkSmartPointer.h"

class vtkInformationVector;

namespace Illumination
{

class ControllerRanks;

/// The data of an input port on which luminaires may be connected, with what all ranks have of
/// them. A luminaire is not divided. All ranks must call it. Throws InputError.
vtkSmartPointer<vtkInformationVector> WholeLuminaires(
  ControllerRanks& ranks, vtkInformationVector* port);

} // namespace Illumination

#endif
