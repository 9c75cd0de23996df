// SPDX-License-Identifier: BSD-3-Clause
// The material filter: what it writes where, what it keeps, presets, blocks, errors.
#include "TestTools.h"

#include "vtkSurfaceMaterial.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFloatArray.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPlaneSource.h"
#include "vtkPointSet.h"
#include "vtkStringArray.h"
#include "vtkTestErrorObserver.h"
#include "vtkUnstructuredGrid.h"

#include <array>
#include <cmath>
#include <sstream>
#include <vector>

namespace
{

const std::vector<std::string> ColourNames{ "DiffuseReflectance", "SpecularReflectance",
  "GlossyReflectance", "DiffuseTransmittance", "ClearTransmittance" };
const std::vector<std::string> NumberNames{ "Roughness", "RefractiveIndex", "SolidBody" };

/// Four cells.
vtkSmartPointer<vtkPolyData> Plane()
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(2, 2);
  plane->Update();
  return plane->GetOutput();
}

template <typename Array>
void AddCells(vtkPolyData* data, const char* name, int components, std::vector<double> values)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const auto id = static_cast<vtkIdType>(i);
    array->SetComponent(id / components, static_cast<int>(id % components), values[i]);
  }
  data->GetCellData()->AddArray(array);
}

double Value(vtkPolyData* data, const std::string& array, vtkIdType cell = 0, int component = 0)
{
  auto* values = vtkFloatArray::SafeDownCast(data->GetCellData()->GetArray(array.c_str()));
  return values ? values->GetComponent(cell, component) : -1.0;
}

bool HasMaterial(vtkPolyData* data)
{
  for (const auto& [names, components] :
    { std::make_pair(ColourNames, 3), std::make_pair(NumberNames, 1) })
  {
    for (const std::string& name : names)
    {
      vtkDataArray* array = data->GetCellData()->GetArray(name.c_str());
      if (!vtkFloatArray::SafeDownCast(array) || array->GetNumberOfComponents() != components ||
        array->GetNumberOfTuples() != data->GetNumberOfCells())
      {
        return false;
      }
    }
  }
  return true;
}

/// The error that an execution gives; empty if it gives none.
std::string ErrorOf(vtkSurfaceMaterial* filter)
{
  vtkNew<vtkTest::ErrorObserver> observer;
  const unsigned long tag = filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->Update();
  filter->RemoveObserver(tag);
  return observer->GetErrorMessage();
}

void CheckCustom(Checks& check)
{
  const auto plane = Plane();
  vtkNew<vtkSurfaceMaterial> filter;
  filter->SetInputData(plane);
  filter->SetDiffuseReflectance(0.125, 0.25, 0.375);
  filter->SetSpecularReflectance(0.0625, 0.125, 0.1875);
  filter->SetGlossyReflectance(0.03125, 0.0625, 0.09375);
  filter->SetDiffuseTransmittance(0.1, 0.0, 0.0);
  filter->SetClearTransmittance(0.5, 0.25, 0.125);
  filter->SetRoughness(0.5);
  filter->SetRefractiveIndex(2.0);
  filter->SetSolidBody(true);
  filter->Update();
  vtkPolyData* output = filter->GetOutput();
  check(HasMaterial(output), "all arrays are there");
  check(!plane->GetCellData()->HasArray("Roughness"), "the input has no new arrays");
  for (vtkIdType cell = 0; cell < 4; ++cell)
  {
    for (int c = 0; c < 3; ++c)
    {
      const double share = 0.125 * (c + 1);
      check(Value(output, "DiffuseReflectance", cell, c) == share &&
          Value(output, "SpecularReflectance", cell, c) == share / 2 &&
          Value(output, "GlossyReflectance", cell, c) == share / 4,
        "reflectances are as they were set");
    }
    check(Value(output, "DiffuseTransmittance", cell, 0) == static_cast<double>(0.1f) &&
        Value(output, "ClearTransmittance", cell, 1) == 0.25,
      "so are transmittances");
    check(Value(output, "Roughness", cell) == 0.5 &&
        Value(output, "RefractiveIndex", cell) == 2.0 && Value(output, "SolidBody", cell) == 1.0,
      "and the numbers");
  }
}

