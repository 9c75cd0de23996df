// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/refinement/RefinementBlocks.h"

#include "Illumination/pipeline/InputError.h"
#include "Illumination/surface/ComputedNormals.h"
#include "Illumination/surface/GhostCells.h"
#include "Illumination/surface/InputChecks.h"
#include "Illumination/surface/SurfaceTriangles.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>

namespace Illumination
{
namespace
{

/// A block whose copies of other blocks' cells are not marked as such.
vtkSmartPointer<vtkPolyData> WithCopies(const NamedSurface& block)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->ShallowCopy(block.data);
  const GhostCells ghosts(block.data, block.name);
  if (ghosts.Any())
  {
    vtkNew<vtkUnsignedCharArray> hidden;
    hidden->SetName(vtkDataSetAttributes::GhostArrayName());
    for (vtkIdType cell = 0; cell < block.data->GetNumberOfCells(); ++cell)
    {
      const bool isHidden = ghosts.IsGhost(cell) && !ghosts.IsCopy(cell);
      hidden->InsertNextValue(isHidden ? vtkDataSetAttributes::HIDDENCELL : 0);
    }
    data->GetCellData()->AddArray(hidden);
  }
  return data;
}

void RequireSizes(
  vtkDataSetAttributes* arrays, vtkIdType wanted, const char* kind, const std::string& block)
{
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = arrays->GetAbstractArray(i);
    if (array->GetNumberOfTuples() != wanted)
    {
      const std::string name = array->GetName() ? array->GetName() : "";
      throw InputError(std::string(kind) + " array '" + name + "'" + block + " has " +
        std::to_string(array->GetNumberOfTuples()) + " values for " + std::to_string(wanted) + " " +
        kind + "s");
    }
  }
}

} // namespace

RefinementBlocks::RefinementBlocks(vtkDataObject* data, double featureAngle)
{
  for (const NamedSurface& part : PartsOf(data).surfaces)
  {
    this->Append(part, featureAngle);
  }
  if (this->Parts.empty())
  {
    throw InputError("the input has no surface (vtkPolyData)");
  }
}

void RefinementBlocks::Append(const NamedSurface& part, double featureAngle)
{
  RequireValidCells(part.data, part.name);
  RequireSizes(part.data->GetPointData(), part.data->GetNumberOfPoints(), "point", part.name);
  RequireSizes(part.data->GetCellData(), part.data->GetNumberOfCells(), "cell", part.name);
  vtkDataArray* given = CheckedNormals(part.data, part.name);
  vtkSmartPointer<vtkPolyData> mesh = TrianglesOf(WithCopies(part), given, part.name).mesh;
  if (!given && mesh->GetNumberOfPolys() > 0)
  {
    mesh = WithNormals(mesh, featureAngle);
  }
  RefinementBlock block{ part, given, this->Points.size(), this->Facets.size(),
    PointsOfTriangles(mesh), CellsOfTriangles(mesh) };
  AppendPoints(mesh, this->Points);
  this->Rounding = std::max(this->Rounding, RoundingOfPoints(part.data));
  AppendFacets(mesh, block.firstVertex, this->Facets);
  AppendNormals(mesh, this->Normals);
  this->Parts.push_back(std::move(block));
}

} // namespace Illumination
