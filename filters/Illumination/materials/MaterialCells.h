// SPDX-License-Identifier: BSD-3-Clause
#ifndef MaterialCells_h
#define MaterialCells_h

#include "PhotonTransport/materials/MaterialProperties.h"

#include <string>
#include <vector>

class vtkPolyData;

/// Throws InputError unless every value is finite and in its range and the shares of each channel
/// sum to at most 1. @param where Begins the message: "cell 7 of block 2: ", or "".
void RequireValid(const PhotonTransport::MaterialValues& values, const std::string& where);

/// Writes the arrays of MaterialProperties: the material for the chosen cells (one flag a cell);
/// the others keep what their arrays say, or, where there is no such array, are grey of 0.5. Arrays
/// are replaced, never changed: they may be shared with the input. Throws InputError, with no array
/// replaced, if an array is no material or what is kept makes none. @param block How messages name
/// the data: " of block 2", or "".
void WriteMaterial(vtkPolyData* data, const std::string& block, const std::vector<bool>& chosen,
  const PhotonTransport::Material& material);

#endif
