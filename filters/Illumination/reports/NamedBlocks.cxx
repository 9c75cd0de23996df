// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/reports/NamedBlocks.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkSmartPointer.h"

#include <map>

namespace Illumination
{
namespace
{

std::string NameOf(vtkInformation* information)
{
  return information && information->Has(vtkCompositeDataSet::NAME())
    ? information->Get(vtkCompositeDataSet::NAME())
    : "";
}

/// The partitioned data set that each partition of a collection belongs to.
std::map<vtkDataObject*, unsigned> CollectionPlaces(vtkDataObject* data)
{
  std::map<vtkDataObject*, unsigned> places;
  auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data);
  for (unsigned i = 0; collection && i < collection->GetNumberOfPartitionedDataSets(); ++i)
  {
    vtkPartitionedDataSet* set = collection->GetPartitionedDataSet(i);
    for (unsigned j = 0; set && j < set->GetNumberOfPartitions(); ++j)
    {
      places[set->GetPartitionAsDataObject(j)] = i;
    }
  }
  return places;
}

} // namespace

void NamedBlocks::Add(vtkDataObject* piece)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(piece);
  if (!composite)
  {
    auto* data = vtkDataSet::SafeDownCast(piece);
    if (data && data->GetNumberOfPoints() > 0)
    {
      this->blocks.push_back({ data, "", 0.0, "All" });
    }
    return;
  }
  const std::map<vtkDataObject*, unsigned> collection = CollectionPlaces(piece);
  auto it = vtk::TakeSmartPointer(composite->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    auto* data = vtkDataSet::SafeDownCast(it->GetCurrentDataObject());
    if (!data || data->GetNumberOfPoints() == 0)
    {
      this->others += data ? 0 : 1;
      continue;
    }
    const std::string number = std::to_string(it->GetCurrentFlatIndex());
    const auto place = collection.find(data);
    const bool inCollection = place != collection.end();
    const std::string name = NameOf(inCollection
        ? vtkPartitionedDataSetCollection::SafeDownCast(piece)->GetMetaData(place->second)
        : it->HasCurrentMetaData() ? it->GetCurrentMetaData()
                                   : nullptr);
    const double key = inCollection ? place->second : it->GetCurrentFlatIndex();
    this->blocks.push_back(
      { data, " of block " + number, key, name.empty() ? "Block " + number : name });
  }
}

} // namespace Illumination
