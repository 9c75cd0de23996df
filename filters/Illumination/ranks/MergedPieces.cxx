// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/ranks/MergedPieces.h"

#include "Illumination/pipeline/PieceNames.h"
#include "Illumination/ranks/MergedArrays.h"
#include "Illumination/ranks/SharedPoints.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <utility>

namespace Illumination
{
namespace
{

using Surfaces = std::vector<vtkPolyData*>;

vtkIdType CellsOf(vtkPolyData* data)
{
  return data->GetNumberOfPolys() + data->GetNumberOfStrips();
}

/// [piece] Where its polygons and strips go.
std::vector<TuplePlaces> MergeCells(
  const Surfaces& surfaces, const std::vector<std::vector<vtkIdType>>& pointOf, vtkPolyData* result)
{
  std::vector<TuplePlaces> places(surfaces.size());
  vtkIdType number = 0;
  for (const bool strips : { false, true })
  {
    vtkNew<vtkCellArray> merged;
    for (std::size_t piece = 0; piece < surfaces.size(); ++piece)
    {
      vtkPolyData* data = surfaces[piece];
      vtkIdType cell = data->GetNumberOfVerts() + data->GetNumberOfLines() +
        (strips ? data->GetNumberOfPolys() : 0);
      auto it =
        vtk::TakeSmartPointer((strips ? data->GetStrips() : data->GetPolys())->NewIterator());
      for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell(), ++cell)
      {
        vtkIdType size = 0;
        const vtkIdType* ids = nullptr;
        it->GetCurrentCell(size, ids);
        merged->InsertNextCell(static_cast<int>(size));
        for (vtkIdType i = 0; i < size; ++i)
        {
          merged->InsertCellPoint(pointOf[piece][static_cast<std::size_t>(ids[i])]);
        }
        places[piece].from.push_back(cell);
        places[piece].to.push_back(number++);
      }
    }
    strips ? result->SetStrips(merged) : result->SetPolys(merged);
  }
  return places;
}

vtkSmartPointer<vtkPoints> MergePoints(
  const Surfaces& surfaces, const std::vector<PointOfPiece>& origins)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  const bool single = std::all_of(surfaces.begin(), surfaces.end(),
    [](vtkPolyData* data)
    { return data->GetNumberOfPoints() == 0 || data->GetPoints()->GetDataType() == VTK_FLOAT; });
  points->SetDataType(single ? VTK_FLOAT : VTK_DOUBLE);
  points->SetNumberOfPoints(static_cast<vtkIdType>(origins.size()));
  for (std::size_t p = 0; p < origins.size(); ++p)
  {
    double place[3];
    surfaces[origins[p].piece]->GetPoint(origins[p].point, place);
    points->SetPoint(static_cast<vtkIdType>(p), place);
  }
  return points;
}

vtkUnsignedCharArray* GhostFlags(vtkDataSetAttributes* arrays)
{
  return vtkUnsignedCharArray::SafeDownCast(
    arrays->GetAbstractArray(vtkDataSetAttributes::GhostArrayName()));
}

vtkSmartPointer<vtkUnsignedCharArray> NewFlags(vtkIdType number, unsigned char value)
{
  auto flags = vtkSmartPointer<vtkUnsignedCharArray>::New();
  flags->SetName(vtkDataSetAttributes::GhostArrayName());
  flags->SetNumberOfTuples(number);
  flags->FillValue(value);
  return flags;
}

void MergeCellGhosts(
  const Surfaces& surfaces, const std::vector<TuplePlaces>& places, vtkPolyData* result)
{
  if (std::none_of(surfaces.begin(), surfaces.end(),
        [](vtkPolyData* data) { return GhostFlags(data->GetCellData()); }))
  {
    return;
  }
  const auto flags = NewFlags(CellsOf(result), 0);
  for (std::size_t piece = 0; piece < surfaces.size(); ++piece)
  {
    vtkUnsignedCharArray* own = GhostFlags(surfaces[piece]->GetCellData());
    for (std::size_t i = 0; own && i < places[piece].from.size(); ++i)
    {
      flags->SetValue(places[piece].to[i], own->GetValue(places[piece].from[i]));
    }
  }
  result->GetCellData()->AddArray(flags);
}