void CheckPresets(Checks& check)
{
  vtkNew<vtkSurfaceMaterial> filter;
  filter->SetInputData(Plane());
  const auto is = [&](int preset, const std::string& array, double expected)
  {
    filter->SetPreset(preset);
    filter->Update();
    check(std::abs(Value(filter->GetOutput(), array) - expected) < 1e-7, // half a float's step
      array + " of preset " + std::to_string(preset));
  };
  is(vtkSurfaceMaterial::WHITE_PAINT, "DiffuseReflectance", 0.85);
  is(vtkSurfaceMaterial::MID_GREY, "DiffuseReflectance", 0.5);
  is(vtkSurfaceMaterial::PLASTER, "DiffuseReflectance", 0.75);
  is(vtkSurfaceMaterial::CONCRETE, "DiffuseReflectance", 0.25);
  is(vtkSurfaceMaterial::BLACK_PAINT, "DiffuseReflectance", 0.05);
  is(vtkSurfaceMaterial::FABRIC, "DiffuseTransmittance", 0.4);
  is(vtkSurfaceMaterial::ALUMINIUM, "GlossyReflectance", 0.85);
  is(vtkSurfaceMaterial::MIRROR, "SpecularReflectance", 0.9);
  is(vtkSurfaceMaterial::MIRROR, "DiffuseReflectance", 0.0);
  is(vtkSurfaceMaterial::CLEAR_GLASS, "SolidBody", 0.0);

  // The custom values are out of range and must not matter.
  filter->SetDiffuseReflectance(2.0, 2.0, 2.0);
  for (int p = vtkSurfaceMaterial::WHITE_PAINT; p <= vtkSurfaceMaterial::FROSTED_GLASS; ++p)
  {
    filter->SetPreset(p);
    check(ErrorOf(filter).empty() && HasMaterial(filter->GetOutput()),
      "preset " + std::to_string(p) + " is a material");
  }
}

/// Wood is the measured colour in CIELAB, by ISO/CIE 11664-4 and IEC 61966-2-1, to two digits.
void CheckWood(Checks& check)
{
  const double f = (65.5 + 16.0) / 116.0;
  const double x = 0.95047 * std::pow(f + 8.8 / 500.0, 3);
  const double y = std::pow(f, 3);
  const double z = 1.08883 * std::pow(f - 20.7 / 200.0, 3);
  const std::array<double, 3> rgb{ 3.2406 * x - 1.5372 * y - 0.4986 * z,
    -0.9689 * x + 1.8758 * y + 0.0415 * z, 0.0557 * x - 0.2040 * y + 1.0570 * z };
  vtkNew<vtkSurfaceMaterial> filter;
  filter->SetInputData(Plane());
  filter->SetPreset(vtkSurfaceMaterial::WOOD);
  filter->Update();
  for (int c = 0; c < 3; ++c)
  {
    const double value = Value(filter->GetOutput(), "DiffuseReflectance", 0, c);
    check(std::abs(value - rgb[static_cast<std::size_t>(c)]) < 0.005, "wood is oak");
  }
}

struct Pane
{
  double transmittance;
  double reflectance;
};

/// A thin pane by Fresnel's formulae, all inner reflections, mean of the two polarisations; M. Born
/// and E. Wolf, Principles of Optics, 1.5.3 and 7.6.1 (sums of intensities).
Pane PaneAt(double cosine, double index, double internal)
{
  const double inside = std::sqrt(1.0 - (1.0 - cosine * cosine) / (index * index));
  const double t = std::pow(internal, 1.0 / inside);
  const double s = std::pow((cosine - index * inside) / (cosine + index * inside), 2);
  const double p = std::pow((index * cosine - inside) / (index * cosine + inside), 2);
  Pane pane{ 0.0, 0.0 };
  for (const double r : { s, p })
  {
    const double through = (1.0 - r) * (1.0 - r) * t / (1.0 - r * r * t * t);
    pane.transmittance += through / 2.0;
    pane.reflectance += (r + through * r * t) / 2.0;
  }
  return pane;
}

