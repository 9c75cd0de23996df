// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/ranks/SharedPoints.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace Illumination
{
namespace
{

using Surfaces = std::vector<vtkPolyData*>;

/// A hash of numbers (Fowler, Noll and Vo, FNV-1a, by words).
class Hash
{
public:
  void Add(double value)
  {
    const double withoutSign = value + 0.0; // -0 is 0
    std::uint64_t bits = 0;
    std::memcpy(&bits, &withoutSign, sizeof(bits));
    this->Add(bits);
  }
  void Add(std::uint64_t bits)
  {
    this->Value = (this->Value ^ bits) * 0x100000001b3;
    this->Value ^= this->Value >> 29; // high bits count, too
  }
  std::uint64_t Value = 0xcbf29ce484222325;
};

bool IsReal(vtkDataArray* array)
{
  return array && (array->GetDataType() == VTK_FLOAT || array->GetDataType() == VTK_DOUBLE);
}

/// A point, and what it must have in common with one that it is merged with.
struct KeyedPoint : PointOfPiece
{
  std::uint64_t key;
};

/// The points that polygons and strips of a piece use.
std::vector<bool> UsedPoints(vtkPolyData* data)
{
  std::vector<bool> used(static_cast<std::size_t>(data->GetNumberOfPoints()), false);
  for (vtkCellArray* cells : { data->GetPolys(), data->GetStrips() })
  {
    auto it = vtk::TakeSmartPointer(cells->NewIterator());
    for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      it->GetCurrentCell(size, ids);
      for (vtkIdType i = 0; i < size; ++i)
      {
        used[static_cast<std::size_t>(ids[i])] = true;
      }
    }
  }
  return used;
}

std::vector<KeyedPoint> KeyedPoints(const Surfaces& surfaces, bool byIds)
{
  std::vector<KeyedPoint> points;
  for (std::size_t piece = 0; piece < surfaces.size(); ++piece)
  {
    vtkPolyData* data = surfaces[piece];
    const std::vector<bool> used = UsedPoints(data);
    vtkPointData* arrays = data->GetPointData();
    for (vtkIdType p = 0; p < data->GetNumberOfPoints(); ++p)
    {
      if (!used[static_cast<std::size_t>(p)])
      {
        continue;
      }
      Hash key;
      if (byIds)
      {
        key.Add(static_cast<std::uint64_t>(arrays->GetGlobalIds()->GetTuple1(p)));
      }
      double place[3];
      data->GetPoint(p, place);
      std::for_each(place, place + 3, [&](double x) { key.Add(x); });
      for (int i = 0; i < arrays->GetNumberOfArrays() && !byIds; ++i)
      {
        vtkDataArray* array = arrays->GetArray(i);
        for (int c = 0; IsReal(array) && c < array->GetNumberOfComponents(); ++c)
        {
          key.Add(array->GetComponent(p, c));
        }
      }
      points.push_back({ { piece, p }, key.Value });
    }
  }
  std::sort(points.begin(), points.end(),
    [](const KeyedPoint& a, const KeyedPoint& b)
    {
      return a.key != b.key ? a.key < b.key
                            : (a.piece != b.piece ? a.piece < b.piece : a.point < b.point);
    });
  return points;
}

/// Whether no piece has two of the points, and all are in one place, though keys are only hashes.
/// @param first, last Sorted by piece.
template <typename Iterator>
bool AreOfDifferentPieces(const Surfaces& surfaces, Iterator first, Iterator last)
{
  return std::adjacent_find(first, last,
           [&](const KeyedPoint& a, const KeyedPoint& b)
           {
             double placeA[3], placeB[3];
             surfaces[a.piece]->GetPoint(a.point, placeA);
             surfaces[b.piece]->GetPoint(b.point, placeB);
             return a.piece == b.piece || !std::equal(placeA, placeA + 3, placeB);
           }) == last;
}

/// [piece][point] The first of the points that it is merged with.
std::vector<std::vector<PointOfPiece>> FirstPoints(const Surfaces& surfaces)
{
  const bool byIds = std::all_of(surfaces.begin(), surfaces.end(),
    [](vtkPolyData* data)
    { return data->GetNumberOfPoints() == 0 || data->GetPointData()->GetGlobalIds(); });
  std::vector<std::vector<PointOfPiece>> ofFirst; // [piece][point] The point it is merged with.
  for (std::size_t piece = 0; piece < surfaces.size(); ++piece)
  {
    ofFirst.emplace_back();
    for (vtkIdType p = 0; p < surfaces[piece]->GetNumberOfPoints(); ++p)
    {
      ofFirst.back().push_back({ piece, p });
    }
  }
  const std::vector<KeyedPoint> points = KeyedPoints(surfaces, byIds);
  for (auto first = points.begin(); first != points.end();)
  {
    const auto last = std::find_if(
      first, points.end(), [&](const KeyedPoint& point) { return point.key != first->key; });
    if (byIds || AreOfDifferentPieces(surfaces, first, last))
    {
      std::for_each(first, last,
        [&](const KeyedPoint& point)
        { ofFirst[point.piece][static_cast<std::size_t>(point.point)] = *first; });
    }
    first = last;
  }
  return ofFirst;
}

} // namespace

SharedPoints FindSharedPoints(const std::vector<vtkPolyData*>& surfaces)
{
  SharedPoints shared;
  // The first one of a point comes first.
  for (const std::vector<PointOfPiece>& ofPiece : FirstPoints(surfaces))
  {
    shared.numbers.emplace_back(ofPiece.size(), -1);
    for (std::size_t p = 0; p < ofPiece.size(); ++p)
    {
      const PointOfPiece& first = ofPiece[p];
      vtkIdType& number = shared.numbers[first.piece][static_cast<std::size_t>(first.point)];
      if (number < 0)
      {
        number = static_cast<vtkIdType>(shared.origins.size());
        shared.origins.push_back(first);
      }
      shared.numbers.back()[p] = number;
    }
  }
  return shared;
}

} // namespace Illumination
