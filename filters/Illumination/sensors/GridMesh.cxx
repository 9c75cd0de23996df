// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/sensors/GridMesh.h"

#include "Illumination/pipeline/FieldArrays.h"
#include "Illumination/pipeline/InputError.h"
#include "Illumination/surface/SurfaceParts.h"
#include "Illumination/surface/SurfaceTriangles.h"

#include "vtkCellArray.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <map>

namespace Illumination
{

using PhotonTransport::AreaTriangle;
using PhotonTransport::SensorGrid;

std::vector<AreaTriangle> TrianglesOfAll(vtkDataObject* data)
{
  std::vector<glm::dvec3> points;
  std::vector<glm::uvec3> facets;
  for (const NamedSurface& part : PartsOf(data).surfaces)
  {
    const SurfaceTriangles triangles = TrianglesOf(part.data, nullptr, part.name);
    AppendFacets(triangles.mesh, points.size(), facets);
    AppendPoints(triangles.mesh, points);
  }
  if (facets.empty())
  {
    throw InputError("Sensors have no polygons to put a grid over");
  }
  std::vector<AreaTriangle> all;
  for (const glm::uvec3& facet : facets)
  {
    all.push_back({ points[facet.x], points[facet.y], points[facet.z] });
  }
  return all;
}

void FillMesh(const SensorGrid& grid, vtkPolyData* mesh)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkFloatArray> normals;
  normals->SetName("Normals");
  normals->SetNumberOfComponents(3);
  std::map<std::array<std::size_t, 2>, vtkIdType> sensorOf;
  for (std::size_t i = 0; i < grid.sensors.size(); ++i)
  {
    points->InsertNextPoint(&grid.sensors[i].position.x);
    normals->InsertNextTuple(&grid.sensors[i].normal.x);
    sensorOf[grid.cellOf[i]] = static_cast<vtkIdType>(i);
  }
  vtkNew<vtkCellArray> quads, vertices;
  std::vector<bool> used(grid.sensors.size(), false);
  const auto at = [&](std::size_t column, std::size_t row)
  {
    const auto found = sensorOf.find({ column, row });
    return found == sensorOf.end() ? vtkIdType{ -1 } : found->second;
  };
  for (std::size_t row = 0; row + 1 < grid.cells[1]; ++row)
  {
    for (std::size_t column = 0; column + 1 < grid.cells[0]; ++column)
    {
      const vtkIdType corners[4] = { at(column, row), at(column + 1, row), at(column + 1, row + 1),
        at(column, row + 1) };
      if (*std::min_element(corners, corners + 4) >= 0)
      {
        quads->InsertNextCell(4, corners);
        std::for_each(corners, corners + 4,
          [&](vtkIdType corner) { used[static_cast<std::size_t>(corner)] = true; });
      }
    }
  }
  for (std::size_t i = 0; i < used.size(); ++i)
  {
    if (!used[i])
    {
      const auto point = static_cast<vtkIdType>(i);
      vertices->InsertNextCell(1, &point);
    }
  }
  mesh->Initialize();
  mesh->SetPoints(points);
  mesh->SetPolys(quads);
  mesh->SetVerts(vertices);
  mesh->GetPointData()->SetNormals(normals);
  AddArray(
    mesh->GetPointData(), "SensorArea", std::vector<double>(grid.sensors.size(), grid.cellArea));
}

} // namespace Illumination
