// SPDX-License-Identifier: BSD-3-Clause
// The material filter: what it writes where, what it keeps, chosen cells and blocks.
#include "MaterialTools.h"

#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"

#include <algorithm>
#include <sstream>

namespace
{

} // namespace

TEST(SurfaceMaterial, WritesWhatIsSet)
{
  const auto plane = Plane();
  vtkNew<vtkSurfaceMaterial> filter;
  filter->SetInputData(plane);
  filter->SetDiffuseReflectance(0.125, 0.25, 0.375);
  filter->SetSpecularReflectance(0.0625, 0.125, 0.1875);
  filter->SetGlossyReflectance(0.03125, 0.0625, 0.09375);
  filter->SetDiffuseTransmittance(0.1, 0.0, 0.0);
  filter->SetClearTransmittance(0.5, 0.25, 0.125);
  filter->SetRoughness(0.5);
  filter->SetRefractiveIndex(2.0);
  filter->SetSolidBody(true);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  EXPECT_TRUE(HasMaterial(output)) << "all arrays are there";
  EXPECT_FALSE(plane->GetCellData()->HasArray("Roughness")) << "the input has no new arrays";
  for (vtkIdType cell = 0; cell < 4; ++cell)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double share = 0.125 * (c + 1);
      EXPECT_TRUE(Value(output, "DiffuseReflectance", cell, c) == share &&
        Value(output, "SpecularReflectance", cell, c) == share / 2 &&
        Value(output, "GlossyReflectance", cell, c) == share / 4)
        << "reflectances are as they were set";
    }
    EXPECT_TRUE(Value(output, "DiffuseTransmittance", cell, 0) == static_cast<double>(0.1f) &&
      Value(output, "ClearTransmittance", cell, 1) == 0.25)
      << "so are transmittances";
    EXPECT_TRUE(Value(output, "Roughness", cell) == 0.5 &&
      Value(output, "RefractiveIndex", cell) == 2.0 && Value(output, "SolidBody", cell) == 1.0)
      << "and the numbers";
  }
}

TEST(SurfaceMaterial, ChangesChosenCells)
{
  const auto plane = Plane();
  AddCells<vtkIntArray>(plane, "Part", 1, { 7, 8, 7, 9 });
  AddCells<vtkDoubleArray>(plane, "DiffuseReflectance", 1, { 0.125, 0.25, 0.375, 0.625 });
  vtkDataArray* before = plane->GetCellData()->GetArray("DiffuseReflectance");
  vtkNew<vtkSurfaceMaterial> mirror;
  mirror->SetInputData(plane);
  mirror->SetPreset(vtkSurfaceMaterial::MIRROR);
  mirror->SetCellArray("Part");
  mirror->SetCellValue(7);
  vtkNew<vtkSurfaceMaterial> glass;
  glass->SetInputConnection(mirror->GetOutputPort());
  glass->SetPreset(vtkSurfaceMaterial::CLEAR_GLASS);
  glass->SetCellArray("Part");
  glass->SetCellValue(9);
  glass->Update();
  vtkPolyData* first = mirror->GetOutput();
  vtkPolyData* second = glass->GetOutput();
  EXPECT_TRUE(HasMaterial(first) && HasMaterial(second)) << "a chain writes the same arrays";
  EXPECT_TRUE(plane->GetCellData()->GetArray("DiffuseReflectance") == before &&
    before->GetComponent(0, 0) == 0.125 && before->GetNumberOfComponents() == 1)
    << "the input's array is untouched";
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_EQ(Value(first, "DiffuseReflectance", 0, c), 0.0) << "a chosen cell is a mirror";
    EXPECT_EQ(Value(first, "DiffuseReflectance", 1, c), 0.25) << "others keep what they have, grey";
    EXPECT_EQ(Value(second, "DiffuseReflectance", 1, c), 0.25) << "in a chain too";
  }
  EXPECT_TRUE(
    Value(first, "RefractiveIndex", 1) == 1.0 && Value(first, "SpecularReflectance", 1) == 0.0)
    << "where there was no array, cells are neutral";
  EXPECT_EQ(Value(second, "SpecularReflectance", 2), static_cast<double>(0.9f))
    << "the mirror stays";
  EXPECT_TRUE(
    Value(second, "ClearTransmittance", 3) > 0.9 && Value(second, "DiffuseReflectance", 3) == 0)
    << "the glass comes";
  EXPECT_TRUE(
    Value(first, "ClearTransmittance", 3) == 0.0 && Value(first, "DiffuseReflectance", 3) == 0.625)
    << "and does not reach back into the filter before it";
}