void CheckGlass(Checks& check)
{
  vtkNew<vtkSurfaceMaterial> filter;
  filter->SetInputData(Plane());
  filter->SetPreset(vtkSurfaceMaterial::CLEAR_GLASS);
  filter->Update();
  const double index = Value(filter->GetOutput(), "RefractiveIndex");
  const double internal = Value(filter->GetOutput(), "ClearTransmittance");
  // EnergyPlus, CLEAR 6MM: 0.881 and 0.080; the internal transmittance has two digits, so 0.005.
  const Pane straight = PaneAt(1.0, index, internal);
  check(std::abs(straight.transmittance - 0.881) < 0.005, "clear glass transmits 0.881");
  check(std::abs(straight.reflectance - 0.080) < 0.005, "clear glass reflects 0.080");

  Pane diffuse{ 0.0, 0.0 };
  const int steps = 1000; // midpoint rule in cosine^2, far finer than two digits
  for (int i = 0; i < steps; ++i)
  {
    const Pane pane = PaneAt(std::sqrt((i + 0.5) / steps), index, internal);
    diffuse.transmittance += pane.transmittance / steps;
    diffuse.reflectance += pane.reflectance / steps;
  }
  filter->SetPreset(vtkSurfaceMaterial::FROSTED_GLASS);
  filter->Update();
  vtkPolyData* frosted = filter->GetOutput();
  check(std::abs(Value(frosted, "DiffuseTransmittance") - diffuse.transmittance) < 0.005 &&
      std::abs(Value(frosted, "DiffuseReflectance") - diffuse.reflectance) < 0.005,
    "frosted glass is clear glass without direction");
}

void CheckCells(Checks& check)
{
  const auto plane = Plane();
  AddCells<vtkIntArray>(plane, "Part", 1, { 7, 8, 7, 9 });
  AddCells<vtkDoubleArray>(plane, "DiffuseReflectance", 1, { 0.125, 0.25, 0.375, 0.625 });
  vtkDataArray* before = plane->GetCellData()->GetArray("DiffuseReflectance");
  vtkNew<vtkSurfaceMaterial> mirror;
  mirror->SetInputData(plane);
  mirror->SetPreset(vtkSurfaceMaterial::MIRROR);
  mirror->SetCellArray("Part");
  mirror->SetCellValue(7);
  vtkNew<vtkSurfaceMaterial> glass;
  glass->SetInputConnection(mirror->GetOutputPort());
  glass->SetPreset(vtkSurfaceMaterial::CLEAR_GLASS);
  glass->SetCellArray("Part");
  glass->SetCellValue(9);
  glass->Update();
  vtkPolyData* first = mirror->GetOutput();
  vtkPolyData* second = glass->GetOutput();
  check(HasMaterial(first) && HasMaterial(second), "a chain writes the same arrays");
  check(plane->GetCellData()->GetArray("DiffuseReflectance") == before &&
      before->GetComponent(0, 0) == 0.125 && before->GetNumberOfComponents() == 1,
    "the input's array is untouched");
  for (int c = 0; c < 3; ++c)
  {
    check(Value(first, "DiffuseReflectance", 0, c) == 0.0, "a chosen cell is a mirror");
    check(Value(first, "DiffuseReflectance", 1, c) == 0.25, "others keep what they have, grey");
    check(Value(second, "DiffuseReflectance", 1, c) == 0.25, "in a chain too");
  }
  check(Value(first, "RefractiveIndex", 1) == 1.0 && Value(first, "SpecularReflectance", 1) == 0.0,
    "where there was no array, cells are neutral");
  check(Value(second, "SpecularReflectance", 2) == static_cast<double>(0.9f), "the mirror stays");
  check(Value(second, "ClearTransmittance", 3) > 0.9 && Value(second, "DiffuseReflectance", 3) == 0,
    "the glass comes");
  check(
    Value(first, "ClearTransmittance", 3) == 0.0 && Value(first, "DiffuseReflectance", 3) == 0.625,
    "and does not reach back into the filter before it");
}

vtkPolyData* Leaf(vtkSurfaceMaterial* filter, unsigned int flatIndex)
{
  auto* tree = vtkDataObjectTree::SafeDownCast(filter->GetOutputDataObject(0));
  auto it = vtk::TakeSmartPointer(tree->NewTreeIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    if (it->GetCurrentFlatIndex() == flatIndex)
    {
      return vtkPolyData::SafeDownCast(it->GetCurrentDataObject());
    }
  }
  return nullptr;
}

/// 0 root { 1 surface, 2 { 3 surface, 4 empty, 5 surface }, 6 surface, 7 grid }
vtkSmartPointer<vtkMultiBlockDataSet> MultiBlock()
{
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, Plane());
  inner->SetBlock(2, Plane());
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  blocks->SetBlock(0, Plane());
  blocks->SetBlock(1, inner);
  blocks->SetBlock(2, Plane());
  blocks->SetBlock(3, vtkNew<vtkUnstructuredGrid>());
  return blocks;
}

