// SPDX-License-Identifier: BSD-3-Clause
// Puts numbers and text into VTK's arrays.
#ifndef FieldArrays_h
#define FieldArrays_h

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkStringArray.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace Illumination
{

template <typename Array, typename Value>
void AddNumbers(vtkFieldData* data, const char* name, const std::vector<Value>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  data->AddArray(array);
}

inline void AddArray(vtkFieldData* data, const char* name, const std::vector<double>& values)
{
  AddNumbers<vtkDoubleArray>(data, name, values);
}

inline void AddArray(vtkFieldData* data, const char* name, const std::vector<float>& values)
{
  AddNumbers<vtkFloatArray>(data, name, values);
}

inline void AddArray(vtkFieldData* data, const char* name, const std::vector<std::uint64_t>& values)
{
  AddNumbers<vtkIdTypeArray>(data, name, values);
}

/// Each number of a tuple becomes a component.
template <std::size_t Size>
void AddArray(
  vtkFieldData* data, const char* name, const std::vector<std::array<double, Size>>& tuples)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(Size));
  array->SetNumberOfTuples(static_cast<vtkIdType>(tuples.size()));
  for (std::size_t i = 0; i < tuples.size(); ++i)
  {
    array->SetTypedTuple(static_cast<vtkIdType>(i), tuples[i].data());
  }
  data->AddArray(array);
}

inline void AddArray(vtkFieldData* data, const char* name, const std::vector<std::string>& lines)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& line : lines)
  {
    array->InsertNextValue(line);
  }
  data->AddArray(array);
}

} // namespace Illumination

#endif
