// SPDX-License-Identifier: BSD-3-Clause
// Input that is wrong: one clear error each, the input passes through, and the pipeline works again
// once it is right.
#include "FilterTools.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkStringArray.h"
#include "vtkTypeInt64Array.h"

#include <limits>

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NoNumber = std::numeric_limits<double>::quiet_NaN();

class FilterInput : public FilterTest
{
protected:
  FilterInput()
    : FilterTest(
        "input that is empty, contradicts itself or is no number: a crash, or a silent guess")
  {
  }

  /// The sphere again, and with it a map.
  void ExpectRecovery()
  {
    this->Filter->SetInputData(SmallSphere());
    this->ExpectMap();
    this->Filter->SetInputData(this->Surface);
  }

  void ExpectErrorAndRecovery(const std::string& words)
  {
    this->ExpectError(words);
    this->ExpectRecovery();
  }

  /// A cell array of the surface, 0.5 everywhere.
  vtkDoubleArray* AddCellArray(const char* name)
  {
    vtkNew<vtkDoubleArray> array;
    array->SetName(name);
    array->SetNumberOfTuples(this->Surface->GetNumberOfCells());
    array->Fill(0.5);
    this->Surface->GetCellData()->AddArray(array);
    return array;
  }

  /// Cells as their arrays say, which nobody checks on the way.
  void SetCells(
    std::initializer_list<vtkTypeInt64> offsets, std::initializer_list<vtkTypeInt64> ids)
  {
    vtkNew<vtkTypeInt64Array> first, points;
    for (const vtkTypeInt64 offset : offsets)
    {
      first->InsertNextValue(offset);
    }
    for (const vtkTypeInt64 id : ids)
    {
      points->InsertNextValue(id);
    }
    vtkNew<vtkCellArray> cells;
    cells->SetData(first, points);
    this->Surface->SetPolys(cells);
  }
};

} // namespace

TEST_F(FilterInput, Nothing)
{
  this->Surface->Initialize();
  this->ExpectErrorAndRecovery("no polygons or triangle strips");
  this->Surface->SetPolys(SmallSphere()->GetPolys()); // cells, but no points
  this->ExpectErrorAndRecovery("cell 0 uses point 2 of 0");
  this->Surface = SmallSphere();
  this->Surface->SetPolys(vtkNew<vtkCellArray>());
  this->Filter->SetInputData(this->Surface);
  this->ExpectErrorAndRecovery("no polygons or triangle strips");
}

TEST_F(FilterInput, NotASurface)
{
  vtkNew<vtkImageData> image;
  this->Filter->SetInputData(image);
  this->Run();
  EXPECT_EQ(this->Messages->Errors, 1) << this->Messages->Text;
  this->ExpectRecovery();
  this->Filter->RemoveAllInputs();
  this->Run();
  EXPECT_EQ(this->Messages->Errors, 1) << this->Messages->Text;
  this->ExpectRecovery();
}

TEST_F(FilterInput, BlocksWithoutASurface)
{
  vtkNew<vtkMultiBlockDataSet> blocks;
  this->Filter->SetInputData(blocks);
  this->ExpectErrorAndRecovery("no polygons or triangle strips");
  blocks->SetNumberOfBlocks(3);
  blocks->SetBlock(1, vtkNew<vtkImageData>());
  blocks->SetBlock(2, vtkNew<vtkPolyData>());
  this->Filter->SetInputData(blocks);
  this->ExpectErrorAndRecovery("no polygons or triangle strips");
}

