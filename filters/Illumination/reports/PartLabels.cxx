// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/reports/PartLabels.h"

#include "Illumination/pipeline/InputError.h"
#include "Illumination/pipeline/Text.h"
#include "Illumination/surface/InputChecks.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <cmath>
#include <sstream>
#include <utility>

namespace Illumination
{
namespace
{

enum Kind : int
{
  Number = 1,
  Word = 2
};

} // namespace

PartLabels::PartLabels(vtkPolyData* data, const std::string& array, std::string where)
  : Where(std::move(where))
{
  if (array.empty())
  {
    return;
  }
  this->Texts = vtkStringArray::SafeDownCast(data->GetCellData()->GetAbstractArray(array.c_str()));
  if (!this->Texts)
  {
    this->Numbers = CheckedCellArray(data, array, this->Where, false);
  }
  else if (this->Texts->GetNumberOfValues() != data->GetNumberOfCells())
  {
    throw InputError(Text("cell array '", array, "'", this->Where, " has ",
      this->Texts->GetNumberOfValues(), " texts for ", data->GetNumberOfCells(), " cells"));
  }
}

PartKey PartLabels::KeyOf(vtkIdType cell) const
{
  if (this->Texts)
  {
    return { Word, 0.0, this->Texts->GetValue(cell) };
  }
  const double number = this->Numbers->GetComponent(cell, 0);
  if (!std::isfinite(number))
  {
    throw InputError(Text("cell ", cell, this->Where, ": array '", this->Numbers->GetName(),
      "' is ", number, ", which names no part"));
  }
  return { Number, number, "" };
}

std::string PartLabels::NameOf(vtkIdType cell) const
{
  if (this->Texts)
  {
    return this->Texts->GetValue(cell);
  }
  std::ostringstream name;
  name.precision(15);
  name << this->Numbers->GetComponent(cell, 0);
  return name.str();
}

} // namespace Illumination
