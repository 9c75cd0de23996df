// SPDX-License-Identifier: BSD-3-Clause
#include "CellValues.h"

#include "InputChecks.h"
#include "SceneBlocks.h"

#include "vtkDataArray.h"

#include <sstream>

CellValues::CellValues(
  const SceneBlock& block, const std::string& arrayName, const CellValueKind& kind)
  : Array(CheckedCellArray(block.data, arrayName, block.name))
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

float CellValues::Of(vtkIdType cell) const
{
  if (!this->Array)
  {
    return static_cast<float>(this->Constant);
  }
  const int components = this->Array->GetNumberOfComponents();
  double sum = 0.0;
  for (int c = 0; c < components; ++c)
  {
    sum += this->Array->GetComponent(cell, c);
  }
  return static_cast<float>(sum / components);
}
