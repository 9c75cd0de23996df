// SPDX-License-Identifier: BSD-3-Clause
#include "FilterLightTools.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkPlaneSource.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace
{

LightArrays LightOn(vtkPolyData* surface)
{
  LightArrays light;
  vtkPointData* points = surface->GetPointData();
  for (int a = 0; a < points->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = points->GetArray(a);
    const std::string name = array && array->GetName() ? array->GetName() : "";
    if (name.rfind("Illuminance", 0) != 0 && name.rfind("StandardError", 0) != 0)
    {
      continue;
    }
    Values& values = light[name];
    const int components = array->GetNumberOfComponents();
    for (vtkIdType i = 0; i < components * array->GetNumberOfTuples(); ++i)
    {
      values.push_back(array->GetComponent(i / components, static_cast<int>(i % components)));
    }
  }
  return light;
}

} // namespace

double RootMeanSquare(const Values& values)
{
  double squares = 0.0;
  for (const double value : values)
  {
    squares += value * value;
  }
  return std::sqrt(squares / static_cast<double>(values.size()));
}

double RelativeNoise(const LightArrays& light)
{
  return RootMeanSquare(light.at("StandardError")) / RootMeanSquare(light.at("Illuminance"));
}

vtkSmartPointer<vtkPolyData> Patch(
  const Point& corner, const Point& u, const Point& v, int m, int n)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(corner.x, corner.y, corner.z);
  plane->SetPoint1(corner.x + u.x, corner.y + u.y, corner.z + u.z);
  plane->SetPoint2(corner.x + v.x, corner.y + v.y, corner.z + v.z);
  plane->SetResolution(m, n);
  plane->Update();
  return plane->GetOutput();
}

void SetCells(vtkPolyData* data, const char* array, double value)
{
  vtkNew<vtkDoubleArray> values;
  values->SetName(array);
  values->SetNumberOfTuples(data->GetNumberOfCells());
  values->Fill(value);
  data->GetCellData()->AddArray(values);
}

vtkSmartPointer<vtkMultiBlockDataSet> Blocks(
  const std::vector<vtkSmartPointer<vtkPolyData>>& blocks)
{
  auto all = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (const vtkSmartPointer<vtkPolyData>& block : blocks)
  {
    all->SetBlock(all->GetNumberOfBlocks(), block);
  }
  return all;
}

void FilterLightTest::SetUp()
{
  this->FilterTest::SetUp();
  this->Filter->SetReflectance(0.0);
  this->Filter->SetParallelIlluminance(1000.0);
  this->Filter->SetLampDirection(0.2, 0.1, -1.0);
  this->Filter->SetPhotons(100000);
}

std::vector<LightArrays> FilterLightTest::Light(vtkDataObject* input, int warnings)
{
  this->Filter->SetInputDataObject(input);
  this->Run();
  EXPECT_EQ(this->Messages->Errors, 0) << this->Messages->Text;
  EXPECT_EQ(this->Messages->Warnings, warnings) << this->Messages->Text;
  std::vector<LightArrays> light;
  vtkDataObject* output = this->Filter->GetOutputDataObject(0);
  if (auto* blocks = vtkMultiBlockDataSet::SafeDownCast(output))
  {
    for (unsigned b = 0; b < blocks->GetNumberOfBlocks(); ++b)
    {
      light.push_back(LightOn(vtkPolyData::SafeDownCast(blocks->GetBlock(b))));
    }
    return light;
  }
  light.push_back(LightOn(vtkPolyData::SafeDownCast(output)));
  return light;
}

double FilterLightTest::FieldValue(const char* name)
{
  return ::FieldValue(this->Filter->GetOutputDataObject(0), name);
}

void FilterLightTest::ExpectLightOf(
  const LightArrays& alone, const LightArrays& light, double share)
{
  ++this->Compared;
  ASSERT_EQ(alone.size(), light.size());
  for (const auto& [name, values] : alone)
  {
    const Values& here = light.at(name);
    ASSERT_EQ(here.size() % values.size(), 0u) << name;
    double most = 0.0;
    for (std::size_t i = 0; i < here.size(); ++i)
    {
      most = std::max(most, std::fabs(here[i] - values[i % values.size()]));
    }
    const double size = RootMeanSquare(values);
    EXPECT_LE(most, share * size) << name;
    this->LargestShare = std::max(this->LargestShare, size > 0.0 ? most / size : 0.0);
  }
}
