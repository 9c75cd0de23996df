// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/ranks/PieceResults.h"

#include "Illumination/pipeline/PieceNames.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cstring>
#include <map>
#include <vector>

namespace Illumination
{
namespace
{

/// Arrays that only tell where cells and points come from.
bool IsOrigin(vtkAbstractArray* array)
{
  const char* name = array->GetName();
  return name &&
    (!std::strcmp(name, CellOrigins) || !std::strcmp(name, PointOrigins) ||
      !std::strcmp(name, PieceNames) || !std::strcmp(name, BlockName));
}

/// An array of the same kind whose tuples are those of the places, or 0 where the place is -1.
vtkSmartPointer<vtkAbstractArray> Chosen(
  vtkAbstractArray* from, const std::vector<vtkIdType>& places)
{
  auto chosen = vtk::TakeSmartPointer(from->NewInstance());
  chosen->SetName(from->GetName());
  chosen->SetNumberOfComponents(from->GetNumberOfComponents());
  chosen->CopyComponentNames(from);
  chosen->SetNumberOfTuples(static_cast<vtkIdType>(places.size()));
  auto* numbers = vtkDataArray::SafeDownCast(chosen);
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    if (places[i] >= 0)
    {
      chosen->SetTuple(static_cast<vtkIdType>(i), places[i], from);
    }
    for (int c = 0; numbers && places[i] < 0 && c < numbers->GetNumberOfComponents(); ++c)
    {
      numbers->SetComponent(static_cast<vtkIdType>(i), c, 0.0);
    }
  }
  return chosen;
}

vtkIdTypeArray* OriginsOf(vtkPolyData* data)
{
  return vtkIdTypeArray::SafeDownCast(data->GetCellData()->GetAbstractArray(CellOrigins));
}

/// [cell of the piece] The cell of the whole, or -1.
std::vector<vtkIdType> PlacesOfCells(vtkPolyData* whole, std::size_t piece, vtkIdType cells)
{
  std::vector<vtkIdType> places(static_cast<std::size_t>(cells), -1);
  vtkIdTypeArray* origins = OriginsOf(whole);
  for (vtkIdType cell = 0; cell < origins->GetNumberOfTuples(); ++cell)
  {
    if (origins->GetTypedComponent(cell, 0) == static_cast<vtkIdType>(piece))
    {
      places[static_cast<std::size_t>(origins->GetTypedComponent(cell, 1))] = cell;
    }
  }
  return places;
}

/// The parts of a piece's cells in a refined surface, as a surface of its own.
class RefinedPiece
{
public:
  /// @param points [point of the piece] The point of the surface, refined or not.
  RefinedPiece(
    vtkPolyData* refined, std::size_t piece, const std::vector<vtkIdType>& points, vtkPolyData* own)
    : Refined(refined)
    , Own(own)
    , Piece(static_cast<vtkIdType>(piece))
    , Points(points)
    , CellsBefore(own->GetNumberOfVerts() + own->GetNumberOfLines())
  {
    for (std::size_t p = 0; p < points.size(); ++p)
    {
      this->OwnPoint.emplace(points[p], static_cast<vtkIdType>(p));
    }
  }

  vtkSmartPointer<vtkPolyData> Make()
  {
    auto result = vtkSmartPointer<vtkPolyData>::New();
    result->SetVerts(this->Own->GetVerts());
    result->SetLines(this->Own->GetLines());
    result->SetPolys(this->CellsOf(this->Refined->GetPolys(), 0));
    result->SetStrips(this->CellsOf(this->Refined->GetStrips(), this->Refined->GetNumberOfPolys()));
    vtkNew<vtkPoints> points;
    points->SetDataType(this->Refined->GetPoints()->GetDataType());
    points->SetNumberOfPoints(static_cast<vtkIdType>(this->Points.size()));
    for (std::size_t p = 0; p < this->Points.size(); ++p)
    {
      points->SetPoint(
        static_cast<vtkIdType>(p), this->Refined->GetPoints()->GetPoint(this->Points[p]));
    }
    result->SetPoints(points);
    this->AddPointArrays(result->GetPointData());
    this->AddCellArrays(result->GetCellData());
    return result;
  }

private:
  /// The piece's cells among those of the refined surface, in the order of those they come from.
  vtkSmartPointer<vtkCellArray> CellsOf(vtkCellArray* cells, vtkIdType first)
  {
    vtkIdTypeArray* origins = OriginsOf(this->Refined);
    std::vector<vtkIdType> own;
    for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
    {
      if (origins->GetTypedComponent(first + cell, 0) == this->Piece)
      {
        own.push_back(first + cell);
      }
    }
    std::stable_sort(own.begin(), own.end(),
      [&](vtkIdType a, vtkIdType b)
      { return origins->GetTypedComponent(a, 1) < origins->GetTypedComponent(b, 1); });
    auto chosen = vtkSmartPointer<vtkCellArray>::New();
    vtkNew<vtkIdList> corners;
    for (const vtkIdType cell : own)
    {
      cells->GetCellAtId(cell - first, corners);
      chosen->InsertNextCell(static_cast<int>(corners->GetNumberOfIds()));
      for (vtkIdType i = 0; i < corners->GetNumberOfIds(); ++i)
      {
        chosen->InsertCellPoint(this->OwnPointOf(corners->GetId(i)));
      }
      this->Cells.push_back(cell);
    }
    return chosen;
  }