TEST_F(FilterInput, BlockWithABadValueIsNamed)
{
  this->AddCellArray("rho")->SetValue(7, 1.5);
  vtkNew<vtkMultiBlockDataSet> blocks;
  vtkSmartPointer<vtkPolyData> good = SmallSphere();
  vtkNew<vtkDoubleArray> rho;
  rho->SetName("rho");
  rho->SetNumberOfTuples(good->GetNumberOfCells());
  rho->Fill(0.25);
  good->GetCellData()->AddArray(rho);
  blocks->SetBlock(0, good);
  blocks->SetBlock(4, this->Surface);
  this->Filter->SetInputData(blocks);
  this->Filter->SetReflectanceArray("rho");
  this->ExpectError("cell 7 of block 5: DiffuseReflectance is 1.5; it must be within [0, 1]; "
                    "DiffuseReflectance is the array 'rho'");
}

TEST_F(FilterInput, ReflectanceOutOfRangeNamesCellAndValue)
{
  this->Filter->SetReflectanceArray("rho");
  vtkDoubleArray* rho = this->AddCellArray("rho");
  const std::pair<double, const char*> values[] = { { -0.25, "-0.25" }, { 1.25, "1.25" },
    { NoNumber, "nan" }, { Infinity, "inf" }, { -Infinity, "-inf" } };
  for (const auto& [value, text] : values)
  {
    rho->SetValue(17, value);
    rho->Modified();
    this->ExpectError(std::string("cell 17: DiffuseReflectance is ") + text +
      "; it must be within [0, 1]; DiffuseReflectance is the array 'rho'");
  }
  rho->SetValue(17, 1.0);
  rho->Modified();
  this->ExpectMap();
}

TEST_F(FilterInput, ArrayThatDoesNotFit)
{
  vtkNew<vtkStringArray> words;
  words->SetName("words");
  words->SetNumberOfValues(this->Surface->GetNumberOfCells());
  this->Surface->GetCellData()->AddArray(words);
  this->AddCellArray("long")->InsertNextValue(0.5);
  this->AddCellArray("none")->Initialize();
  const std::pair<const char*, const char*> arrays[] = { { "nowhere", "no cell array 'nowhere'" },
    { "Normals", "there is a point array of that name" }, { "words", "is a vtkStringArray" },
    { "long", "'long' has 97 values for 96 cells" }, { "none", "'none' has 0 values" } };
  for (const auto& [name, message] : arrays)
  {
    this->Filter->SetReflectanceArray(name);
    this->ExpectError(message);
    this->Filter->SetReflectanceArray("");
    this->ExpectMap();
    this->Filter->SetLampType(vtkIlluminationMap::EMITTING_FACETS);
    this->Filter->SetExitanceArray(name);
    this->ExpectError(message);
    this->Filter->SetLampType(vtkIlluminationMap::PARALLEL);
  }
}

TEST_F(FilterInput, PointThatIsNoNumber)
{
  double good[3];
  this->Surface->GetPoint(9, good);
  for (const bool normals : { true, false }) // without them, VTK computes on the points first
  {
    if (!normals)
    {
      this->Surface->GetPointData()->Initialize();
    }
    for (const double bad : { NoNumber, Infinity, -Infinity })
    {
      this->Surface->GetPoints()->SetPoint(9, good[0], bad, good[2]);
      this->Surface->GetPoints()->Modified();
      this->ExpectErrorAndRecovery("point 9: its coordinates");
    }
  }
  this->Surface->GetPoints()->SetPoint(9, good);
  // A point that no surface uses may be anything.
  this->Surface->GetPoints()->InsertNextPoint(NoNumber, 0.0, 0.0);
  this->Surface->GetPoints()->Modified();
  this->ExpectMap();
}

