// SPDX-License-Identifier: BSD-3-Clause
// Settings, places and arrays that make no material: one error, and the input passes through.
#include "MaterialTools.h"

#include "vtkIntArray.h"
#include "vtkStringArray.h"

#include <cmath>

namespace
{

/// Expects the message, and the input without new arrays.
void ExpectError(vtkSurfaceMaterial* filter, const std::string& message)
{
  EXPECT_TRUE(Holds(ErrorOf(filter), message));
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  output = output ? output : Leaf(filter, 1);
  EXPECT_TRUE(output && output->GetNumberOfPoints() == 9 && !HasMaterial(output))
    << "the input passes through after '" << message << "'";
}

} // namespace

TEST(SurfaceMaterialErrors, SettingsOutOfRangeAreRefused)
{
  vtkNew<vtkSurfaceMaterial> filter;
  filter->SetInputData(Plane());
  filter->SetDiffuseReflectance(0.5, 1.25, 0.5);
  ExpectError(filter, "DiffuseReflectance (green) is 1.25; it must be within [0, 1]");
  filter->SetDiffuseReflectance(0.5, 0.5, std::nan(""));
  ExpectError(filter, "DiffuseReflectance (blue) is nan");
  filter->SetDiffuseReflectance(0.25, 0.5, 0.25);
  filter->SetClearTransmittance(-0.5, 0.0, 0.0);
  ExpectError(filter, "ClearTransmittance (red) is -0.5");
  filter->SetClearTransmittance(0.25, 0.25, 0.25);
  filter->SetGlossyReflectance(0.5, 0.5, 0.5);
  ExpectError(filter,
    "the reflectances and transmittances (green) sum to 1.25; they must not exceed 1 together");
  filter->SetGlossyReflectance(0.0, 0.0, 0.0);
  filter->SetRoughness(0.0);
  ExpectError(filter, "Roughness is 0; it must be within (0, 1]");
  filter->SetRoughness(1.0);
  filter->SetRefractiveIndex(0.75);
  ExpectError(filter, "RefractiveIndex is 0.75; it must be within [1, 4]");
  filter->SetRefractiveIndex(4.0);
  EXPECT_TRUE(ErrorOf(filter).empty() && HasMaterial(filter->GetOutput()))
    << "after errors it works";
  // Thirds and fifths that are 1 together must not fail for their rounding.
  filter->SetDiffuseReflectance(1.0 / 3, 0.2, 0.7);
  filter->SetGlossyReflectance(1.0 / 3, 0.6, 0.1);
  filter->SetClearTransmittance(1.0 / 3, 0.2, 0.2);
  EXPECT_TRUE(ErrorOf(filter).empty()) << "shares that sum to 1 are fine";
}

TEST(SurfaceMaterialErrors, PlacesThatAreNotThereAreRefused)
{
  vtkNew<vtkSurfaceMaterial> filter;
  filter->SetInputData(MultiBlock());
  filter->AddBlock(9);
  ExpectError(filter, "there is no block 9; the flat indices of the input's blocks are 0 to 7");
  filter->RemoveAllBlocks();
  filter->AddBlock(-1);
  ExpectError(filter, "there is no block -1");
  filter->RemoveAllBlocks();
  filter->AddBlock(7);
  ExpectError(filter, "none of the chosen blocks is a surface");
  filter->RemoveAllBlocks();
  filter->AddBlock(3);
  filter->SetCellArray("Part");
  ExpectError(filter, "there is no cell array 'Part' of block 3");

  const auto plane = Plane();
  AddCells<vtkIntArray>(plane, "Part", 1, { 7, 8, 7, 9 });
  filter->SetInputData(plane);
  filter->SetCellValue(5);
  ExpectError(filter, "no cell has the value 5 in cell array 'Part'");
  filter->SetCellArray("None");
  EXPECT_TRUE(ErrorOf(filter).empty()) << "None is no array, and a single surface has no blocks";
}

TEST(SurfaceMaterialErrors, ArraysThatDoNotFitAreRefused)
{
  vtkNew<vtkSurfaceMaterial> filter;
  filter->SetCellArray("Part");
  filter->SetCellValue(7);
  const auto expect = [&](const std::string& message, const auto& spoil)
  {
    const auto plane = Plane();
    AddCells<vtkIntArray>(plane, "Part", 1, { 7, 8, 7, 9 });
    spoil(plane.Get());
    filter->SetInputData(plane);
    ExpectError(filter, message);
  };
  expect("cell array 'Roughness' has 3 components; 1 is wanted",
    [](vtkPolyData* data)
    { AddCells<vtkFloatArray>(data, "Roughness", 3, std::vector<double>(12)); });
  expect("cell array 'DiffuseReflectance' has 2 components; 1 or 3 are wanted",
    [](vtkPolyData* data)
    { AddCells<vtkFloatArray>(data, "DiffuseReflectance", 2, std::vector<double>(8)); });
  expect("cell array 'DiffuseReflectance' has 3 values for 4 cells",
    [](vtkPolyData* data)
    { AddCells<vtkFloatArray>(data, "DiffuseReflectance", 1, std::vector<double>(3)); });
  expect("cell array 'SolidBody' is a vtkStringArray, not numbers",
    [](vtkPolyData* data)
    {
      vtkNew<vtkStringArray> text;
      text->SetName("SolidBody");
      text->SetNumberOfTuples(4);
      data->GetCellData()->AddArray(text);
    });
  expect("cell 3: SolidBody is 0.5; it must be 0 or 1",
    [](vtkPolyData* data) {
      AddCells<vtkFloatArray>(data, "SolidBody", 1, { 9, 1, 9, 0.5 });
    });
  expect("cell 1: the reflectances and transmittances sum to 1.5",
    [](vtkPolyData* data) {
      AddCells<vtkFloatArray>(data, "ClearTransmittance", 1, { 1, 1, 1, 1 });
    });
}