  vtkIdType OwnPointOf(vtkIdType point)
  {
    const auto [place, isNew] =
      this->OwnPoint.emplace(point, static_cast<vtkIdType>(this->Points.size()));
    if (isNew)
    {
      this->Points.push_back(point);
    }
    return place->second;
  }

  void AddPointArrays(vtkPointData* result) const
  {
    vtkPointData* refined = this->Refined->GetPointData();
    for (int i = 0; i < refined->GetNumberOfArrays(); ++i)
    {
      this->AddArray(refined, i, this->Points, result);
    }
    auto* ids = vtkIdTypeArray::SafeDownCast(result->GetAbstractArray("OriginalPointIds"));
    for (vtkIdType p = 0; ids && p < ids->GetNumberOfTuples(); ++p)
    {
      const auto found = this->OwnPoint.find(ids->GetValue(p));
      const bool isGiven = p < this->Own->GetNumberOfPoints();
      ids->SetValue(p,
        isGiven ? p : (ids->GetValue(p) < 0 || found == this->OwnPoint.end() ? -1 : found->second));
    }
  }

  void AddCellArrays(vtkCellData* result) const
  {
    std::vector<vtkIdType> places(static_cast<std::size_t>(this->CellsBefore), -1);
    places.insert(places.end(), this->Cells.begin(), this->Cells.end());
    vtkCellData* refined = this->Refined->GetCellData();
    for (int i = 0; i < refined->GetNumberOfArrays(); ++i)
    {
      vtkAbstractArray* array = refined->GetAbstractArray(i);
      if (!IsOrigin(array))
      {
        this->AddArray(refined, i, places, result);
        vtkAbstractArray* given = this->Own->GetCellData()->GetAbstractArray(array->GetName());
        if (given && this->CellsBefore > 0)
        {
          result->GetAbstractArray(array->GetName())->InsertTuples(0, this->CellsBefore, 0, given);
        }
      }
    }
    auto* ids = vtkIdTypeArray::SafeDownCast(result->GetAbstractArray("OriginalCellIds"));
    for (vtkIdType cell = 0; ids && cell < ids->GetNumberOfTuples(); ++cell)
    {
      const vtkIdType place = places[static_cast<std::size_t>(cell)];
      ids->SetValue(cell, place < 0 ? cell : OriginsOf(this->Refined)->GetTypedComponent(place, 1));
    }
  }

  static void AddArray(vtkDataSetAttributes* refined, int number,
    const std::vector<vtkIdType>& places, vtkDataSetAttributes* result)
  {
    vtkAbstractArray* array = refined->GetAbstractArray(number);
    result->AddArray(Chosen(array, places));
    const int attribute = refined->IsArrayAnAttribute(number);
    if (attribute >= 0)
    {
      result->SetActiveAttribute(array->GetName(), attribute);
    }
  }

  vtkPolyData* Refined;
  vtkPolyData* Own;
  vtkIdType Piece;
  std::vector<vtkIdType> Points; ///< [point of the result] The point of the refined surface.
  std::map<vtkIdType, vtkIdType> OwnPoint; ///< The other way.
  std::vector<vtkIdType> Cells;            ///< Of the refined surface: polygons and then strips.
  vtkIdType CellsBefore;
};

} // namespace

void PieceResults::Put(const MergedPieces& merged, std::size_t piece, vtkPolyData* own) const
{
  vtkPolyData* whole = merged.data;
  const std::vector<vtkIdType>& points = merged.pointOf[piece];
  const bool isRefined = OriginsOf(whole) && this->IsNew(OriginsOf(whole));
  if (isRefined)
  {
    const vtkSmartPointer<vtkPolyData> refined = RefinedPiece(whole, piece, points, own).Make();
    refined->GetFieldData()->PassData(own->GetFieldData());
    own->ShallowCopy(refined);
  }
  else
  {
    const auto add = [&](vtkDataSetAttributes* from, const std::vector<vtkIdType>& places,
                       vtkDataSetAttributes* to)
    {
      for (int i = 0; i < from->GetNumberOfArrays(); ++i)
      {
        if (this->IsNew(from->GetAbstractArray(i)))
        {
          to->AddArray(Chosen(from->GetAbstractArray(i), places));
        }
      }
    };
    add(whole->GetPointData(), points, own->GetPointData());
    add(whole->GetCellData(), PlacesOfCells(whole, piece, own->GetNumberOfCells()),
      own->GetCellData());
  }
  this->AddFields(whole->GetFieldData(), own->GetFieldData());
}

void PieceResults::AddFields(vtkFieldData* whole, vtkFieldData* own) const
{
  for (int i = 0; i < whole->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = whole->GetAbstractArray(i);
    if (this->IsNew(array) && !IsOrigin(array))
    {
      own->AddArray(array);
    }
  }
}

} // namespace Illumination