TEST(SurfaceMaterial, ChangesChosenBlocks)
{
  vtkNew<vtkSurfaceMaterial> filter;
  filter->SetInputData(MultiBlock());
  filter->SetPreset(vtkSurfaceMaterial::MIRROR);
  const auto expect = [&](const std::vector<int>& added, const std::vector<unsigned int>& mirrors,
                        const std::vector<unsigned int>& all)
  {
    filter->RemoveAllBlocks();
    for (const int block : added)
    {
      filter->AddBlock(block);
    }
    filter->Update();
    for (const unsigned int index : all)
    {
      vtkPolyData* leaf = Leaf(filter, index);
      const bool wanted = std::find(mirrors.begin(), mirrors.end(), index) != mirrors.end();
      const std::string where = "block " + std::to_string(index);
      EXPECT_TRUE(leaf && HasMaterial(leaf)) << where << " has all arrays";
      EXPECT_TRUE(leaf && (Value(leaf, "SpecularReflectance") > 0.0) == wanted)
        << where << " is right";
      EXPECT_TRUE(leaf && Value(leaf, "DiffuseReflectance") == (wanted ? 0.0 : 0.5))
        << where << " too";
    }
  };
  const std::vector<unsigned int> leaves{ 1, 3, 5, 6 };
  expect({}, leaves, leaves);
  expect({ 0 }, leaves, leaves);
  expect({ 2 }, { 3, 5 }, leaves);
  expect({ 6, 3 }, { 3, 6 }, leaves);
  expect({ 2, 3 }, { 3, 5 }, leaves); // one within the other
  EXPECT_TRUE(filter->GetNumberOfBlocks() == 2 && filter->HasBlock(3) && !filter->HasBlock(5))
    << "blocks are listed";

  vtkNew<vtkPartitionedDataSetCollection> collection; // 0 { 1 { 2 }, 3 { 4, 5 } }
  collection->SetPartition(0, 0, Plane());
  collection->SetPartition(1, 0, Plane());
  collection->SetPartition(1, 1, Plane());
  filter->SetInputData(collection);
  expect({ 3 }, { 4, 5 }, { 2, 4, 5 });
  expect({ 2, 5 }, { 2, 5 }, { 2, 4, 5 });
  vtkNew<vtkPartitionedDataSet> partitions;
  partitions->SetPartition(0, Plane());
  partitions->SetPartition(1, Plane());
  filter->SetInputData(partitions);
  expect({ 2 }, { 2 }, { 1, 2 });
}

TEST(SurfaceMaterial, PrintsItsDefaults)
{
  vtkNew<vtkSurfaceMaterial> filter;
  filter->AddBlock(4);
  filter->AddBlock(2);
  filter->SetCellArray("Part");
  std::ostringstream text;
  filter->Print(text);
  for (const std::string line : { "Preset: 0", "DiffuseReflectance: 0.5 0.5 0.5",
         "SpecularReflectance: 0 0 0", "GlossyReflectance: 0 0 0", "Roughness: 0.3",
         "DiffuseTransmittance: 0 0 0", "ClearTransmittance: 0 0 0", "RefractiveIndex: 1.5",
         "SolidBody: 0", "Opening: -1", "Blocks: 2 4", "CellArray: Part", "CellValue: 0" })
  {
    EXPECT_TRUE(Holds(text.str(), line + "\n")) << "PrintSelf says " << line;
  }
}
