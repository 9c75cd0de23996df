// SPDX-License-Identifier: BSD-3-Clause
#include "FilterTools.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"

#include <cmath>

vtkSmartPointer<vtkPolyData> SmallSphere()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->Update();
  return sphere->GetOutput();
}

bool AllFinite(vtkPolyData* data)
{
  for (const char* name :
    { "Illuminance", "IlluminanceDirect", "IlluminanceIndirect", "StandardError", "RelativeError" })
  {
    vtkDataArray* array = data->GetPointData()->GetArray(name);
    if (!array || array->GetNumberOfTuples() != data->GetNumberOfPoints())
    {
      return false;
    }
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
    {
      if (!std::isfinite(array->GetTuple1(i)))
      {
        return false;
      }
    }
  }
  return true;
}

void FilterTest::SetUp()
{
  this->Surface = SmallSphere();
  this->Filter->SetInputData(this->Surface);
  this->Filter->SetPhotons(4096);
}

void FilterTest::Measured(const std::string& what)
{
  this->WhatWasMeasured += (this->WhatWasMeasured.empty() ? "" : "; ") + what;
}

void FilterTest::TearDown()
{
  if (this->WhatWasMeasured.empty())
  {
    if (this->Refusals > 0)
    {
      this->Measured(std::to_string(this->Refusals) + " refused with one error each");
    }
    this->Measured(this->Maps > 0 ? std::to_string(this->Maps) + " maps as expected" : "passes");
  }
  this->RecordProperty("protects", this->Protects);
  this->RecordProperty("measured", this->WhatWasMeasured);
}

void FilterTest::Run()
{
  this->Messages->Clear();
  this->Filter->Modified();
  this->Filter->Update();
}

void FilterTest::ExpectError(const std::string& words)
{
  SCOPED_TRACE(words);
  ++this->Refusals;
  vtkDataObject* input = this->Filter->GetInputDataObject(0, 0);
  this->Run();
  EXPECT_EQ(this->Messages->Errors, 1) << this->Messages->Text;
  EXPECT_EQ(this->Messages->Warnings, 0) << this->Messages->Text;
  EXPECT_TRUE(Holds(this->Messages->Text, words));

  vtkDataObject* output = this->Filter->GetOutputDataObject(0);
  ASSERT_NE(output, nullptr);
  EXPECT_EQ(output->GetDataObjectType(), input->GetDataObjectType());
  if (auto* given = vtkPolyData::SafeDownCast(input))
  {
    auto* passed = vtkPolyData::SafeDownCast(output);
    EXPECT_EQ(passed->GetPoints(), given->GetPoints());
    EXPECT_EQ(passed->GetPolys(), given->GetPolys());
    EXPECT_EQ(
      passed->GetPointData()->GetNumberOfArrays(), given->GetPointData()->GetNumberOfArrays());
  }
}

void FilterTest::ExpectNoOtherWarning()
{
  const std::string& text = this->Messages->Text;
  const bool missing = text.find("left the scene without meeting it") != std::string::npos ||
    text.find(" fell on ") != std::string::npos || text.find("met no facet") != std::string::npos;
  EXPECT_LE(this->Messages->Warnings, this->LightMayBeMissing && missing ? 1 : 0) << text;
}

void FilterTest::ExpectMap()
{
  ++this->Maps;
  this->Run();
  EXPECT_EQ(this->Messages->Errors, 0) << this->Messages->Text;
  this->ExpectNoOtherWarning();
  EXPECT_TRUE(AllFinite(this->Filter->GetOutput()));
}

vtkDataArray* FilterTest::OutputArray(const char* name) const
{
  return PointArray(this->Filter->GetOutput(), name);
}

std::string FilterTest::Notes() const
{
  return FieldText(this->Filter->GetOutputDataObject(0), "Notes");
}
