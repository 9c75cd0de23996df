// SPDX-License-Identifier: BSD-3-Clause
#include "EmittingSurface.h"

#include "CellValues.h"
#include "InputChecks.h"
#include "SceneBlocks.h"

#include "PhotonTransport/scene/FacetSide.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

namespace
{

using namespace PhotonTransport;

constexpr const char* Exitance = "Exitance";

std::vector<glm::dvec3> PointsOf(vtkPolyData* mesh)
{
  std::vector<glm::dvec3> points;
  for (vtkIdType p = 0; p < mesh->GetNumberOfPoints(); ++p)
  {
    glm::dvec3 point;
    mesh->GetPoint(p, &point.x);
    points.push_back(point);
  }
  return points;
}

std::vector<glm::uvec3> FacetsOf(vtkPolyData* mesh)
{
  std::vector<glm::uvec3> facets;
  auto it = vtk::TakeSmartPointer(mesh->GetPolys()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    facets.emplace_back(
      static_cast<unsigned>(ids[0]), static_cast<unsigned>(ids[1]), static_cast<unsigned>(ids[2]));
  }
  return facets;
}

/// A vector as long as twice the facet's area, to the side round which its corners run
/// counter-clockwise.
glm::dvec3 AreaVector(const EmittingMesh& mesh, const glm::uvec3& facet)
{
  const glm::dvec3& a = mesh.points[facet.x];
  return glm::cross(mesh.points[facet.y] - a, mesh.points[facet.z] - a);
}

void TurnToNormals(
  EmittingMesh& mesh, vtkDataArray* normals, const std::vector<vtkIdType>& cellOfFacet)
{
  for (std::size_t f = 0; f < mesh.facets.size(); ++f)
  {
    glm::uvec3& facet = mesh.facets[f];
    std::array<glm::dvec3, 3> corners;
    for (int corner = 0; corner < 3; ++corner)
    {
      normals->GetTuple(facet[corner], &corners[static_cast<std::size_t>(corner)].x);
    }
    const FacetSide side = SideOf(AreaVector(mesh, facet), corners);
    if (side.undecided)
    {
      throw InputError("the point normals of cell " + std::to_string(cellOfFacet[f]) +
        " lie in its own plane or cancel, so they do not tell to which side it shines; compute "
        "them anew or remove them");
    }
    if (side.turned)
    {
      std::swap(facet.y, facet.z);
    }
  }
}

Colour ColourOf(vtkDataArray* exitance, vtkIdType cell)
{
  Colour colour;
  for (int c = 0; c < 3; ++c)
  {
    const int component = exitance->GetNumberOfComponents() == 3 ? c : 0;
    colour[c] = static_cast<float>(exitance->GetComponent(cell, component));
  }
  return colour;
}

/// The colour scaled so that its largest part is 1, since only ratios count. A mesh without light
/// is white.
Colour WithLargestOne(const glm::dvec3& colour)
{
  const double largest = std::max({ colour.x, colour.y, colour.z });
  return largest > 0.0 && std::isfinite(largest) ? Colour(colour / largest) : Colour(1.0f);
}

} // namespace

std::optional<Luminaire> ReadEmittingSurface(vtkPolyData* data)
{
  if (!data->GetCellData()->HasArray(Exitance))
  {
    return std::nullopt;
  }
  vtkDataArray* normals = CheckedNormals(data, "");
  const SurfaceTriangles triangles = TrianglesOf(data, nullptr, "");

  SceneBlock block;
  block.data = data;
  block.cellOfFacet = CellsOfTriangles(triangles.mesh);
  const CellValues checked(block, Exitance, { "exitance", VTK_FLOAT_MAX });
  if (block.cellOfFacet.empty())
  {
    throw InputError("a surface with a cell array 'Exitance' has no polygons or triangle strips "
                     "with an area to shine");
  }
  if (triangles.uncut.number > 0)
  {
    throw InputError("cell " + std::to_string(triangles.uncut.first) +
      " crosses or touches itself, so its Exitance gives no flux");
  }

  EmittingMesh mesh{ PointsOf(triangles.mesh), FacetsOf(triangles.mesh), {} };
  if (normals)
  {
    TurnToNormals(mesh, normals, block.cellOfFacet);
  }
  vtkDataArray* exitance = data->GetCellData()->GetArray(Exitance);
  glm::dvec3 light(0.0);
  for (std::size_t f = 0; f < mesh.facets.size(); ++f)
  {
    const Colour colour = ColourOf(exitance, block.cellOfFacet[f]);
    mesh.exitance.push_back(Luminous(colour));
    light += glm::length(AreaVector(mesh, mesh.facets[f])) * glm::dvec3(colour);
  }
  auto* name =
    vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("LuminaireName"));
  const bool named = name && name->GetNumberOfValues() > 0;
  return Luminaire{ std::move(mesh), named ? std::string(name->GetValue(0)) : "",
    WithLargestOne(light) };
}
