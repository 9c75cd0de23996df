// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/appearance/CellLooks.h"

#include "Illumination/pipeline/InputError.h"
#include "Illumination/pipeline/Text.h"
#include "Illumination/surface/InputChecks.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkPolyData.h"

#include <array>
#include <map>

namespace Illumination
{
namespace
{

using PhotonTransport::Colour;

/// A cell array of colours, or of one number that stands for grey; or one value for all cells.
class CellColours
{
public:
  /// @param name Empty, or that of an array that need not be there unless `isNeeded`.
  /// @param most The largest value that is allowed.
  CellColours(const NamedSurface& block, const std::string& name, bool isNeeded, double otherwise,
    double most)
    : Name(name)
    , Block(block.name)
    , Most(most)
    , Otherwise(static_cast<float>(otherwise))
  {
    const bool isThere = !name.empty() && block.data->GetCellData()->HasArray(name.c_str()) != 0;
    this->Array = isThere || isNeeded ? CheckedCellArray(block.data, name, block.name) : nullptr;
  }

  Colour Of(vtkIdType cell) const
  {
    Colour colour(this->Otherwise);
    for (int c = 0; this->Array && c < 3; ++c)
    {
      const double value =
        this->Array->GetComponent(cell, c % this->Array->GetNumberOfComponents());
      if (!(value >= 0.0 && value <= this->Most)) // NaN too
      {
        throw InputError(Text("cell ", cell, this->Block, ": ", value, " in cell array '",
          this->Name, "' is outside [0, ", this->Most, "]"));
      }
      colour[c] = static_cast<float>(value);
    }
    return colour;
  }

private:
  vtkDataArray* Array;
  std::string Name;
  std::string Block;
  double Most;
  float Otherwise;
};

std::array<float, 9> KeyOf(const CellLook& look)
{
  std::array<float, 9> key{};
  std::size_t k = 0;
  for (const Colour* colour : { &look.reflectance, &look.transmittance, &look.exitance })
  {
    for (int c = 0; c < 3; ++c)
    {
      key[k++] = (*colour)[c];
    }
  }
  return key;
}

} // namespace

CellLooks LooksOf(const NamedSurface& block, const LookDescription& description)
{
  const CellColours reflectance(block, description.reflectanceArray,
    description.reflectanceArrayIsNamed, description.reflectance, 1.0);
  const CellColours transmittance(block, "DiffuseTransmittance", false, 0.0, 1.0);
  const CellColours exitance(
    block, description.exitanceArray, description.exitanceArrayIsNamed, 0.0, VTK_FLOAT_MAX);
  CellLooks found;
  found.first = block.data->GetNumberOfVerts() + block.data->GetNumberOfLines();
  std::map<std::array<float, 9>, std::uint32_t> known;
  for (vtkIdType cell = found.first; cell < block.data->GetNumberOfCells(); ++cell)
  {
    const CellLook look{ reflectance.Of(cell), transmittance.Of(cell), exitance.Of(cell) };
    const auto [place, isNew] =
      known.emplace(KeyOf(look), static_cast<std::uint32_t>(found.looks.size()));
    if (isNew)
    {
      found.looks.push_back(look);
    }
    found.lookOfCell.push_back(place->second);
  }
  return found;
}

} // namespace Illumination
