// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/surface/CellExitance.h"

#include "Illumination/pipeline/InputError.h"
#include "Illumination/pipeline/PieceNames.h"
#include "Illumination/surface/InputChecks.h"

#include "vtkDataArray.h"

#include <sstream>

namespace Illumination
{

std::vector<PhotonTransport::Colour> ExitanceOf(
  const NamedSurface& block, const std::string& array, const std::vector<vtkIdType>& cells)
{
  vtkDataArray* values = CheckedCellArray(block.data, array, block.name);
  std::vector<PhotonTransport::Colour> exitance;
  for (const vtkIdType cell : cells)
  {
    PhotonTransport::Colour colour;
    for (int c = 0; c < 3; ++c)
    {
      const double value = values->GetComponent(cell, c % values->GetNumberOfComponents());
      if (!(value >= 0.0 && value <= double{ VTK_FLOAT_MAX })) // NaN too
      {
        std::ostringstream message;
        message << NameOfCell(block.data, cell, block.name) << ": exitance " << value
                << " in array '" << array << "' is outside [0, " << VTK_FLOAT_MAX << "]";
        throw InputError(message.str());
      }
      colour[c] = static_cast<float>(value);
    }
    exitance.push_back(colour);
  }
  return exitance;
}

} // namespace Illumination
