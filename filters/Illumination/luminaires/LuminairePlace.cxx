// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/luminaires/LuminairePlace.h"

#include "Illumination/luminaires/GlyphMotion.h"
#include "Illumination/pipeline/FieldArrays.h"
#include "Illumination/pipeline/FieldValues.h"
#include "Illumination/pipeline/InputError.h"
#include "Illumination/surface/InputChecks.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkVariant.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace Illumination
{
namespace
{

using Points = std::vector<glm::dvec3>;

constexpr const char* PointArray = "LuminairePoint";
constexpr const char* GlyphArray = "LuminaireGlyph";
constexpr const char* Advice =
  "; Group Datasets puts several luminaires together, and Append Geometry does not";
/// Filters may cut bent quadrilaterals along the other diagonal, which changes their area by less.
constexpr double MeasureTolerance = 0.01;

Points PointsOf(vtkPolyData* data)
{
  Points points(static_cast<std::size_t>(data->GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    data->GetPoint(static_cast<vtkIdType>(i), &points[i].x);
  }
  return points;
}

/// A number that tells luminaires apart if they differ in anything. It is whole and fits a float.
double KeyOf(vtkPolyData* glyph, const Points& points)
{
  std::string text;
  vtkFieldData* fields = glyph->GetFieldData();
  for (int a = 0; a < fields->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* array = fields->GetAbstractArray(a);
    for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
    {
      text += array->GetVariantValue(i).ToString() + '|';
    }
  }
  for (const glm::dvec3& point : points)
  {
    text.append(reinterpret_cast<const char*>(&point.x), sizeof(point));
  }
  return static_cast<double>(std::hash<std::string>()(text) % (1u << 24));
}

struct Measure
{
  double area = 0.0;
  double length = 0.0;
};

/// Area of the polygons and strips and length of the lines, with these points.
Measure MeasureOf(vtkPolyData* data, const Points& points)
{
  Measure measure;
  const auto at = [&](vtkIdType id) { return points[static_cast<std::size_t>(id)]; };
  const auto area = [&](vtkIdType a, vtkIdType b, vtkIdType c)
  { return 0.5 * glm::length(glm::cross(at(b) - at(a), at(c) - at(a))); };
  const auto forEachCell = [](vtkCellArray* cells, const auto& add)
  {
    auto it = vtk::TakeSmartPointer(cells->NewIterator());
    for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
    {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      it->GetCurrentCell(size, ids);
      for (vtkIdType i = 2; i < size; ++i)
      {
        add(ids, i);
      }
    }
  };
  forEachCell(data->GetPolys(),
    [&](const vtkIdType* ids, vtkIdType i) { measure.area += area(ids[0], ids[i - 1], ids[i]); });
  forEachCell(data->GetStrips(),
    [&](const vtkIdType* ids, vtkIdType i)
    { measure.area += area(ids[i - 2], ids[i - 1], ids[i]); });
  auto it = vtk::TakeSmartPointer(data->GetLines()->NewIterator());
  for (it->GoToFirstCell(); !it->IsDoneWithTraversal(); it->GoToNextCell())
  {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    it->GetCurrentCell(size, ids);
    for (vtkIdType i = 1; i < size; ++i)
    {
      measure.length += glm::distance(at(ids[i - 1]), at(ids[i]));
    }
  }
  return measure;
}

/// Where each point was, from its array.
Points Remembered(vtkPolyData* glyph, double key)
{
  auto* array = vtkDataArray::SafeDownCast(glyph->GetPointData()->GetAbstractArray(PointArray));
  if (!array || array->GetNumberOfComponents() != 4 ||
    array->GetNumberOfTuples() != glyph->GetNumberOfPoints())
  {
    throw InputError(std::string("it lost the point array '") + PointArray +
      "', which says where its points were, in a filter that does not keep it or where it was "
      "joined with a surface; connect the luminaire before that filter" +
      Advice);
  }
  Points points;
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    std::array<double, 4> tuple{};
    array->GetTuple(i, tuple.data());
    if (!(std::fabs(tuple[3] - key) < 0.5))
    {
      throw InputError(std::string("its geometry holds points of another luminaire, whose "
                                   "description is lost") +
        Advice);
    }
    points.emplace_back(tuple[0], tuple[1], tuple[2]);
  }
  return points;
}

void RequireTheWhole(double found, double whole)
{
  if (found > whole * (1.0 + MeasureTolerance))
  {
    throw InputError(
      std::string("its geometry has grown, as if it were there more than once") + Advice);
  }
  if (!(found >= whole * (1.0 - MeasureTolerance)))
  {
    throw InputError("parts of its geometry were cut away or replaced, so it no longer shows what "
                     "shines; connect the luminaire before that filter");
  }
}

} // namespace

void RememberPlace(vtkPolyData* glyph)
{
  const Points points = PointsOf(glyph);
  const double key = KeyOf(glyph, points);
  const Measure measure = MeasureOf(glyph, points);
  std::vector<std::array<double, 4>> tuples;
  for (const glm::dvec3& point : points)
  {
    tuples.push_back({ point.x, point.y, point.z, key });
  }
  AddArray(glyph->GetPointData(), PointArray, tuples);
  AddArray(
    glyph->GetFieldData(), GlyphArray, std::vector<double>{ key, measure.area, measure.length });
}

PhotonTransport::Similarity MotionOf(vtkPolyData* glyph)
{
  if (!glyph->GetFieldData()->HasArray(GlyphArray) && !HasLuminairePoints(glyph))
  {
    return {};
  }
  glm::dvec3 wanted; // key, area, length
  FieldReader reader(glyph->GetFieldData());
  reader(GlyphArray, wanted);
  RequireValidCells(glyph, "");
  const Points was = Remembered(glyph, wanted.x);
  const Measure found = MeasureOf(glyph, was);
  RequireTheWhole(found.area, wanted.y);
  RequireTheWhole(found.length, wanted.z);
  return FindMotion(was, PointsOf(glyph));
}

bool HasLuminairePoints(vtkPolyData* data)
{
  return data->GetPointData()->HasArray(PointArray) != 0;
}

} // namespace Illumination
