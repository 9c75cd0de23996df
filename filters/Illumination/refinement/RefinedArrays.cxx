// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/refinement/RefinedArrays.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <string>

namespace Illumination
{
namespace
{

/// Fills the values of the added points of one array.
class ArrayFiller
{
public:
  ArrayFiller(const RefinementBlock& block, const RefinedPoints& points)
    : Block(block)
    , Points(points)
  {
  }

  /// An array of the block, as long as the refined block's points, with the values of its own.
  vtkSmartPointer<vtkAbstractArray> Begun(vtkAbstractArray* given) const
  {
    auto array = vtk::TakeSmartPointer(given->NewInstance());
    array->SetName(given->GetName());
    array->SetNumberOfComponents(given->GetNumberOfComponents());
    array->CopyComponentNames(given);
    array->SetNumberOfTuples(this->Points.Number());
    array->InsertTuples(0, this->Points.NumberGiven(), 0, given);
    if (given->HasInformation())
    {
      array->CopyInformation(given->GetInformation(), 1);
    }
    return array;
  }

  void FillLinearly(vtkAbstractArray* given, vtkAbstractArray* array) const
  {
    vtkNew<vtkIdList> ids;
    std::array<double, 3> weights{};
    this->ForEach(
      [&](vtkIdType id, const AddedPoint& point)
      {
        ids->Reset();
        for (int i = 0; i < 3; ++i)
        {
          if (point.weights[i] > 0.0) // zero times infinity is not a number
          {
            weights[static_cast<std::size_t>(ids->InsertNextId(
              this->PointOf(point.vertices[static_cast<std::size_t>(i)])))] = point.weights[i];
          }
        }
        array->InterpolateTuple(id, ids, given, weights.data());
      });
  }

  void FillByNearest(vtkAbstractArray* given, vtkAbstractArray* array) const
  {
    this->ForEach([&](vtkIdType id, const AddedPoint& point)
      { array->SetTuple(id, this->PointOf(point.Nearest()), given); });
  }

  void FillGhostFlags(vtkUnsignedCharArray* given, vtkUnsignedCharArray* array) const
  {
    this->ForEach(
      [&](vtkIdType id, const AddedPoint& point)
      {
        int flags = 0xff;
        for (int i = 0; i < 3; ++i)
        {
          if (point.weights[i] > 0.0)
          {
            flags &= given->GetValue(this->PointOf(point.vertices[static_cast<std::size_t>(i)]));
          }
        }
        array->SetValue(id, static_cast<unsigned char>(flags));
      });
  }

  /// Gives interpolated normals unit length. Where they cancel out, the nearest corner's counts;
  /// where a corner's is not finite, there is none: zero.
  void Normalise(vtkDataArray* normals) const
  {
    this->ForEach(
      [&](vtkIdType id, const AddedPoint& point)
      {
        glm::dvec3 normal;
        normals->GetTuple(id, &normal.x);
        const double length = glm::length(normal);
        if (point.isCopy)
        {
          return;
        }
        if (length > 0.0 || !std::isfinite(length))
        {
          normal = std::isfinite(length) ? normal / length : glm::dvec3(0.0);
          normals->SetTuple(id, &normal.x);
        }
        else
        {
          normals->SetTuple(id, normals->GetTuple3(this->PointOf(point.Nearest())));
        }
      });
  }

  vtkIdType PointOf(std::size_t vertex) const
  {
    return this->Block.pointOfVertex[vertex - this->Block.firstVertex];
  }

private:
  template <class Function>
  void ForEach(const Function& f) const
  {
    vtkIdType id = this->Points.NumberGiven();
    for (const AddedPoint& point : this->Points.Added())
    {
      f(id++, point);
    }
  }

  const RefinementBlock& Block;
  const RefinedPoints& Points;
};

bool IsContinuous(vtkAbstractArray* array)
{
  const int type = array->GetDataType();
  const int components = array->GetNumberOfComponents();
  const bool isColour = type == VTK_UNSIGNED_CHAR && (components == 3 || components == 4);
  return type == VTK_FLOAT || type == VTK_DOUBLE || isColour;
}

/// The normals that the curves were found by, at all points of the block.
vtkSmartPointer<vtkDataArray> ComputedNormals(
  const RefinementBlock& block, const RefinedPoints& points, const std::vector<glm::dvec3>& normals)
{
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName("Normals");
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(points.Number());
  array->Fill(0.0);
  for (std::size_t v = block.pointOfVertex.size(); v-- > 0;)
  {
    // A point that was split keeps the first of its normals, which is set last.
    array->SetTuple(block.pointOfVertex[v], &normals[block.firstVertex + v].x);
  }
  vtkIdType id = points.NumberGiven();
  for (const AddedPoint& point : points.Added())
  {
    const glm::dvec3 normal = point.weights.x * normals[point.vertices[0]] +
      point.weights.y * normals[point.vertices[1]] + point.weights.z * normals[point.vertices[2]];
    array->SetTuple(id++, &normal.x);
  }
  return array;
}

} // namespace

void AddPointArrays(const RefinementBlock& block, const RefinedPoints& points,
  const std::vector<glm::dvec3>& normals, vtkPointData* result)
{
  const ArrayFiller filler(block, points);
  vtkPointData* given = block.data->GetPointData();
  for (int i = 0; i < given->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* from = given->GetAbstractArray(i);
    const int attribute = given->IsArrayAnAttribute(i);
    if (attribute == vtkDataSetAttributes::GLOBALIDS)
    {
      continue;
    }
    const vtkSmartPointer<vtkAbstractArray> array = filler.Begun(from);
    const std::string name = from->GetName() ? from->GetName() : "";
    if (name == vtkDataSetAttributes::GhostArrayName() && vtkUnsignedCharArray::SafeDownCast(from))
    {
      filler.FillGhostFlags(
        vtkUnsignedCharArray::SafeDownCast(from), vtkUnsignedCharArray::SafeDownCast(array));
    }
    else if (IsContinuous(from))
    {
      filler.FillLinearly(from, array);
    }
    else
    {
      filler.FillByNearest(from, array);
    }
    if (from == block.givenNormals && IsContinuous(from))
    {
      filler.Normalise(vtkDataArray::SafeDownCast(array));
    }
    const int index = result->AddArray(array);
    if (attribute >= 0)
    {
      result->SetActiveAttribute(index, attribute);
    }
  }
  if (!block.givenNormals)
  {
    const auto computed = ComputedNormals(block, points, normals);
    filler.Normalise(computed);
    result->SetNormals(computed);
  }
}

} // namespace Illumination
