// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/surface/TriangleOrder.h"

#include "Illumination/pipeline/PieceNames.h"
#include "Illumination/surface/SurfaceParts.h"
#include "Illumination/surface/SurfaceTriangles.h"

#include "PhotonTransport/threads/Threads.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cstdint>
#include <cstring>
#include <limits>
#include <vector>

namespace Illumination
{
namespace
{

/// Spreads 21 bits so that two free ones follow each.
std::uint64_t Spread(std::uint64_t bits)
{
  bits = (bits | bits << 32) & 0x001f00000000ffff;
  bits = (bits | bits << 16) & 0x001f0000ff0000ff;
  bits = (bits | bits << 8) & 0x100f00f00f00f00f;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3;
  return (bits | bits << 2) & 0x1249249249249249;
}

int Compare(double a, double b)
{
  return a < b ? -1 : (b < a ? 1 : 0);
}

int Compare(const glm::dvec3& a, const glm::dvec3& b)
{
  const int x = Compare(a.x, b.x);
  const int y = x != 0 ? x : Compare(a.y, b.y);
  return y != 0 ? y : Compare(a.z, b.z);
}

/// Where a place is along the curve through a box.
std::uint64_t CodeOf(const glm::dvec3& place, const glm::dvec3& least, const glm::dvec3& most)
{
  constexpr double Steps = 0x1p21 - 1.0;
  std::uint64_t code = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    // Halves, since the whole extent may be more than a number can hold.
    const double extent = 0.5 * most[axis] - 0.5 * least[axis];
    const double along = 0.5 * place[axis] - 0.5 * least[axis];
    const double share = extent > 0.0 ? along / extent : 0.0;
    code |= Spread(static_cast<std::uint64_t>(Steps * std::clamp(share, 0.0, 1.0))) << axis;
  }
  return code;
}

/// A triangle and its place, side by side, so that sorting looks at nothing else.
struct PlaceOnCurve
{
  std::uint64_t code;
  std::size_t triangle;
};

/// The triangles of a mesh, to be put in order.
class Triangles
{
public:
  Triangles(vtkPolyData* mesh, vtkPolyData* data)
    : Cells(CellsOfTriangles(mesh))
    , Data(data)
  {
    AppendPoints(mesh, this->Points);
    AppendNormals(mesh, this->Normals);
    AppendFacets(mesh, 0, this->Facets);
  }

  /// [place in the order] Triangle.
  std::vector<PlaceOnCurve> Order() const
  {
    std::vector<PlaceOnCurve> order = this->Places();
    std::sort(order.begin(), order.end(),
      [&](const PlaceOnCurve& a, const PlaceOnCurve& b)
      {
        if (a.code != b.code)
        {
          return a.code < b.code;
        }
        const int difference = this->Difference(a.triangle, b.triangle);
        return difference != 0 ? difference < 0 : a.triangle < b.triangle;
      });
    return order;
  }

  const glm::uvec3& Facet(std::size_t triangle) const { return this->Facets[triangle]; }
  vtkIdType Cell(std::size_t triangle) const { return this->Cells[triangle]; }

private:
  glm::dvec3 Middle(const glm::uvec3& facet) const
  {
    return this->Points[facet.x] / 3.0 + this->Points[facet.y] / 3.0 + this->Points[facet.z] / 3.0;
  }

  /// Where the middles of triangles are along the curve.
  std::vector<PlaceOnCurve> Places() const
  {
    glm::dvec3 least(std::numeric_limits<double>::max());
    glm::dvec3 most(std::numeric_limits<double>::lowest());
    for (const glm::uvec3& facet : this->Facets)
    {
      const glm::dvec3 middle = this->Middle(facet);
      least = glm::min(least, middle);
      most = glm::max(most, middle);
    }
    std::vector<PlaceOnCurve> places(this->Facets.size());
    PhotonTransport::ForEach(places.size(),
      [&](std::size_t f) {
        places[f] = { CodeOf(this->Middle(this->Facets[f]), least, most), f };
      });
    return places;
  }

  /// Below 0 if a is to come first; 0 if nothing tells them apart.
  int Difference(std::size_t a, std::size_t b) const
  {
    const glm::uvec3 &ofA = this->Facets[a], &ofB = this->Facets[b];
    for (const std::vector<glm::dvec3>* values : { &this->Points, &this->Normals })
    {
      for (int c = 0; c < 3; ++c)
      {
        const int difference = Compare((*values)[ofA[c]], (*values)[ofB[c]]);
        if (difference != 0)
        {
          return difference;
        }
      }
    }
    return this->CellDifference(this->Cells[a], this->Cells[b]);
  }

  int CellDifference(vtkIdType a, vtkIdType b) const
  {
    vtkCellData* arrays = this->Data->GetCellData();
    for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
    {
      vtkDataArray* array = arrays->GetArray(i);
      const bool tells = array && array->GetName() && std::strcmp(array->GetName(), CellOrigins) &&
        a < array->GetNumberOfTuples() && b < array->GetNumberOfTuples();
      for (int c = 0; tells && c < array->GetNumberOfComponents(); ++c)
      {
        const int difference = Compare(array->GetComponent(a, c), array->GetComponent(b, c));
        if (difference != 0)
        {
          return difference;
        }
      }
    }
    return 0;
  }

  std::vector<glm::dvec3> Points;
  std::vector<glm::dvec3> Normals;
  std::vector<glm::uvec3> Facets;
  std::vector<vtkIdType> Cells;
  vtkPolyData* Data;
};

/// Numbers points in the order in which they are met.
class PointNumbers
{
public:
  explicit PointNumbers(vtkIdType points)
    : NumberOfPoint(static_cast<std::size_t>(points), -1)
  {
  }

  vtkIdType Of(unsigned point)
  {
    vtkIdType& number = this->NumberOfPoint[point];
    number = number >= 0 ? number : this->Met->InsertNextId(point);
    return number;
  }

  vtkNew<vtkIdList> Met;

private:
  std::vector<vtkIdType> NumberOfPoint;
};

} // namespace

vtkSmartPointer<vtkPolyData> OrderedByPlace(vtkPolyData* mesh, vtkPolyData* data)
{
  const Triangles triangles(mesh, data);
  PointNumbers numbers(mesh->GetNumberOfPoints());
  vtkNew<vtkCellArray> cells;
  vtkNew<vtkIdTypeArray> cellIds;
  cellIds->SetName(mesh->GetCellData()->GetArrayName(0));
  cells->AllocateExact(mesh->GetNumberOfPolys(), 3 * mesh->GetNumberOfPolys());
  for (const PlaceOnCurve& place : triangles.Order())
  {
    const glm::uvec3& facet = triangles.Facet(place.triangle);
    const vtkIdType corners[3] = { numbers.Of(facet.x), numbers.Of(facet.y), numbers.Of(facet.z) };
    cells->InsertNextCell(3, corners);
    cellIds->InsertNextValue(triangles.Cell(place.triangle));
  }
  auto ordered = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  if (mesh->GetPoints())
  {
    points->SetDataType(mesh->GetPoints()->GetDataType());
    mesh->GetPoints()->GetPoints(numbers.Met, points);
  }
  ordered->SetPoints(points);
  ordered->SetPolys(cells);
  ordered->GetCellData()->AddArray(cellIds);
  vtkPointData* arrays = mesh->GetPointData();
  vtkPointData* kept = ordered->GetPointData();
  kept->CopyAllOn();
  kept->CopyAllocate(arrays, numbers.Met->GetNumberOfIds());
  kept->CopyData(arrays, numbers.Met);
  return ordered;
}

} // namespace Illumination
