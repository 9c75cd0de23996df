// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/materials/MaterialCells.h"

#include "Illumination/materials/MaterialArrays.h"
#include "Illumination/pipeline/InputError.h"
#include "Illumination/surface/GhostCells.h"
#include "Illumination/surface/InputChecks.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <array>
#include <limits>
#include <sstream>

namespace
{

using PhotonTransport::Colour;
using PhotonTransport::Material;

/// All numbers of a material, in the order of Arrays.
using Numbers = std::array<float, 18>;

struct MaterialArray
{
  const char* name;
  std::size_t first; ///< In Numbers.
  int components;
  float smallest;
  float largest;
  const char* range;
};

constexpr std::size_t Shares = 5; ///< The first of Arrays: they sum to at most 1 in each channel.

constexpr std::array<MaterialArray, 8> Arrays{ {
  { MaterialArrays::DiffuseReflectance, 0, 3, 0.0f, 1.0f, "within [0, 1]" },
  { MaterialArrays::SpecularReflectance, 3, 3, 0.0f, 1.0f, "within [0, 1]" },
  { MaterialArrays::GlossyReflectance, 6, 3, 0.0f, 1.0f, "within [0, 1]" },
  { MaterialArrays::DiffuseTransmittance, 9, 3, 0.0f, 1.0f, "within [0, 1]" },
  { MaterialArrays::ClearTransmittance, 12, 3, 0.0f, 1.0f, "within [0, 1]" },
  { MaterialArrays::Roughness, 15, 1, std::numeric_limits<float>::min(), 1.0f, "within (0, 1]" },
  { MaterialArrays::RefractiveIndex, 16, 1, 1.0f, 4.0f, "within [1, 4]" },
  { MaterialArrays::SolidBody, 17, 1, 0.0f, 1.0f, "0 or 1" },
} };

constexpr std::array<const char*, 3> Channels{ "red", "green", "blue" };

Numbers NumbersOf(const Material& m)
{
  const Colour &d = m.diffuseReflectance, &s = m.specularReflectance, &g = m.glossyReflectance;
  const Colour &t = m.diffuseTransmittance, &c = m.clearTransmittance;
  return { d.x, d.y, d.z, s.x, s.y, s.z, g.x, g.y, g.z, t.x, t.y, t.z, c.x, c.y, c.z, m.roughness,
    m.refractiveIndex, m.solid ? 1.0f : 0.0f };
}

/// What a cell is that nobody has given a material.
Numbers Neutral()
{
  Material grey;
  grey.diffuseReflectance = Colour(0.5f);
  return NumbersOf(grey);
}

void RequireRanges(const Numbers& numbers, const std::string& where)
{
  for (const MaterialArray& array : Arrays)
  {
    for (int c = 0; c < array.components; ++c)
    {
      const float value = numbers[array.first + static_cast<std::size_t>(c)];
      const bool inRange = value >= array.smallest && value <= array.largest; // not for NaN
      const bool isFlag = array.name == MaterialArrays::SolidBody;
      if (!inRange || (isFlag && value != 0.0f && value != 1.0f))
      {
        std::ostringstream message;
        message << where << array.name;
        if (array.components == 3)
        {
          message << " (" << Channels[static_cast<std::size_t>(c)] << ")";
        }
        message << " is " << value << "; it must be " << array.range;
        throw InputError(message.str());
      }
    }
  }
}

void RequireShares(const Numbers& numbers, const std::string& where)
{
  constexpr double Rounding = 1e-6; // 5 numbers up to 1 in single precision: 5 * 6e-8
  for (std::size_t channel = 0; channel < 3; ++channel)
  {
    double sum = 0.0;
    for (std::size_t i = 0; i < Shares; ++i)
    {
      sum += static_cast<double>(numbers[Arrays[i].first + channel]);
    }
    if (sum > 1.0 + Rounding)
    {
      std::ostringstream message;
      message << where
              << "diffuse, specular and glossy reflectance, diffuse and clear transmittance"
              << " of the channel " << Channels[channel] << " sum to " << sum
              << "; they must not exceed 1 together";
      throw InputError(message.str());
    }
  }
}

void RequireValid(const Numbers& numbers, const std::string& where)
{
  RequireRanges(numbers, where);
  RequireShares(numbers, where);
}

/// A new array with what the cells have, or with the neutral material's values.
vtkSmartPointer<vtkFloatArray> Copy(
  vtkPolyData* data, const std::string& block, const MaterialArray& array)
{
  auto values = vtkSmartPointer<vtkFloatArray>::New();
  values->SetName(array.name);
  values->SetNumberOfComponents(array.components);
  values->SetNumberOfTuples(data->GetNumberOfCells());
  const bool given = data->GetCellData()->HasArray(array.name) != 0;
  vtkDataArray* source =
    given ? CheckedCellArray(data, array.name, block, array.components == 3) : nullptr;
  const Numbers neutral = Neutral();
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    for (int c = 0; c < array.components; ++c)
    {
      const int from = given && source->GetNumberOfComponents() == 1 ? 0 : c; // 1 stands for grey
      values->SetTypedComponent(cell, c,
        given ? static_cast<float>(source->GetComponent(cell, from))
              : neutral[array.first + static_cast<std::size_t>(c)]);
    }
  }
  return values;
}

using ArrayValues = std::array<vtkSmartPointer<vtkFloatArray>, Arrays.size()>;

Numbers NumbersOf(const ArrayValues& values, vtkIdType cell)
{
  Numbers numbers{};
  for (std::size_t i = 0; i < Arrays.size(); ++i)
  {
    values[i]->GetTypedTuple(cell, numbers.data() + Arrays[i].first);
  }
  return numbers;
}

} // namespace

void RequireValid(const Material& material, const std::string& where)
{
  RequireValid(NumbersOf(material), where);
}

void WriteMaterial(vtkPolyData* data, const std::string& block, const std::vector<bool>& chosen,
  const Material& material)
{
  ArrayValues values;
  for (std::size_t i = 0; i < Arrays.size(); ++i)
  {
    values[i] = Copy(data, block, Arrays[i]);
  }
  const Numbers wanted = NumbersOf(material);
  const GhostCells ghosts(data, block);
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    if (!chosen[static_cast<std::size_t>(cell)])
    {
      if (ghosts.IsGhost(cell))
      {
        continue; // never looked at, whatever it holds
      }
      const Numbers kept = NumbersOf(values, cell);
      RequireValid(kept, "cell " + std::to_string(cell) + block + ": ");
      continue;
    }
    for (std::size_t i = 0; i < Arrays.size(); ++i)
    {
      values[i]->SetTypedTuple(cell, wanted.data() + Arrays[i].first);
    }
  }
  for (const auto& array : values)
  {
    data->GetCellData()->AddArray(array);
  }
}
