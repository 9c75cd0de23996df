// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/luminaires/EmittingSurface.h"

#include "Illumination/pipeline/InputError.h"
#include "Illumination/pipeline/PieceNames.h"
#include "Illumination/surface/CellExitance.h"
#include "Illumination/surface/InputChecks.h"
#include "Illumination/surface/SurfaceTriangles.h"
#include "Illumination/surface/TriangleOrder.h"

#include "PhotonTransport/scene/FacetSide.h"

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

namespace Illumination
{
namespace
{

using namespace PhotonTransport;

constexpr const char* Exitance = "Exitance";

/// A vector as long as twice the facet's area, to the side round which its corners run
/// counter-clockwise.
glm::dvec3 AreaVector(const EmittingMesh& mesh, const glm::uvec3& facet)
{
  const glm::dvec3& a = mesh.points[facet.x];
  return glm::cross(mesh.points[facet.y] - a, mesh.points[facet.z] - a);
}

/// @param ordered The triangles of the mesh, as they are of the data.
void TurnToNormals(
  EmittingMesh& mesh, vtkDataArray* normals, vtkPolyData* ordered, vtkPolyData* data)
{
  const std::vector<vtkIdType> points = PointsOfTriangles(ordered);
  const std::vector<vtkIdType> cells = CellsOfTriangles(ordered);
  for (std::size_t f = 0; f < mesh.facets.size(); ++f)
  {
    glm::uvec3& facet = mesh.facets[f];
    std::array<glm::dvec3, 3> corners;
    for (int corner = 0; corner < 3; ++corner)
    {
      normals->GetTuple(points[facet[corner]], &corners[static_cast<std::size_t>(corner)].x);
    }
    const FacetSide side = SideOf(AreaVector(mesh, facet), corners);
    if (side.undecided)
    {
      throw InputError("the point normals of " + NameOfCell(data, cells[f], "") +
        " lie in its own plane or cancel, so they do not tell to which side it shines; compute "
        "them anew or remove them");
    }
    if (side.turned)
    {
      std::swap(facet.y, facet.z);
    }
  }
}

/// The colour of the light of all facets together, scaled so that its largest part is 1, since only
/// ratios count. A mesh without light is white. @param exitance [facet]
Colour ColourOf(const EmittingMesh& mesh, const std::vector<Colour>& exitance)
{
  const std::vector<bool> copies = CopiesIn(mesh);
  glm::dvec3 light(0.0);
  for (std::size_t f = 0; f < mesh.facets.size(); ++f)
  {
    light += copies[f] ? glm::dvec3(0.0)
                       : glm::length(AreaVector(mesh, mesh.facets[f])) * glm::dvec3(exitance[f]);
  }
  const double largest = std::max({ light.x, light.y, light.z });
  return largest > 0.0 && std::isfinite(largest) ? Colour(light / largest) : Colour(1.0f);
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

  const vtkSmartPointer<vtkPolyData> ordered = OrderedByPlace(triangles.mesh, data);
  const std::vector<vtkIdType> cells = CellsOfTriangles(ordered);
  const std::vector<Colour> exitance = ExitanceOf({ data, "" }, Exitance, cells);
  if (cells.empty())
  {
    throw InputError("a surface with a cell array 'Exitance' has no polygons or triangle strips "
                     "with an area to shine");
  }
  if (triangles.uncut.number > 0)
  {
    throw InputError(NameOfCell(data, triangles.uncut.first, "") +
      " crosses or touches itself, so its Exitance gives no flux");
  }

  EmittingMesh mesh;
  AppendPoints(ordered, mesh.points);
  AppendFacets(ordered, 0, mesh.facets);
  if (normals)
  {
    TurnToNormals(mesh, normals, ordered, data);
  }
  for (const Colour& colour : exitance)
  {
    mesh.exitance.push_back(Luminous(colour));
  }
  const Colour colour = ColourOf(mesh, exitance);
  auto* name =
    vtkStringArray::SafeDownCast(data->GetFieldData()->GetAbstractArray("LuminaireName"));
  const bool named = name && name->GetNumberOfValues() > 0;
  return Luminaire{ std::move(mesh), named ? std::string(name->GetValue(0)) : "", colour };
}

} // namespace Illumination
