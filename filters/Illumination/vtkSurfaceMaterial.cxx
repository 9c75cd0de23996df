// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceMaterial.h"

#include "Illumination/materials/MaterialCells.h"
#include "Illumination/materials/MaterialPresets.h"
#include "Illumination/materials/OpeningCells.h"
#include "Illumination/pipeline/InputError.h"
#include "Illumination/pipeline/Pipeline.h"
#include "Illumination/surface/ChosenBlocks.h"
#include "Illumination/surface/InputChecks.h"

#include "vtkDataArray.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <sstream>
#include <vector>

using namespace Illumination;

vtkStandardNewMacro(vtkSurfaceMaterial);

static_assert(static_cast<int>(MaterialPreset::WhitePaint) == vtkSurfaceMaterial::WHITE_PAINT &&
  static_cast<int>(MaterialPreset::Opening) == vtkSurfaceMaterial::OPENING);

namespace
{

/// A flag for each cell. @param cellArray Empty for all cells of a chosen block.
std::vector<bool> ChosenCells(const ChosenBlock& block, const std::string& cellArray, double value)
{
  std::vector<bool> chosen(static_cast<std::size_t>(block.data->GetNumberOfCells()), block.chosen);
  if (block.chosen && !cellArray.empty())
  {
    vtkDataArray* values = CheckedCellArray(block.data, cellArray, block.name, false);
    for (std::size_t cell = 0; cell < chosen.size(); ++cell)
    {
      chosen[cell] = values->GetComponent(static_cast<vtkIdType>(cell), 0) == value;
    }
  }
  return chosen;
}

PhotonTransport::Colour Colour(const double rgb[3])
{
  return { rgb[0], rgb[1], rgb[2] };
}

PhotonTransport::Material MaterialOf(vtkSurfaceMaterial* filter)
{
  if (filter->GetPreset() != vtkSurfaceMaterial::CUSTOM)
  {
    return MaterialOf(static_cast<MaterialPreset>(filter->GetPreset()));
  }
  PhotonTransport::Material material;
  material.diffuseReflectance = Colour(filter->GetDiffuseReflectance());
  material.specularReflectance = Colour(filter->GetSpecularReflectance());
  material.glossyReflectance = Colour(filter->GetGlossyReflectance());
  material.diffuseTransmittance = Colour(filter->GetDiffuseTransmittance());
  material.clearTransmittance = Colour(filter->GetClearTransmittance());
  material.roughness = static_cast<float>(filter->GetRoughness());
  material.refractiveIndex = static_cast<float>(filter->GetRefractiveIndex());
  material.solid = filter->GetSolidBody();
  return material;
}

PhotonTransport::OpeningMark MarkOf(vtkSurfaceMaterial* filter)
{
  using PhotonTransport::OpeningMark;
  if (filter->GetPreset() == vtkSurfaceMaterial::OPENING ||
    filter->GetOpening() == vtkSurfaceMaterial::IS_OPENING)
  {
    return OpeningMark::Opening;
  }
  return filter->GetOpening() == vtkSurfaceMaterial::NO_OPENING ? OpeningMark::NoOpening
                                                                : OpeningMark::None;
}

} // namespace

void vtkSurfaceMaterial::Execute(
  vtkDataObject*, vtkInformationVector**, vtkInformationVector* outputs)
{
  const PhotonTransport::Material material = MaterialOf(this);
  RequireValid(ValuesOf(material), "");
  const std::string cellArray = ArrayName(this->CellArray);
  bool hadChoice = false;
  bool choseAny = false;
  for (const ChosenBlock& block : ChooseBlocks(vtkDataObject::GetData(outputs), this->Blocks))
  {
    RequireValidCells(block.data, block.name);
    const std::vector<bool> chosen = ChosenCells(block, cellArray, this->CellValue);
    hadChoice = hadChoice || (block.chosen && !chosen.empty());
    choseAny = choseAny || std::find(chosen.begin(), chosen.end(), true) != chosen.end();
    WriteMaterial(block.data, block.name, chosen, material);
    WriteOpening(block.data, block.name, chosen, MarkOf(this));
  }
  if (hadChoice && !choseAny)
  {
    std::ostringstream message;
    message << "no cell has the value " << this->CellValue << " in cell array '" << cellArray
            << "', so none gets the material";
    throw InputError(message.str());
  }
}

void vtkSurfaceMaterial::AddBlock(int flatIndex)
{
  if (this->Blocks.insert(flatIndex).second)
  {
    this->Modified();
  }
}

void vtkSurfaceMaterial::RemoveAllBlocks()
{
  if (!this->Blocks.empty())
  {
    this->Blocks.clear();
    this->Modified();
  }
}

void vtkSurfaceMaterial::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const double rgb[3])
  { os << indent << name << ": " << rgb[0] << " " << rgb[1] << " " << rgb[2] << "\n"; };
  os << indent << "Preset: " << this->Preset << "\n";
  print("DiffuseReflectance", this->DiffuseReflectance);
  print("SpecularReflectance", this->SpecularReflectance);
  print("GlossyReflectance", this->GlossyReflectance);
  os << indent << "Roughness: " << this->Roughness << "\n";
  print("DiffuseTransmittance", this->DiffuseTransmittance);
  print("ClearTransmittance", this->ClearTransmittance);
  os << indent << "RefractiveIndex: " << this->RefractiveIndex << "\n"
     << indent << "SolidBody: " << this->SolidBody << "\n"
     << indent << "Opening: " << this->Opening << "\n"
     << indent << "Blocks:";
  for (const int block : this->Blocks)
  {
    os << " " << block;
  }
  os << "\n"
     << indent << "CellArray: " << this->CellArray << "\n"
     << indent << "CellValue: " << this->CellValue << "\n";
}
