// SPDX-License-Identifier: BSD-3-Clause
// The cell array Opening: written by Surface Material, read by Illumination Map.
#include "MaterialTools.h"

#include "Illumination/map/SceneBlocks.h"

#include "vtkIlluminationMap.h"

#include "vtkIntArray.h"
#include "vtkUnsignedCharArray.h"

namespace
{

using Illumination::SceneBlocks;
using Illumination::SurfaceDescription;
using PhotonTransport::OpeningMark;

/// The marks of the four cells; each cell has two triangles with the same mark.
std::vector<OpeningMark> MarksOf(vtkDataObject* data, const SurfaceDescription& description = {})
{
  const SceneBlocks blocks(data, description);
  std::vector<OpeningMark> marks;
  const std::vector<OpeningMark>& all = blocks.Surface().openingOfFacet;
  EXPECT_TRUE(all.empty() || all.size() == blocks.Surface().facets.size());
  for (std::size_t f = 0; f + 1 < all.size(); f += 2)
  {
    EXPECT_EQ(all[f], all[f + 1]);
    marks.push_back(all[f]);
  }
  return marks;
}

constexpr OpeningMark None = OpeningMark::None, Yes = OpeningMark::Opening,
                      No = OpeningMark::NoOpening;
using Marks = std::vector<OpeningMark>;

} // namespace

TEST(OpeningCells, AreMarkedInAChain)
{
  const auto plane = Plane();
  AddCells<vtkIntArray>(plane, "Part", 1, { 7, 8, 7, 9 });
  vtkNew<vtkSurfaceMaterial> first;
  first->SetInputData(plane);
  first->SetCellArray("Part");
  first->SetCellValue(7);
  first->Update();
  EXPECT_FALSE(first->GetOutput()->GetCellData()->HasArray("Opening")) << "as found: no array";
  EXPECT_EQ(MarksOf(first->GetOutput()), Marks{});
  first->SetPreset(vtkSurfaceMaterial::OPENING);
  vtkNew<vtkSurfaceMaterial> second;
  second->SetInputConnection(first->GetOutputPort());
  second->SetPreset(vtkSurfaceMaterial::CLEAR_GLASS);
  second->SetOpening(vtkSurfaceMaterial::NO_OPENING);
  second->SetCellArray("Part");
  second->SetCellValue(9);
  second->Update();
  EXPECT_EQ(MarksOf(second->GetOutput()), (Marks{ Yes, None, Yes, No }));
  EXPECT_EQ(Value(second->GetOutput(), "Opening", 1), -1.0);
  EXPECT_EQ(MarksOf(first->GetOutput()), (Marks{ Yes, None, Yes, None }));
  EXPECT_FALSE(plane->GetCellData()->HasArray("Opening")) << "the input is untouched";
  vtkNew<vtkSurfaceMaterial> third; // takes the mark back
  third->SetInputConnection(second->GetOutputPort());
  third->SetCellArray("Part");
  third->SetCellValue(7);
  third->Update();
  EXPECT_EQ(MarksOf(third->GetOutput()), (Marks{ None, None, None, No }));
}

TEST(OpeningCells, AreReadByBlock)
{
  const auto blocks = MultiBlock();
  AddCells<vtkIntArray>(
    vtkPolyData::SafeDownCast(blocks->GetBlock(2)), "Opening", 1, { 1, 0, -1, 1 });
  EXPECT_EQ(MarksOf(blocks),
    (Marks{ None, None, None, None, None, None, None, None, None, None, None, None, Yes, No, None,
      Yes }));
  SurfaceDescription withoutArrays;
  withoutArrays.materialArrays = false;
  EXPECT_EQ(MarksOf(blocks, withoutArrays), Marks{});
}

TEST(OpeningCells, MustBeMarks)
{
  const auto plane = Plane();
  AddCells<vtkFloatArray>(plane, "Opening", 1, { 1, 0, 0.5, 1 });
  const std::string message =
    "cell 2: Opening is 0.5; it must be 1 (an opening), 0 (none) or -1 (as found from the mesh)";
  vtkNew<vtkIlluminationMap> map;
  map->SetInputData(plane);
  EXPECT_TRUE(Holds(ErrorOf(map), message));
  vtkNew<vtkSurfaceMaterial> filter;
  filter->SetInputData(plane);
  EXPECT_TRUE(ErrorOf(filter).empty()) << "all cells are chosen";
  AddCells<vtkIntArray>(plane, "Part", 1, { 7, 8, 8, 8 });
  filter->SetCellArray("Part");
  filter->SetCellValue(7);
  EXPECT_TRUE(Holds(ErrorOf(filter), message));
  EXPECT_FALSE(HasMaterial(filter->GetOutput())) << "the input passes through";
  AddCells<vtkUnsignedCharArray>(plane, "vtkGhostType", 1, { 0, 0, 1, 0 });
  EXPECT_TRUE(ErrorOf(filter).empty()) << "a duplicate is never looked at";
  const auto wide = Plane();
  AddCells<vtkFloatArray>(wide, "Opening", 3, std::vector<double>(12));
  map->SetInputData(wide);
  EXPECT_TRUE(Holds(ErrorOf(map), "cell array 'Opening' has 3 components; 1 is wanted"));
}
