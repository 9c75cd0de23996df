// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/materials/MaterialCells.h"

#include "Illumination/pipeline/InputError.h"
#include "Illumination/surface/GhostCells.h"
#include "Illumination/surface/InputChecks.h"

#include "PhotonTransport/materials/MaterialProperties.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <array>

namespace Illumination
{
namespace
{

using namespace PhotonTransport;

/// What a cell is that nobody has given a material.
MaterialValues Neutral()
{
  Material grey;
  grey.diffuseReflectance = Colour(0.5f);
  return ValuesOf(grey);
}

/// A new array with what the cells have, or with the neutral material's values.
vtkSmartPointer<vtkFloatArray> Copy(
  vtkPolyData* data, const std::string& block, const MaterialProperty& property, const float* rest)
{
  const int components = ComponentsOf(property);
  auto values = vtkSmartPointer<vtkFloatArray>::New();
  values->SetName(property.name);
  values->SetNumberOfComponents(components);
  values->SetNumberOfTuples(data->GetNumberOfCells());
  const bool given = data->GetCellData()->HasArray(property.name) != 0;
  vtkDataArray* source =
    given ? CheckedCellArray(data, property.name, block, components == 3) : nullptr;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    for (int c = 0; c < components; ++c)
    {
      const int from = given && source->GetNumberOfComponents() == 1 ? 0 : c; // 1 stands for grey
      values->SetTypedComponent(
        cell, c, given ? static_cast<float>(source->GetComponent(cell, from)) : rest[c]);
    }
  }
  return values;
}

using MaterialArrays = std::array<vtkSmartPointer<vtkFloatArray>, MaterialProperties.size()>;

MaterialValues ValuesOf(const MaterialArrays& arrays, vtkIdType cell)
{
  MaterialValues values{};
  for (std::size_t p = 0; p < arrays.size(); ++p)
  {
    arrays[p]->GetTypedTuple(cell, &values[3 * p]);
  }
  return values;
}

} // namespace

void RequireValid(const MaterialValues& values, const std::string& where)
{
  const std::string problem = ProblemOf(values);
  if (!problem.empty())
  {
    throw InputError(where + problem);
  }
}

void WriteMaterial(vtkPolyData* data, const std::string& block, const std::vector<bool>& chosen,
  const Material& material)
{
  MaterialArrays arrays;
  const MaterialValues neutral = Neutral();
  for (std::size_t p = 0; p < arrays.size(); ++p)
  {
    arrays[p] = Copy(data, block, MaterialProperties[p], &neutral[3 * p]);
  }
  const MaterialValues wanted = PhotonTransport::ValuesOf(material);
  const GhostCells ghosts(data, block);
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    if (!chosen[static_cast<std::size_t>(cell)])
    {
      if (ghosts.IsGhost(cell))
      {
        continue; // never looked at, whatever it holds
      }
      RequireValid(ValuesOf(arrays, cell), "cell " + std::to_string(cell) + block + ": ");
      continue;
    }
    for (std::size_t p = 0; p < arrays.size(); ++p)
    {
      arrays[p]->SetTypedTuple(cell, &wanted[3 * p]);
    }
  }
  for (const auto& array : arrays)
  {
    data->GetCellData()->AddArray(array);
  }
}

} // namespace Illumination
