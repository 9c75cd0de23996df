// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vtkAbstractArray.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVariant.h"

#include <cstring>
#include <string>

/// A number of the output's field data; -1 if there is none of that name.
inline double FieldValue(vtkDataObject* data, const char* name)
{
  vtkAbstractArray* array = data->GetFieldData()->GetAbstractArray(name);
  return array && array->GetNumberOfValues() > 0 ? array->GetVariantValue(0).ToDouble() : -1.0;
}

inline std::string FieldText(vtkDataObject* data, const char* name)
{
  std::string text;
  vtkAbstractArray* array = data->GetFieldData()->GetAbstractArray(name);
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    text += array->GetVariantValue(i).ToString() + "\n";
  }
  return text;
}

inline vtkDataArray* PointArray(vtkPolyData* data, const char* name)
{
  return data->GetPointData()->GetArray(name);
}

/// Same values to the last bit.
inline bool SameValues(vtkDataArray* a, vtkDataArray* b)
{
  if (!a || !b || a->GetNumberOfTuples() != b->GetNumberOfTuples())
  {
    return false;
  }
  for (vtkIdType i = 0; i < a->GetNumberOfTuples(); ++i)
  {
    const double x = a->GetTuple1(i);
    const double y = b->GetTuple1(i);
    if (std::memcmp(&x, &y, sizeof(double)) != 0)
    {
      return false;
    }
  }
  return true;
}
