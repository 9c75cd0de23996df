// SPDX-License-Identifier: BSD-3-Clause
// Names of cells and points in messages. A filter that works on a whole surface sees the cells in
// another order than the user, and those of other ranks.
#ifndef PieceNames_h
#define PieceNames_h

#include "vtkType.h"

#include <string>

class vtkPolyData;

namespace Illumination
{

/// Cell array of two components: the piece of each cell, and the number that it has there.
constexpr const char* CellOrigins = "IlluminationCellOrigins";
/// Field array of two components: the same for points.
constexpr const char* PointOrigins = "IlluminationPointOrigins";
/// Field array: what names of cells and points of each piece end with, " of block 2 on rank 1".
constexpr const char* PieceNames = "IlluminationPieceNames";
/// Field array: the name of the whole block, " of block 2".
constexpr const char* BlockName = "IlluminationBlockName";

/// "cell 7 of block 2", as the user knows it. @param block How messages name the data: " of block
/// 2", or "". It counts where the data themselves are the user's.
std::string NameOfCell(vtkPolyData* data, vtkIdType cell, const std::string& block);
/// " of block 2". @param index Flat; it counts where the data themselves are the user's.
std::string NameOfBlock(vtkPolyData* data, unsigned index);
/// "point 7 of block 2".
std::string NameOfPoint(vtkPolyData* data, vtkIdType point, const std::string& block);

} // namespace Illumination

#endif
