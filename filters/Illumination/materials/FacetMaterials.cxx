// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/materials/FacetMaterials.h"

#include "Illumination/materials/MaterialArrays.h"
#include "Illumination/pipeline/InputError.h"
#include "Illumination/surface/CellValues.h"
#include "Illumination/surface/InputChecks.h"

#include "PhotonTransport/materials/Scattering.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <map>

namespace
{

using PhotonTransport::Colour;
using PhotonTransport::Material;

constexpr const char* OtherArrays[] = { MaterialArrays::SpecularReflectance,
  MaterialArrays::GlossyReflectance, MaterialArrays::DiffuseTransmittance,
  MaterialArrays::ClearTransmittance, MaterialArrays::Roughness, MaterialArrays::RefractiveIndex,
  MaterialArrays::SolidBody };

bool Has(const SceneBlock& block, const char* array)
{
  return block.data->GetCellData()->HasArray(array) != 0;
}

/// The array that says how a block reflects diffusely; empty if none does.
std::string DiffuseArray(const SceneBlock& block, const SurfaceDescription& description)
{
  const bool byName = description.reflectanceArray.empty() && description.materialArrays &&
    Has(block, MaterialArrays::DiffuseReflectance);
  return byName ? MaterialArrays::DiffuseReflectance : description.reflectanceArray;
}

/// Whether a block only reflects diffusely, without colour.
bool IsPlain(const SceneBlock& block, const SurfaceDescription& description)
{
  const bool others = description.materialArrays &&
    std::any_of(std::begin(OtherArrays), std::end(OtherArrays),
      [&](const char* array) { return Has(block, array); });
  vtkDataArray* diffuse =
    block.data->GetCellData()->GetArray(DiffuseArray(block, description).c_str());
  return !others && !(diffuse && diffuse->GetNumberOfComponents() == 3);
}

CellValues DiffuseOf(const SceneBlock& block, const SurfaceDescription& description)
{
  const std::string array = DiffuseArray(block, description);
  return array.empty() ? CellValues(description.material.diffuseReflectance)
                       : CellValues(block, array, { "reflectance", 1.0 });
}

/// The materials of a block's cells.
class BlockMaterials
{
public:
  BlockMaterials(const SceneBlock& block, const SurfaceDescription& description)
    : Diffuse(DiffuseOf(block, description))
  {
    const Material& common = description.material;
    const auto add = [&](const char* array, const CellValueKind& kind, const Colour& constant)
    {
      const bool given = description.materialArrays && Has(block, array);
      this->Others.push_back(given ? CellValues(block, array, kind) : CellValues(constant));
    };
    add(MaterialArrays::SpecularReflectance, { "specular reflectance", 1.0 },
      common.specularReflectance);
    add(MaterialArrays::GlossyReflectance, { "glossy reflectance", 1.0 }, common.glossyReflectance);
    add(MaterialArrays::DiffuseTransmittance, { "diffuse transmittance", 1.0 },
      common.diffuseTransmittance);
    add(MaterialArrays::ClearTransmittance, { "clear transmittance", 1.0 },
      common.clearTransmittance);
    add(MaterialArrays::Roughness, { "roughness", 1.0, false }, Colour(common.roughness));
    add(MaterialArrays::RefractiveIndex, { "refractive index", 4.0, false },
      Colour(common.refractiveIndex));
    add(
      MaterialArrays::SolidBody, { "solid body", 1.0, false }, Colour(common.solid ? 1.0f : 0.0f));
  }

  Material Of(vtkIdType cell) const
  {
    const auto value = [&](std::size_t array) { return this->Others[array].Of(cell); };
    return { this->Diffuse.Of(cell), value(0), value(1), value(2), value(3), value(4).x, value(5).x,
      value(6).x > 0.5f };
  }

private:
  CellValues Diffuse;
  std::vector<CellValues> Others; ///< In the order of Material's members.
};

/// Finds out which materials are the same.
class MaterialIndex
{
public:
  explicit MaterialIndex(std::vector<Material>& materials)
    : Materials(materials)
  {
  }

  std::uint32_t Of(const Material& material)
  {
    Key key;
    auto next = key.begin();
    for (const Colour& share : { material.diffuseReflectance, material.specularReflectance,
           material.glossyReflectance, material.diffuseTransmittance, material.clearTransmittance,
           Colour(material.roughness, material.refractiveIndex, material.solid ? 1.0f : 0.0f) })
    {
      next = std::copy(&share.x, &share.x + 3, next);
    }
    const auto [place, isNew] =
      this->Known.emplace(key, static_cast<std::uint32_t>(this->Materials.size()));
    if (isNew)
    {
      this->Materials.push_back(material);
    }
    return place->second;
  }

private:
  using Key = std::array<float, 18>;
  std::vector<Material>& Materials;
  std::map<Key, std::uint32_t> Known;
};

bool IsPlain(const Material& material)
{
  const PhotonTransport::ScatteringSet diffuse =
    SetOf(PhotonTransport::Scattering::DiffuseReflection);
  return (ScatteringsOf(material) & ~diffuse) == 0 && !IsColoured(material);
}

} // namespace

void DescribeMaterials(const std::vector<SceneBlock>& blocks, const SurfaceDescription& description,
  PhotonTransport::Surface& surface)
{
  const std::string problem = ProblemOf(description.material);
  if (!problem.empty())
  {
    throw InputError("the material of cells without arrays: " + problem);
  }
  const bool plain = IsPlain(description.material) &&
    std::all_of(blocks.begin(), blocks.end(),
      [&](const SceneBlock& block) { return IsPlain(block, description); });
  MaterialIndex index(surface.materials);
  for (const SceneBlock& block : blocks)
  {
    if (plain)
    {
      const CellValues diffuse = DiffuseOf(block, description);
      for (const vtkIdType cell : block.cellOfFacet)
      {
        surface.reflectance.push_back(diffuse.Of(cell).x);
      }
      continue;
    }
    const BlockMaterials materials(block, description);
    for (const vtkIdType cell : block.cellOfFacet)
    {
      surface.materialOfFacet.push_back(index.Of(materials.Of(cell)));
    }
  }
}
