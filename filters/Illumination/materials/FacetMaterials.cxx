// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/materials/FacetMaterials.h"

#include "Illumination/materials/MaterialCells.h"
#include "Illumination/pipeline/InputError.h"
#include "Illumination/pipeline/PieceNames.h"
#include "Illumination/surface/InputChecks.h"

#include "PhotonTransport/materials/MaterialProperties.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include <array>
#include <map>

namespace Illumination
{
namespace
{

using namespace PhotonTransport;

/// The array that describes a property in a block; empty if none does. Diffuse reflectance, the
/// first property, may have an array of any name.
std::string ArrayOf(
  std::size_t property, const SceneBlock& block, const SurfaceDescription& surface)
{
  if (property == 0 && !surface.reflectanceArray.empty())
  {
    return surface.reflectanceArray;
  }
  const char* name = MaterialProperties[property].name;
  const bool given = surface.materialArrays && block.data->GetCellData()->HasArray(name) != 0;
  return given ? name : "";
}

/// The materials of a block's cells, as arrays and properties say.
class BlockMaterials
{
public:
  /// Throws InputError for arrays that are not numbers, one tuple of the right size a cell.
  BlockMaterials(const SceneBlock& block, const SurfaceDescription& surface)
    : Common(ValuesOf(surface.material))
  {
    for (std::size_t p = 0; p < MaterialProperties.size(); ++p)
    {
      const std::string array = ArrayOf(p, block, surface);
      const bool colours = IsShare(MaterialProperties[p]);
      this->Arrays[p] =
        array.empty() ? nullptr : CheckedCellArray(block.data, array, block.name, colours);
    }
  }

  MaterialValues Of(vtkIdType cell) const
  {
    MaterialValues values = this->Common;
    for (std::size_t p = 0; p < MaterialProperties.size(); ++p)
    {
      for (int c = 0; this->Arrays[p] && c < ComponentsOf(MaterialProperties[p]); ++c)
      {
        const int from = c % this->Arrays[p]->GetNumberOfComponents(); // 1 stands for grey
        values[3 * p + static_cast<std::size_t>(c)] =
          static_cast<float>(this->Arrays[p]->GetComponent(cell, from));
      }
    }
    return values;
  }

private:
  MaterialValues Common;
  std::array<vtkDataArray*, MaterialProperties.size()> Arrays{};
};

/// Finds out which materials are the same.
class MaterialIndex
{
public:
  explicit MaterialIndex(std::vector<Material>& materials)
    : Materials(materials)
  {
  }

  /// Throws what refuse(problem) throws for values that are no material.
  template <typename Refuse>
  std::uint32_t Of(const MaterialValues& values, const Refuse& refuse)
  {
    if (!this->Materials.empty() && values == this->LastValues) // as most neighbours are
    {
      return this->Last;
    }
    const std::string problem =
      ProblemOf(values); // first: values that are no numbers have no order
    if (!problem.empty())
    {
      refuse(problem);
    }
    const auto [place, isNew] =
      this->Known.emplace(values, static_cast<std::uint32_t>(this->Materials.size()));
    if (isNew)
    {
      this->Materials.push_back(MaterialOf(values));
    }
    this->LastValues = values;
    return this->Last = place->second;
  }

private:
  std::vector<Material>& Materials;
  std::map<MaterialValues, std::uint32_t> Known;
  MaterialValues LastValues{};
  std::uint32_t Last = 0;
};

/// Which array holds the first property, where its name does not say so.
std::string NoteOnArray(const std::string& reflectanceArray)
{
  const std::string name = MaterialProperties.front().name;
  return reflectanceArray.empty() || reflectanceArray == name
    ? ""
    : "; " + name + " is the array '" + reflectanceArray + "'";
}

} // namespace

void DescribeMaterials(
  const std::vector<SceneBlock>& blocks, const SurfaceDescription& description, Surface& surface)
{
  RequireValid(ValuesOf(description.material), "the material of cells without arrays: ");
  MaterialIndex index(surface.materials);
  for (const SceneBlock& block : blocks)
  {
    const BlockMaterials materials(block, description);
    for (const vtkIdType cell : block.cellOfFacet)
    {
      const auto refuse = [&](const std::string& problem)
      {
        throw InputError(NameOfCell(block.data, cell, block.name) + ": " + problem +
          NoteOnArray(description.reflectanceArray));
      };
      surface.materialOfFacet.push_back(index.Of(materials.Of(cell), refuse));
    }
  }
}

} // namespace Illumination