/// A merged point is a ghost if all its points are.
void MergePointGhosts(
  const Surfaces& surfaces, const std::vector<std::vector<vtkIdType>>& pointOf, vtkPolyData* result)
{
  if (std::none_of(surfaces.begin(), surfaces.end(),
        [](vtkPolyData* data) { return GhostFlags(data->GetPointData()); }))
  {
    return;
  }
  const auto flags = NewFlags(result->GetNumberOfPoints(), 0xff);
  for (std::size_t piece = 0; piece < surfaces.size(); ++piece)
  {
    vtkUnsignedCharArray* own = GhostFlags(surfaces[piece]->GetPointData());
    for (std::size_t p = 0; p < pointOf[piece].size(); ++p)
    {
      const unsigned char flag = own ? own->GetValue(static_cast<vtkIdType>(p)) : 0;
      flags->SetValue(
        pointOf[piece][p], static_cast<unsigned char>(flags->GetValue(pointOf[piece][p]) & flag));
    }
  }
  result->GetPointData()->AddArray(flags);
}

vtkSmartPointer<vtkIdTypeArray> NewOrigins(const char* name)
{
  auto array = vtkSmartPointer<vtkIdTypeArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(2);
  return array;
}

void AddOrigins(const std::vector<Piece>& pieces, const std::vector<TuplePlaces>& places,
  const std::vector<PointOfPiece>& points, vtkPolyData* result)
{
  const auto ofCells = NewOrigins(CellOrigins);
  ofCells->SetNumberOfTuples(CellsOf(result));
  vtkNew<vtkStringArray> names;
  names->SetName(PieceNames);
  for (std::size_t piece = 0; piece < pieces.size(); ++piece)
  {
    names->InsertNextValue(NameOf(pieces[piece]));
    for (std::size_t i = 0; i < places[piece].from.size(); ++i)
    {
      ofCells->SetTypedComponent(places[piece].to[i], 0, static_cast<vtkIdType>(piece));
      ofCells->SetTypedComponent(places[piece].to[i], 1, places[piece].from[i]);
    }
  }
  const auto ofPoints = NewOrigins(PointOrigins);
  for (const PointOfPiece& point : points)
  {
    ofPoints->InsertNextTuple2(static_cast<double>(point.piece), static_cast<double>(point.point));
  }
  vtkNew<vtkStringArray> block;
  block->SetName(BlockName);
  block->InsertNextValue(pieces.front().name);
  result->GetCellData()->AddArray(ofCells);
  result->GetFieldData()->AddArray(ofPoints);
  result->GetFieldData()->AddArray(names);
  result->GetFieldData()->AddArray(block);
}

/// [piece] Where those of its points go that no piece before it has.
std::vector<TuplePlaces> PlacesOfPoints(
  const std::vector<PointOfPiece>& origins, std::size_t pieces)
{
  std::vector<TuplePlaces> places(pieces);
  for (std::size_t number = 0; number < origins.size(); ++number)
  {
    places[origins[number].piece].from.push_back(origins[number].point);
    places[origins[number].piece].to.push_back(static_cast<vtkIdType>(number));
  }
  return places;
}

} // namespace

MergedPieces Merge(const std::vector<Piece>& pieces)
{
  Surfaces surfaces;
  for (const Piece& piece : pieces)
  {
    surfaces.push_back(vtkPolyData::SafeDownCast(piece.data));
  }
  MergedPieces merged;
  merged.data = vtkSmartPointer<vtkPolyData>::New();
  SharedPoints shared = FindSharedPoints(surfaces);
  merged.data->SetPoints(MergePoints(surfaces, shared.origins));
  const std::vector<TuplePlaces> points = PlacesOfPoints(shared.origins, pieces.size());
  const std::vector<TuplePlaces> cells = MergeCells(surfaces, shared.numbers, merged.data);
  MergedArrays pointArrays(
    pieces, merged.data->GetPointData(), merged.data->GetNumberOfPoints(), "point");
  MergedArrays cellArrays(pieces, merged.data->GetCellData(), CellsOf(merged.data), "cell");
  for (std::size_t piece = 0; piece < surfaces.size(); ++piece)
  {
    pointArrays.Add(piece, surfaces[piece]->GetPointData(), points[piece]);
    cellArrays.Add(piece, surfaces[piece]->GetCellData(), cells[piece]);
  }
  MergePointGhosts(surfaces, shared.numbers, merged.data);
  MergeCellGhosts(surfaces, cells, merged.data);
  for (vtkPolyData* surface : surfaces)
  {
    merged.data->GetFieldData()->PassData(surface->GetFieldData());
  }
  AddOrigins(pieces, cells, shared.origins, merged.data);
  merged.pointOf = std::move(shared.numbers);
  return merged;
}

} // namespace Illumination
