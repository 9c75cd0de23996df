// SPDX-License-Identifier: BSD-3-Clause
#ifndef MaterialCells_h
#define MaterialCells_h

#include "PhotonTransport/materials/MaterialProperties.h"

#include <string>
#include <vector>

class vtkPolyData;

namespace Illumination
{

/// Throws InputError unless every value is finite and in its range and the shares of each channel
/// sum to at most 1. @param where The beginning of the message: "cell 7 of block 2: ", or "".
void RequireValid(const PhotonTransport::MaterialValues& values, const std::string& where);

/// Writes the arrays of MaterialProperties. The chosen cells (one flag a cell) get the material.
/// The other cells keep the values of their arrays; where an array is missing they get its value of
/// a matt grey of reflectance 0.5. Arrays are replaced and never changed, since they may be shared
/// with the input. Throws InputError, with no array replaced, if an array has the wrong size or
/// type or if a cell that is not chosen, and no ghost, keeps invalid values. @param block How
/// messages name the data: " of block 2", or "".
void WriteMaterial(vtkPolyData* data, const std::string& block, const std::vector<bool>& chosen,
  const PhotonTransport::Material& material);

} // namespace Illumination

#endif
