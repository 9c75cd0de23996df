// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Messages.h"
#include "OutputData.h"

#include "PhotonTransport/materials/MaterialProperties.h"

#include "vtkSurfaceMaterial.h"

#include "vtkCellData.h"
#include "vtkDataObjectTree.h"
#include "vtkDataObjectTreeIterator.h"
#include "vtkFloatArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPlaneSource.h"
#include "vtkSmartPointer.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <string>
#include <vector>

/// Four cells.
inline vtkSmartPointer<vtkPolyData> Plane()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(2, 2);
  plane->Update();
  return plane->GetOutput();
}

template <typename Array>
void AddCells(vtkPolyData* data, const char* name, int components, std::vector<double> values)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    array->SetComponent(id / components, static_cast<int>(id % components), values[i]);
  }
  data->GetCellData()->AddArray(array);
}

inline double Value(
  vtkPolyData* data, const std::string& array, vtkIdType cell = 0, int component = 0)
{
  auto* values = vtkFloatArray::SafeDownCast(data->GetCellData()->GetArray(array.c_str()));
  return values ? values->GetComponent(cell, component) : -1.0;
}

inline bool HasMaterial(vtkPolyData* data)
{
  using namespace PhotonTransport;
  return std::all_of(MaterialProperties.begin(), MaterialProperties.end(),
    [&](const MaterialProperty& property)
    {
      vtkDataArray* array = data->GetCellData()->GetArray(property.name);
      return vtkFloatArray::SafeDownCast(array) &&
        array->GetNumberOfComponents() == ComponentsOf(property) &&
        array->GetNumberOfTuples() == data->GetNumberOfCells();
    });
}

inline vtkPolyData* Leaf(vtkSurfaceMaterial* filter, unsigned int flatIndex)
{
  auto* tree = vtkDataObjectTree::SafeDownCast(filter->GetOutputDataObject(0));
  auto it = vtk::TakeSmartPointer(tree->NewTreeIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    if (it->GetCurrentFlatIndex() == flatIndex)
    {
      return vtkPolyData::SafeDownCast(it->GetCurrentDataObject());
    }
  }
  return nullptr;
}

/// 0 root { 1 surface, 2 { 3 surface, 4 empty, 5 surface }, 6 surface, 7 grid }
inline vtkSmartPointer<vtkMultiBlockDataSet> MultiBlock()
{
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, Plane());
  inner->SetBlock(2, Plane());
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, Plane());
  blocks->SetBlock(1, inner);
  blocks->SetBlock(2, Plane());
  blocks->SetBlock(3, vtkNew<vtkUnstructuredGrid>());
  return blocks;
}
