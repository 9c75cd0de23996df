// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/map/AccuracyRegion.h"

#include "Illumination/map/SceneBlocks.h"
#include "Illumination/pipeline/InputError.h"
#include "Illumination/pipeline/PieceNames.h"
#include "Illumination/surface/ChosenBlocks.h"
#include "Illumination/surface/InputChecks.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace Illumination
{
namespace
{

/// Adds for each facet of a block whether it is in the region.
void AppendBlock(
  const SceneBlock& block, const std::string& array, std::vector<std::uint8_t>& inRegion)
{
  vtkDataArray* values = CheckedCellArray(block.data, array, block.name, false);
  for (const vtkIdType cell : block.cellOfFacet)
  {
    const double value = values->GetComponent(cell, 0);
    if (std::isnan(value))
    {
      throw InputError(NameOfCell(block.data, cell, block.name) + ": array '" + array +
        "' is nan; it must be 0, or another number where accuracy counts");
    }
    inRegion.push_back(value != 0.0 ? 1 : 0);
  }
}

/// [scene block]
std::vector<bool> ChosenOf(
  const SceneBlocks& blocks, vtkDataObject* data, const std::set<int>& chosen)
{
  std::set<std::string> names;
  for (const ChosenBlock& block : ChooseBlocks(data, chosen))
  {
    if (block.chosen)
    {
      names.insert(block.name);
    }
  }
  std::vector<bool> chosenOf;
  for (const SceneBlock& block : blocks.Blocks())
  {
    chosenOf.push_back(names.count(block.name) != 0);
  }
  return chosenOf;
}

/// The reason why no cell is in the region.
InputError NoCell(
  const SceneBlocks& blocks, const std::vector<bool>& chosen, const std::string& array)
{
  const auto none = std::string("no cell is in the region where accuracy counts: ");
  const auto first = std::find(chosen.begin(), chosen.end(), true);
  if (first == chosen.end())
  {
    return InputError(none + "the chosen blocks (AccuracyRegionBlocks) have no polygons");
  }
  const SceneBlock& block = blocks.Blocks()[first - chosen.begin()];
  if (!array.empty() && block.data->GetCellData()->HasArray(array.c_str()) == 0)
  {
    CheckedCellArray(block.data, array, block.name, false); // throws, with the reason
  }
  return InputError(none + "the cell array '" + array + "' (AccuracyRegionArray) is 0 everywhere");
}

/// [facet]
std::vector<std::uint8_t> FacetsInRegion(
  const SceneBlocks& blocks, const std::vector<bool>& chosen, const std::string& array)
{
  std::vector<std::uint8_t> inRegion;
  for (std::size_t b = 0; b < blocks.Blocks().size(); ++b)
  {
    const SceneBlock& block = blocks.Blocks()[b];
    if (chosen[b] && !array.empty() && block.data->GetCellData()->HasArray(array.c_str()) != 0)
    {
      AppendBlock(block, array, inRegion);
    }
    else
    {
      const bool whole = chosen[b] && array.empty();
      inRegion.resize(inRegion.size() + block.cellOfFacet.size(), whole ? 1 : 0);
    }
  }
  if (std::find(inRegion.begin(), inRegion.end(), 1) == inRegion.end())
  {
    throw NoCell(blocks, chosen, array);
  }
  return inRegion;
}

} // namespace

std::vector<double> AccuracyRegion(
  const SceneBlocks& blocks, vtkDataObject* data, const RegionChoice& choice)
{
  if (choice.IsEmpty())
  {
    return {};
  }
  const std::vector<std::uint8_t> inRegion =
    FacetsInRegion(blocks, ChosenOf(blocks, data, choice.blocks), choice.array);
  const PhotonTransport::Surface& surface = blocks.Surface();
  double reach = 0.0; // so that areas neither vanish nor overflow
  for (const glm::dvec3& point : surface.points)
  {
    const glm::dvec3 far = glm::abs(point);
    reach = std::fmax(reach, std::max({ far.x, far.y, far.z }));
  }
  std::vector<double> areas(surface.points.size(), 0.0);
  std::vector<double> shares(surface.points.size(), 0.0);
  for (std::size_t f = 0; f < surface.facets.size(); ++f)
  {
    const auto corner = [&](int c) { return surface.points[surface.facets[f][c]] / reach; };
    const double area = glm::length(glm::cross(corner(1) - corner(0), corner(2) - corner(0)));
    for (int c = 0; c < 3; ++c)
    {
      areas[surface.facets[f][c]] += area;
      shares[surface.facets[f][c]] += inRegion[f] != 0 ? area : 0.0;
    }
  }
  for (std::size_t v = 0; v < shares.size(); ++v)
  {
    shares[v] = areas[v] > 0.0 ? shares[v] / areas[v] : 0.0;
  }
  return shares;
}

} // namespace Illumination
