// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/surface/CellValues.h"

#include "Illumination/pipeline/InputError.h"
#include "Illumination/surface/InputChecks.h"
#include "Illumination/surface/SceneBlock.h"

#include "vtkDataArray.h"

#include <sstream>

CellValues::CellValues(
  const SceneBlock& block, const std::string& arrayName, const CellValueKind& kind)
  : Array(CheckedCellArray(block.data, arrayName, block.name, kind.colours))
{
  for (const vtkIdType cell : block.cellOfFacet)
  {
    for (int c = 0; c < this->Array->GetNumberOfComponents(); ++c)
    {
      const double value = this->Array->GetComponent(cell, c);
      if (!(value >= 0.0 && value <= kind.largest)) // NaN too
      {
        std::ostringstream message;
        message << "cell " << cell << block.name << ": " << kind.what << " " << value
                << " in array '" << arrayName << "' is outside [0, " << kind.largest << "]";
        throw InputError(message.str());
      }
    }
  }
}

PhotonTransport::Colour CellValues::Of(vtkIdType cell) const
{
  if (!this->Array)
  {
    return this->Constant;
  }
  PhotonTransport::Colour colour;
  const int components = this->Array->GetNumberOfComponents();
  for (int c = 0; c < 3; ++c)
  {
    colour[c] = static_cast<float>(this->Array->GetComponent(cell, c % components));
  }
  return colour;
}
