// SPDX-License-Identifier: BSD-3-Clause
// The arrays that statistics are made of, checked.
#ifndef StatisticsArrays_h
#define StatisticsArrays_h

#include "Illumination/reports/NamedBlocks.h"

#include "PhotonTransport/statistics/ExtremeValue.h"

#include "vtkType.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkPolyData;
class vtkUnsignedCharArray;

namespace Illumination
{

/// Which arrays tell what.
struct StatisticsArrays
{
  std::string illuminance;         ///< Point array, lx.
  std::string standardError;       ///< Point array, lx; empty if noise is not known by one.
  std::vector<std::string> groups; ///< Point arrays of four components whose sum is the map's.
  std::string part;                ///< Cell array of numbers or text; empty: a row for each block.
  std::string valid;               ///< Point array: points where it is 0 do not count.
  std::string reflectance;         ///< Cell array; empty: DiffuseReflectance, where there is one.
  double commonReflectance;        ///< Of cells without an array.
  double metresPerUnit;
};

bool HasPointArray(vtkDataSet* data, const std::string& name);

/// The point arrays of one block. The constructor and Append throw InputError.
class LightArrays
{
public:
  LightArrays(const NamedBlock& block, const StatisticsArrays& names);

  bool IsValid(vtkIdType point) const;
  /// Whether it is a copy of another block's point, or hidden.
  bool IsGhost(vtkIdType point) const;
  /// Adds the values of a point.
  void Append(vtkIdType point, PhotonTransport::NoisyValues& light) const;
  /// Whether points stand for areas: those of vtkIlluminanceSensors' grids.
  bool HasAreas() const { return this->Areas != nullptr; }
  /// The area that a point stands for, m^2.
  double AreaOf(vtkIdType point) const { return this->Checked(this->Areas, point); }

private:
  double Checked(vtkDataArray* array, vtkIdType point) const;

  std::string Where;
  vtkDataArray* Illuminance;
  vtkDataArray* Errors = nullptr;
  vtkDataArray* Valid = nullptr;
  vtkDataArray* Areas = nullptr;
  vtkUnsignedCharArray* Ghosts;
  std::vector<vtkDataArray*> Groups;
};

/// The diffuse reflectance of a surface's cells, for white light.
class CellReflectance
{
public:
  /// Throws InputError for an array that is missing or does not fit.
  CellReflectance(vtkPolyData* data, const StatisticsArrays& names, std::string where);

  /// Throws InputError for a value out of range.
  double Of(vtkIdType cell) const;

private:
  std::string Where;
  double Common;
  vtkDataArray* Values = nullptr;
};

} // namespace Illumination

#endif
