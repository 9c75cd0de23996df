// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/reports/StatisticsArrays.h"

#include "Illumination/pipeline/InputError.h"
#include "Illumination/pipeline/Text.h"
#include "Illumination/surface/InputChecks.h"

#include "PhotonTransport/materials/Colour.h"
#include "PhotonTransport/materials/MaterialProperties.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace Illumination
{
namespace
{

using PhotonTransport::GroupValues;

constexpr const char* AreaArray = "SensorArea";

vtkDataArray* PointNumbers(
  vtkDataSet* data, const std::string& name, int components, const std::string& where)
{
  const std::string text = "point array '" + name + "'" + where;
  vtkAbstractArray* found = data->GetPointData()->GetAbstractArray(name.c_str());
  if (!found)
  {
    throw InputError("there is no " + text);
  }
  return CheckedNumbers(found, text, { components }, data->GetNumberOfPoints(), "points");
}

} // namespace

bool HasPointArray(vtkDataSet* data, const std::string& name)
{
  return !name.empty() && data->GetPointData()->HasArray(name.c_str()) != 0;
}

LightArrays::LightArrays(const NamedBlock& block, const StatisticsArrays& names)
  : Where(block.where)
  , Illuminance(PointNumbers(block.data, names.illuminance, 1, block.where))
  , Ghosts(vtkUnsignedCharArray::SafeDownCast(
      block.data->GetPointData()->GetAbstractArray(vtkDataSetAttributes::GhostArrayName())))
{
  if (!names.standardError.empty())
  {
    this->Errors = PointNumbers(block.data, names.standardError, 1, block.where);
  }
  if (HasPointArray(block.data, names.valid))
  {
    this->Valid = PointNumbers(block.data, names.valid, 1, block.where);
  }
  if (HasPointArray(block.data, AreaArray))
  {
    this->Areas = PointNumbers(block.data, AreaArray, 1, block.where);
  }
  for (const std::string& name : names.groups)
  {
    constexpr int Components = static_cast<int>(PhotonTransport::Groups);
    this->Groups.push_back(PointNumbers(block.data, name, Components, block.where));
  }
  if (this->Ghosts && this->Ghosts->GetNumberOfTuples() != block.data->GetNumberOfPoints())
  {
    this->Ghosts = nullptr; // as VTK does
  }
}

bool LightArrays::IsValid(vtkIdType point) const
{
  return !this->Valid || this->Valid->GetComponent(point, 0) != 0.0;
}

bool LightArrays::IsGhost(vtkIdType point) const
{
  constexpr int Ghost = vtkDataSetAttributes::DUPLICATEPOINT | vtkDataSetAttributes::HIDDENPOINT;
  return this->Ghosts && (this->Ghosts->GetValue(point) & Ghost) != 0;
}

void LightArrays::Append(vtkIdType point, PhotonTransport::NoisyValues& light) const
{
  light.values.push_back(this->Checked(this->Illuminance, point));
  if (this->Errors)
  {
    light.standardErrors.push_back(this->Checked(this->Errors, point));
  }
  if (this->Groups.empty())
  {
    return;
  }
  GroupValues sum{};
  for (vtkDataArray* array : this->Groups)
  {
    for (std::size_t g = 0; g < sum.size(); ++g)
    {
      sum[g] += array->GetComponent(point, static_cast<int>(g));
    }
  }
  if (!std::all_of(sum.begin(), sum.end(), [](double value) { return std::isfinite(value); }))
  {
    throw InputError(Text("point ", point, this->Where, ": a value of array '",
      this->Groups.front()->GetName(), "' is not finite"));
  }
  light.groups.push_back(sum);
}

double LightArrays::Checked(vtkDataArray* array, vtkIdType point) const
{
  const double value = array->GetComponent(point, 0);
  if (!(std::isfinite(value) && value >= 0.0))
  {
    throw InputError(Text("point ", point, this->Where, ": ", array->GetName(), " is ", value,
      "; it must be a finite number >= 0"));
  }
  return value;
}

CellReflectance::CellReflectance(
  vtkPolyData* data, const StatisticsArrays& names, std::string where)
  : Where(std::move(where))
  , Common(names.commonReflectance)
{
  const char* usual = PhotonTransport::MaterialProperties.front().name;
  if (!names.reflectance.empty() || data->GetCellData()->HasArray(usual) != 0)
  {
    this->Values =
      CheckedCellArray(data, names.reflectance.empty() ? usual : names.reflectance, this->Where);
  }
}

double CellReflectance::Of(vtkIdType cell) const
{
  if (!this->Values)
  {
    return this->Common;
  }
  PhotonTransport::Colour colour;
  for (int c = 0; c < 3; ++c)
  {
    const double value =
      this->Values->GetComponent(cell, c % this->Values->GetNumberOfComponents());
    if (!(value >= 0.0 && value <= 1.0))
    {
      throw InputError(Text("cell ", cell, this->Where, ": array '", this->Values->GetName(),
        "' is ", value, "; a reflectance must be within [0, 1]"));
    }
    colour[c] = static_cast<float>(value);
  }
  return double{ PhotonTransport::Luminous(colour) };
}

} // namespace Illumination
