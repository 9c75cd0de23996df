// SPDX-License-Identifier: BSD-3-Clause
// Bad input gives one error that says what, where and which value; the input passes through and the
// filter works again once the input is good.
#include "Messages.h"
#include "OutputData.h"

#include "vtkIlluminationMap.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkSphereSource.h"
#include "vtkStringArray.h"

#include <cmath>
#include <functional>

namespace
{

class ErrorCase
{
public:
  ErrorCase()
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->Update();
    this->Surface->DeepCopy(sphere->GetOutput());
    this->Filter->SetInputData(this->Surface);
    this->Filter->SetPhotons(4096);
  }

  /// A cell array of the surface, all values `value`.
  vtkFloatArray* AddCellArray(const char* name, int components, float value)
  {
    vtkNew<vtkFloatArray> array;
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(this->Surface->GetNumberOfCells());
    array->Fill(value);
    this->Surface->GetCellData()->AddArray(array);
    return vtkFloatArray::SafeDownCast(this->Surface->GetCellData()->GetArray(name));
  }

  void Expect(const std::string& words)
  {
    this->Run();
    EXPECT_EQ(this->Messages->Errors, 1) << "where one was to say: " << words;
    EXPECT_TRUE(Holds(this->Messages->Text, words));
    vtkPolyData* output = this->Filter->GetOutput();
    EXPECT_TRUE(output->GetNumberOfPoints() == this->Surface->GetNumberOfPoints() &&
      output->GetNumberOfCells() == this->Surface->GetNumberOfCells())
      << "the input passes through after: " << words;
    EXPECT_FALSE(PointArray(output, "Illuminance")) << "no map after: " << words;
  }

  void ExpectGood()
  {
    this->Run();
    EXPECT_EQ(this->Messages->Errors, 0) << this->Messages->Text;
    EXPECT_NE(PointArray(this->Filter->GetOutput(), "Illuminance"), nullptr) << "a map";
  }

  vtkNew<vtkPolyData> Surface;
  vtkNew<vtkIlluminationMap> Filter;

private:
  void Run()
  {
    this->Messages->Clear();
    this->Filter->Modified();
    this->Filter->Update();
  }

  CaughtMessages Messages;
};

} // namespace

TEST(IlluminationMapErrors, PropertiesOutOfRangeAreRefused)
{
  ErrorCase c;
  c.ExpectGood();
  c.Filter->SetReflectance(1.5);
  c.Expect("Reflectance is 1.5");
  c.Filter->SetReflectance(0.5);
  c.Filter->SetPhotons(0);
  c.Expect("number of photons is 0");
  c.Filter->SetPhotons(4096);
  c.Filter->SetMetresPerUnit(0.0);
  c.Expect("metres per unit is 0");
  c.Filter->SetMetresPerUnit(1.0);
  c.Filter->SetLampDirection(0.0, 0.0, 0.0);
  c.Expect("lamp direction (0, 0, 0)");
  c.Filter->SetLampDirection(0.0, 0.0, -1.0);
  c.Filter->SetLampType(vtkIlluminationMap::EMITTING_FACETS);
  c.Expect("none is named");
  c.Filter->SetLampType(vtkIlluminationMap::PARALLEL);
  c.ExpectGood();
}

TEST(IlluminationMapErrors, ArraysThatDoNotFitAreRefused)
{
  ErrorCase c;
  c.Filter->SetReflectanceArray("nowhere");
  c.Expect("there is no cell array 'nowhere'");
  c.Filter->SetReflectanceArray("Normals");
  c.Expect("there is a point array of that name");
  c.AddCellArray("two", 2, 0.5f);
  c.Filter->SetReflectanceArray("two");
  c.Expect("'two' has 2 components");
  c.AddCellArray("rho", 1, 0.5f)->SetValue(17, 1.25f);
  c.Filter->SetReflectanceArray("rho");
  c.Expect("cell 17: DiffuseReflectance is 1.25; it must be within [0, 1]; DiffuseReflectance is "
           "the array 'rho'");
  c.AddCellArray("colour", 3, 0.5f)->SetComponent(5, 2, std::nan(""));
  c.Filter->SetReflectanceArray("colour");
  c.Expect("cell 5: DiffuseReflectance (blue) is nan");
  vtkNew<vtkStringArray> words;
  words->SetName("words");
  words->SetNumberOfValues(c.Surface->GetNumberOfCells());
  c.Surface->GetCellData()->AddArray(words);
  c.Filter->SetReflectanceArray("words");
  c.Expect("'words' is a vtkStringArray, not numbers");
  c.AddCellArray("short", 1, 0.5f)->SetNumberOfTuples(3);
  c.Filter->SetReflectanceArray("short");
  c.Expect("'short' has 3 values for");
  c.Filter->SetReflectanceArray("");
  c.Filter->SetLampType(vtkIlluminationMap::EMITTING_FACETS);
  c.AddCellArray("exitance", 1, 0.0f)->SetValue(2, -1.0f);
  c.Filter->SetExitanceArray("exitance");
  c.Expect("cell 2: exitance -1");
  c.AddCellArray("exitance", 1, 0.0f);
  c.Expect("no facet has an exitance above 0");
  c.AddCellArray("exitance", 1, 50.0f);
  c.ExpectGood();
}

TEST(IlluminationMapErrors, GeometryThatIsNoneIsRefused)
{
  ErrorCase c;
  double point[3];
  c.Surface->GetPoint(9, point);
  c.Surface->GetPoints()->SetPoint(9, point[0], std::nan(""), point[2]);
  c.Expect("point 9: its coordinates");
  c.Surface->GetPoints()->SetPoint(9, point);
  c.ExpectGood();

  vtkNew<vtkCellArray> polys;
  polys->DeepCopy(c.Surface->GetPolys());
  const vtkIdType bad[3] = { 0, 1, 1000000 };
  polys->InsertNextCell(3, bad);
  const vtkIdType cell = polys->GetNumberOfCells() - 1;
  c.Surface->SetPolys(polys);
  c.Expect("cell " + std::to_string(cell) + " uses point 1000000");

  vtkNew<vtkCellArray> none;
  c.Surface->SetPolys(none);
  c.Expect("no polygons or triangle strips");
  c.Surface->Initialize();
  c.Expect("no polygons or triangle strips");
}