TEST_F(FilterInput, PointThatIsNoNumberInAnyCell)
{
  const auto points = vtkSmartPointer<vtkPoints>::New();
  for (const double x : { 0.0, 1.0, 2.0, 3.0 })
  {
    points->InsertNextPoint(x, 0.0, 0.0);
    points->InsertNextPoint(x, 1.0, 0.1 * x);
  }
  const std::initializer_list<vtkIdType> triangle = { 0, 2, 3 }, square = { 0, 2, 3, 1 },
                                         polygon = { 0, 2, 4, 6, 7, 5, 3, 1 },
                                         degenerate = { 2, 2, 3 };
  for (const auto& corners : { triangle, square, polygon, degenerate })
  {
    for (const bool strip : { false, true })
    {
      vtkNew<vtkCellArray> cells;
      cells->InsertNextCell({ 4, 6, 7 });
      cells->InsertNextCell(corners);
      this->Surface->Initialize();
      this->Surface->SetPoints(points);
      strip ? this->Surface->SetStrips(cells) : this->Surface->SetPolys(cells);
      for (const double bad : { NoNumber, Infinity })
      {
        points->SetPoint(2, 1.0, bad, 0.0);
        points->Modified();
        this->ExpectErrorAndRecovery("point 2: its coordinates (1, ");
        this->ExpectError("which cell 1 uses, are not finite");
        points->SetPoint(2, 1.0, 0.0, 0.0);
      }
    }
  }
}

TEST_F(FilterInput, NormalsThatDoNotFit)
{
  vtkPointData* arrays = this->Surface->GetPointData();
  vtkNew<vtkFloatArray> pairs;
  pairs->SetName("Normals");
  pairs->SetNumberOfComponents(2);
  pairs->SetNumberOfTuples(this->Surface->GetNumberOfPoints());
  arrays->Initialize();
  arrays->AddArray(pairs);
  this->ExpectErrorAndRecovery("point array 'Normals' has 2 components; 3 are wanted");
  vtkNew<vtkFloatArray> tooShort;
  tooShort->SetName("Normals");
  tooShort->SetNumberOfComponents(3);
  tooShort->SetNumberOfTuples(3);
  tooShort->Fill(1.0);
  arrays->Initialize();
  arrays->SetNormals(tooShort);
  this->ExpectErrorAndRecovery("point array 'Normals' has 3 values for 50 points");
  vtkNew<vtkStringArray> words;
  words->SetName("Normals");
  words->SetNumberOfValues(this->Surface->GetNumberOfPoints());
  arrays->Initialize();
  arrays->AddArray(words);
  this->ExpectErrorAndRecovery("point array 'Normals' is a vtkStringArray, not numbers");
}

TEST_F(FilterInput, IndexOutOfRange)
{
  for (const vtkTypeInt64 bad : { vtkTypeInt64{ -1 }, vtkTypeInt64{ 50 }, VTK_TYPE_INT64_MAX,
         VTK_TYPE_INT64_MIN, vtkTypeInt64{ 1 } << 32 })
  {
    this->SetCells({ 0, 3, 6 }, { 0, 1, 2, 1, bad, 2 });
    this->ExpectErrorAndRecovery("cell 1 uses point " + std::to_string(bad) + " of 50");
  }
  vtkNew<vtkCellArray> strip;
  strip->InsertNextCell({ 0, 1, 2, 99 });
  this->Surface->SetPolys(vtkNew<vtkCellArray>());
  this->Surface->SetStrips(strip);
  this->ExpectErrorAndRecovery("cell 0 uses point 99 of 50");
}

TEST_F(FilterInput, CellArrayThatContradictsItself)
{
  const std::initializer_list<vtkTypeInt64> ids = { 0, 1, 2, 1, 3, 2 };
  const std::initializer_list<vtkTypeInt64> wrong[] = { { 0, 3, 7 }, { 0, 3, 5 }, { 1, 3, 6 },
    { 0, 7, 6 }, { 0, -3, 6 }, { 0, vtkTypeInt64{ 1 } << 60 }, {} };
  for (const auto& offsets : wrong)
  {
    this->SetCells(offsets, ids);
    this->ExpectErrorAndRecovery("the polygons contradict themselves");
  }
}

TEST_F(FilterInput, CellsThatAreNoSurfaceMayUseAnyPoint)
{
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell({ 0, 4711 });
  this->Surface->SetLines(lines);
  this->Surface->SetVerts(lines);
  this->ExpectMap();
}