void CheckBlocks(Checks& check)
{
  vtkNew<vtkSurfaceMaterial> filter;
  filter->SetInputData(MultiBlock());
  filter->SetPreset(vtkSurfaceMaterial::MIRROR);
  const auto expect = [&](const std::vector<int>& added, const std::vector<unsigned int>& mirrors,
                        const std::vector<unsigned int>& all)
  {
    filter->RemoveAllBlocks();
    for (const int block : added)
    {
      filter->AddBlock(block);
    }
    filter->Update();
    for (const unsigned int index : all)
    {
      vtkPolyData* leaf = Leaf(filter, index);
      const bool wanted = std::find(mirrors.begin(), mirrors.end(), index) != mirrors.end();
      const std::string where = "block " + std::to_string(index);
      check(leaf && HasMaterial(leaf), where + " has all arrays");
      check(leaf && (Value(leaf, "SpecularReflectance") > 0.0) == wanted, where + " is right");
      check(leaf && Value(leaf, "DiffuseReflectance") == (wanted ? 0.0 : 0.5), where + " too");
    }
  };
  const std::vector<unsigned int> leaves{ 1, 3, 5, 6 };
  expect({}, leaves, leaves);
  expect({ 0 }, leaves, leaves);
  expect({ 2 }, { 3, 5 }, leaves);
  expect({ 6, 3 }, { 3, 6 }, leaves);
  expect({ 2, 3 }, { 3, 5 }, leaves); // one within the other
  check(filter->GetNumberOfBlocks() == 2 && filter->HasBlock(3) && !filter->HasBlock(5),
    "blocks are listed");

  vtkNew<vtkPartitionedDataSetCollection> collection; // 0 { 1 { 2 }, 3 { 4, 5 } }
  collection->SetPartition(0, 0, Plane());
  collection->SetPartition(1, 0, Plane());
  collection->SetPartition(1, 1, Plane());
  filter->SetInputData(collection);
  expect({ 3 }, { 4, 5 }, { 2, 4, 5 });
  expect({ 2, 5 }, { 2, 5 }, { 2, 4, 5 });
  vtkNew<vtkPartitionedDataSet> partitions;
  partitions->SetPartition(0, Plane());
  partitions->SetPartition(1, Plane());
  filter->SetInputData(partitions);
  expect({ 2 }, { 2 }, { 1, 2 });
}

/// Expects the message, and the input without new arrays.
void ExpectError(vtkSurfaceMaterial* filter, const std::string& message, Checks& check)
{
  const std::string error = ErrorOf(filter);
  check(
    error.find(message) != std::string::npos, "expected '" + message + "', not '" + error + "'");
  auto* output = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(0));
  output = output ? output : Leaf(filter, 1);
  check(output && output->GetNumberOfPoints() == 9 && !HasMaterial(output),
    "the input passes through after '" + message + "'");
}

void CheckSettingErrors(Checks& check)
{
  vtkNew<vtkSurfaceMaterial> filter;
  filter->SetInputData(Plane());
  filter->SetDiffuseReflectance(0.5, 1.25, 0.5);
  ExpectError(filter, "DiffuseReflectance (green) is 1.25; it must be within [0, 1]", check);
  filter->SetDiffuseReflectance(0.5, 0.5, std::nan(""));
  ExpectError(filter, "DiffuseReflectance (blue) is nan", check);
  filter->SetDiffuseReflectance(0.25, 0.5, 0.25);
  filter->SetClearTransmittance(-0.5, 0.0, 0.0);
  ExpectError(filter, "ClearTransmittance (red) is -0.5", check);
  filter->SetClearTransmittance(0.25, 0.25, 0.25);
  filter->SetGlossyReflectance(0.5, 0.5, 0.5);
  ExpectError(filter, "of the channel green sum to 1.25; they must not exceed 1 together", check);
  filter->SetGlossyReflectance(0.0, 0.0, 0.0);
  filter->SetRoughness(0.0);
  ExpectError(filter, "Roughness is 0; it must be within (0, 1]", check);
  filter->SetRoughness(1.0);
  filter->SetRefractiveIndex(0.75);
  ExpectError(filter, "RefractiveIndex is 0.75; it must be within [1, 4]", check);
  filter->SetRefractiveIndex(4.0);
  check(ErrorOf(filter).empty() && HasMaterial(filter->GetOutput()), "after errors it works");
  // Thirds and fifths that are 1 together must not fail for their rounding.
  filter->SetDiffuseReflectance(1.0 / 3, 0.2, 0.7);
  filter->SetGlossyReflectance(1.0 / 3, 0.6, 0.1);
  filter->SetClearTransmittance(1.0 / 3, 0.2, 0.2);
  check(ErrorOf(filter).empty(), "shares that sum to 1 are fine");
}

