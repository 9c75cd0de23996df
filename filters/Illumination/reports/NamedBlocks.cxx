// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/reports/NamedBlocks.h"

#include "Illumination/ranks/MergedPieces.h"
#include "Illumination/surface/SurfaceTriangles.h"

#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <map>
#include <utility>

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

/// @param pieces Their indices.
NamedBlock Joined(const std::vector<NamedBlock>& blocks, const std::vector<std::size_t>& pieces)
{
  std::vector<Piece> surfaces;
  for (const std::size_t b : pieces)
  {
    surfaces.push_back({ {}, blocks[b].where, blocks[b].data, blocks[b].rank });
  }
  NamedBlock whole = blocks[pieces.front()];
  whole.data = Merge(surfaces).data;
  return whole;
}

} // namespace

void NamedBlocks::Add(vtkDataObject* piece, std::size_t rank)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(piece);
  if (!composite)
  {
    auto* data = vtkDataSet::SafeDownCast(piece);
    if (data && data->GetNumberOfPoints() > 0)
    {
      this->blocks.push_back({ data, "", 0.0, "All", rank });
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
      { data, " of block " + number, key, name.empty() ? "Block " + number : name, rank });
  }
}

void NamedBlocks::JoinSurfacesOfRanks()
{
  std::map<double, std::vector<std::size_t>> surfaces; // by the block's number
  for (std::size_t b = 0; b < this->blocks.size(); ++b)
  {
    auto* data = vtkPolyData::SafeDownCast(this->blocks[b].data);
    if (data && HasSurface(data))
    {
      surfaces[this->blocks[b].number].push_back(b);
    }
  }
  std::vector<NamedBlock> joined;
  for (std::size_t b = 0; b < this->blocks.size(); ++b)
  {
    const auto found = surfaces.find(this->blocks[b].number);
    const bool isPiece = found != surfaces.end() &&
      std::binary_search(found->second.begin(), found->second.end(), b) &&
      this->blocks[found->second.front()].rank != this->blocks[found->second.back()].rank;
    if (!isPiece)
    {
      joined.push_back(this->blocks[b]);
    }
    else if (b == found->second.front())
    {
      joined.push_back(Joined(this->blocks, found->second));
    }
  }
  this->blocks = std::move(joined);
}

} // namespace Illumination
