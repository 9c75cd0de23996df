// SPDX-License-Identifier: BSD-3-Clause
// All blocks of a composite data set are one scene, and its structure comes back.
#include "Messages.h"
#include "OutputData.h"

#include "vtkIlluminationMap.h"

#include "vtkAppendPolyData.h"
#include "vtkImageData.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPlaneSource.h"
#include "vtkSphereSource.h"

namespace
{

vtkSmartPointer<vtkPolyData> Sphere()
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(0.0, 0.0, 1.0);
  source->Update();
  return source->GetOutput();
}

vtkSmartPointer<vtkPolyData> Floor()
{
  vtkNew<vtkPlaneSource> source;
  source->SetOrigin(-2.0, -2.0, 0.0);
  source->SetPoint1(2.0, -2.0, 0.0);
  source->SetPoint2(-2.0, 2.0, 0.0);
  source->SetResolution(20, 20);
  source->Update();
  return source->GetOutput();
}

/// What the two surfaces give as one, without blocks.
void Appended(vtkPolyData* first, vtkPolyData* second, vtkIlluminationMap* illuminate)
{
  vtkNew<vtkAppendPolyData> append;
  append->AddInputData(first);
  append->AddInputData(second);
  append->Update();
  illuminate->SetInputData(append->GetOutput());
  illuminate->SetPhotons(50000);
  illuminate->Update();
}

void CheckBlock(vtkPolyData* block, vtkPolyData* source, vtkDataArray* whole, vtkIdType offset)
{
  vtkDataArray* map = block ? PointArray(block, "Illuminance") : nullptr;
  EXPECT_TRUE(map && block->GetPoints() == source->GetPoints())
    << "the block comes back with a map";
  for (vtkIdType i = 0; map && i < map->GetNumberOfTuples(); ++i)
  {
    // Areas and weights are added in single precision, in the order of the triangles.
    EXPECT_NEAR(
      map->GetTuple1(i), whole->GetTuple1(offset + i), 1e-6 * whole->GetTuple1(offset + i))
      << "the block's map is the scene's";
  }
}

} // namespace

TEST(IlluminationMap, BlocksAreOneSceneAndKeepTheirStructure)
{
  const auto sphere = Sphere();
  const auto floor = Floor();
  vtkNew<vtkIlluminationMap> reference;
  Appended(sphere, floor, reference);
  vtkDataArray* whole = PointArray(reference->GetOutput(), "Illuminance");
  // The middle of the floor is in the sphere's shadow, from straight above.
  EXPECT_LT(whole->GetTuple1(sphere->GetNumberOfPoints() + 220),
    0.1 * whole->GetTuple1(sphere->GetNumberOfPoints()))
    << "blocks shade each other";

  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, floor);
  vtkNew<vtkImageData> notASurface;
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, sphere);
  blocks->SetBlock(1, notASurface);
  blocks->SetBlock(3, inner);
  vtkNew<vtkIlluminationMap> illuminate;
  illuminate->SetInputData(blocks);
  illuminate->SetPhotons(50000);
  illuminate->Update();
  auto* output = vtkMultiBlockDataSet::SafeDownCast(illuminate->GetOutputDataObject(0));
  EXPECT_TRUE(output && output->GetNumberOfBlocks() == 4 && !output->GetBlock(2)) << "structure";
  if (output)
  {
    CheckBlock(vtkPolyData::SafeDownCast(output->GetBlock(0)), sphere, whole, 0);
    auto* nested = vtkMultiBlockDataSet::SafeDownCast(output->GetBlock(3));
    EXPECT_NE(nested, nullptr) << "nested structure";
    CheckBlock(nested ? vtkPolyData::SafeDownCast(nested->GetBlock(0)) : nullptr, floor, whole,
      sphere->GetNumberOfPoints());
    EXPECT_NE(vtkImageData::SafeDownCast(output->GetBlock(1)), nullptr)
      << "other blocks pass through";
    EXPECT_TRUE(Holds(FieldText(output, "Notes"), "1 blocks are not polygonal")) << "and are noted";
  }

  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartition(0, 0, sphere);
  collection->SetPartition(1, 0, floor);
  illuminate->SetInputData(collection);
  illuminate->Update();
  auto* parts = vtkPartitionedDataSetCollection::SafeDownCast(illuminate->GetOutputDataObject(0));
  EXPECT_TRUE(parts && parts->GetNumberOfPartitionedDataSets() == 2) << "collection";
  if (parts)
  {
    CheckBlock(vtkPolyData::SafeDownCast(parts->GetPartitionAsDataObject(1, 0)), floor, whole,
      sphere->GetNumberOfPoints());
  }
  illuminate->SetInputData(floor); // back to a plain surface
  illuminate->Update();
  EXPECT_TRUE(illuminate->GetOutput() && PointArray(illuminate->GetOutput(), "Illuminance"))
    << "the type of the output follows the input";
}
