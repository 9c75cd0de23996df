// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Messages.h"
#include "OutputData.h"

#include "Illumination/luminaires/LuminaireFields.h"
#include "Illumination/pipeline/InputError.h"

#include "vtkLuminaireSource.h"

#include "vtkNew.h"
#include "vtkSmartPointer.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <functional>
#include <string>

using namespace Illumination;

inline vtkSmartPointer<vtkLuminaireSource> Source(int type)
{
  auto source = vtkSmartPointer<vtkLuminaireSource>::New();
  source->SetType(type);
  return source;
}

inline std::string PhotometricFile(const char* name)
{
  return std::string(ILLUMINATION_TEST_DATA) + "/photometry/" + name;
}

/// The data after the transform that the function sets up.
inline vtkSmartPointer<vtkPolyData> Transformed(vtkPolyData* data,
  const std::function<void(vtkTransform*)>& setUp, int precision = vtkAlgorithm::DEFAULT_PRECISION)
{
  vtkNew<vtkTransform> transform;
  setUp(transform);
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetInputData(data);
  filter->SetTransform(transform);
  filter->SetOutputPointsPrecision(precision);
  filter->Update();
  return filter->GetOutput();
}

/// Expects that the data are refused with these words.
inline void ExpectRefused(vtkPolyData* data, const std::string& words)
{
  std::string error = "nothing refused";
  try
  {
    ReadLuminaire(data);
  }
  catch (const InputError& refusal)
  {
    error = refusal.what();
  }
  EXPECT_TRUE(Holds(error, words));
}