void CheckPlaceErrors(Checks& check)
{
  vtkNew<vtkSurfaceMaterial> filter;
  filter->SetInputData(MultiBlock());
  filter->AddBlock(9);
  ExpectError(
    filter, "there is no block 9; the flat indices of the input's blocks are 0 to 7", check);
  filter->RemoveAllBlocks();
  filter->AddBlock(-1);
  ExpectError(filter, "there is no block -1", check);
  filter->RemoveAllBlocks();
  filter->AddBlock(7);
  ExpectError(filter, "none of the chosen blocks is a surface", check);
  filter->RemoveAllBlocks();
  filter->AddBlock(3);
  filter->SetCellArray("Part");
  ExpectError(filter, "there is no cell array 'Part' of block 3", check);

  const auto plane = Plane();
  AddCells<vtkIntArray>(plane, "Part", 1, { 7, 8, 7, 9 });
  filter->SetInputData(plane);
  filter->SetCellValue(5);
  ExpectError(filter, "no cell has the value 5 in cell array 'Part'", check);
  filter->SetCellArray("None");
  check(ErrorOf(filter).empty(), "None is no array, and a single surface has no blocks");
}

void CheckArrayErrors(Checks& check)
{
  vtkNew<vtkSurfaceMaterial> filter;
  filter->SetCellArray("Part");
  filter->SetCellValue(7);
  const auto expect = [&](const std::string& message, const auto& spoil)
  {
    const auto plane = Plane();
    AddCells<vtkIntArray>(plane, "Part", 1, { 7, 8, 7, 9 });
    spoil(plane.Get());
    filter->SetInputData(plane);
    ExpectError(filter, message, check);
  };
  expect("cell array 'Roughness' has 3 components; 1 is wanted",
    [](vtkPolyData* data)
    { AddCells<vtkFloatArray>(data, "Roughness", 3, std::vector<double>(12)); });
  expect("cell array 'DiffuseReflectance' has 2 components; 1 or 3 are wanted",
    [](vtkPolyData* data)
    { AddCells<vtkFloatArray>(data, "DiffuseReflectance", 2, std::vector<double>(8)); });
  expect("cell array 'DiffuseReflectance' has 3 values for 4 cells",
    [](vtkPolyData* data)
    { AddCells<vtkFloatArray>(data, "DiffuseReflectance", 1, std::vector<double>(3)); });
  expect("cell array 'SolidBody' is a vtkStringArray, not numbers",
    [](vtkPolyData* data)
    {
      vtkNew<vtkStringArray> text;
      text->SetName("SolidBody");
      text->SetNumberOfTuples(4);
      data->GetCellData()->AddArray(text);
    });
  expect("cell 3: SolidBody is 0.5; it must be 0 or 1",
    [](vtkPolyData* data) {
      AddCells<vtkFloatArray>(data, "SolidBody", 1, { 9, 1, 9, 0.5 });
    });
  expect("cell 1: diffuse, specular and glossy reflectance, diffuse and clear transmittance of the "
         "channel red sum to 1.5",
    [](vtkPolyData* data) {
      AddCells<vtkFloatArray>(data, "ClearTransmittance", 1, { 1, 1, 1, 1 });
    });
}

void CheckDefaultsAndPrint(Checks& check)
{
  vtkNew<vtkSurfaceMaterial> filter;
  filter->AddBlock(4);
  filter->AddBlock(2);
  filter->SetCellArray("Part");
  std::ostringstream text;
  filter->Print(text);
  for (const std::string& line : { "Preset: 0", "DiffuseReflectance: 0.5 0.5 0.5",
         "SpecularReflectance: 0 0 0", "GlossyReflectance: 0 0 0", "Roughness: 0.3",
         "DiffuseTransmittance: 0 0 0", "ClearTransmittance: 0 0 0", "RefractiveIndex: 1.5",
         "SolidBody: 0", "Blocks: 2 4", "CellArray: Part", "CellValue: 0" })
  {
    check(text.str().find(line + "\n") != std::string::npos, "PrintSelf says " + line);
  }
}

} // namespace

int TestSurfaceMaterial(int, char*[])
{
  Checks check;
  CheckCustom(check);
  CheckPresets(check);
  CheckWood(check);
  CheckGlass(check);
  CheckCells(check);
  CheckBlocks(check);
  CheckSettingErrors(check);
  CheckPlaceErrors(check);
  CheckArrayErrors(check);
  CheckDefaultsAndPrint(check);
  return check.Failures();
}
