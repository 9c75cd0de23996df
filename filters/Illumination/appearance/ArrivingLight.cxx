// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/appearance/ArrivingLight.h"

#include "Illumination/pipeline/InputError.h"
#include "Illumination/pipeline/Text.h"
#include "Illumination/surface/InputChecks.h"

#include "PhotonTransport/appearance/DisplayTransform.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <vector>

namespace Illumination
{
namespace
{

constexpr auto ColourArray = "IlluminanceRGB";
constexpr auto BackArray = "IlluminanceBack";

vtkDataArray* CheckedArray(
  const NamedSurface& block, const std::string& name, const std::vector<int>& components)
{
  const std::string where = "point array '" + name + "'" + block.name;
  vtkAbstractArray* found = block.data->GetPointData()->GetAbstractArray(name.c_str());
  if (!found)
  {
    throw InputError("there is no " + where + "; the input must be lit by Illumination Map");
  }
  return CheckedNumbers(found, where, components, block.data->GetNumberOfPoints(), "points");
}

vtkDataArray* OptionalArray(const NamedSurface& block, const char* name, int components)
{
  const bool isThere = block.data->GetPointData()->HasArray(name) != 0;
  return isThere ? CheckedArray(block, name, { components }) : nullptr;
}

} // namespace

ArrivingLight::ArrivingLight(const NamedSurface& block, const std::string& array)
  : Block(block.name)
  , Total(CheckedArray(block, array, { 1, 3 }))
  , Rgb(OptionalArray(block, ColourArray, 3))
  , Back(OptionalArray(block, BackArray, 1))
  , RgbIsScaled(array != "Illuminance")
{
  if (this->Total->GetNumberOfComponents() == 3)
  {
    this->Rgb = this->Total;
    this->RgbIsScaled = false;
  }
}

double ArrivingLight::Checked(vtkDataArray* array, vtkIdType point, int component) const
{
  const double value = array->GetComponent(point, component);
  if (!(value >= 0.0 && value <= double{ VTK_FLOAT_MAX })) // NaN too
  {
    throw InputError(Text("point ", point, this->Block, ": ", value, " in point array '",
      array->GetName(), "' is not a finite number >= 0"));
  }
  return value;
}

glm::dvec3 ArrivingLight::OnFront(vtkIdType point) const
{
  if (!this->Rgb)
  {
    return glm::dvec3(this->Checked(this->Total, point, 0));
  }
  glm::dvec3 light;
  for (int c = 0; c < 3; ++c)
  {
    light[c] = this->Checked(this->Rgb, point, c);
  }
  if (!this->RgbIsScaled)
  {
    return light;
  }
  const double total = this->Checked(this->Total, point, 0);
  const double luminous = PhotonTransport::LuminousSum(light);
  return luminous > 0.0 ? light * (total / luminous) : glm::dvec3(total);
}

glm::dvec3 ArrivingLight::OnBack(vtkIdType point) const
{
  return glm::dvec3(this->Back ? this->Checked(this->Back, point, 0) : 0.0);
}

} // namespace Illumination
