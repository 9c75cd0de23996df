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

RefinementBlocks::RefinementBlocks(
  const PhotonTransport::Surface& surface, const std::vector<SceneBlock>& blocks)
  : Points(surface.points)
  , Normals(surface.normals)
  , Facets(surface.facets)
  , Rounding(surface.rounding)
{
  for (const SceneBlock& block : blocks)
  {
    vtkDataArray* normals =
      block.normalsWereComputed ? nullptr : CheckedNormals(block.data, block.name);
    this->Parts.push_back({ block, normals, block.firstVertex, block.firstFacet,
      block.pointOfVertex, block.cellOfFacet });
  }
}

void RefinementBlocks::Append(const NamedSurface& part, double featureAngle)
{
  RequireValidCells(part.data, part.name);
  RequireArraySizes(part.data, part.name);
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
