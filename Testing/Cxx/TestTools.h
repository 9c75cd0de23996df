// SPDX-License-Identifier: BSD-3-Clause
#ifndef TestTools_h
#define TestTools_h

#include "vtkIlluminationMap.h"

#include "vtkAbstractArray.h"
#include "vtkCommand.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkVariant.h"

#include <cstring>
#include <iostream>
#include <string>

/// Counts what does not hold and says where; a test returns Failures().
class Checks
{
public:
  void operator()(bool holds, const std::string& what)
  {
    if (!holds)
    {
      std::cerr << "FAILED: " << what << "\n";
      ++this->Count;
    }
  }
  int Failures() const { return this->Count; }

private:
  int Count = 0;
};

/// Counts the errors of what it observes and keeps their text.
class ErrorCounter : public vtkCommand
{
public:
  static ErrorCounter* New() { return new ErrorCounter; }

  void Execute(vtkObject*, unsigned long, void* text) override
  {
    ++this->Count;
    this->Messages += static_cast<const char*>(text);
  }

  int Count = 0;
  std::string Messages;
};

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

#endif
