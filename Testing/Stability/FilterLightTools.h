// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "FilterTools.h"
#include "RoomMesh.h"

#include "vtkMultiBlockDataSet.h"

#include <map>
#include <vector>

using Values = std::vector<double>;

/// Point arrays of light and of its error, components one after the other.
using LightArrays = std::map<std::string, Values>;

double RootMeanSquare(const Values& values);

/// Standard error over illuminance, both as root mean squares.
double RelativeNoise(const LightArrays& light);

/// Rectangle from a corner along u and v with m x n squares, its front at u x v.
vtkSmartPointer<vtkPolyData> Patch(
  const Point& corner, const Point& u, const Point& v, int m, int n);

/// Sets a cell array to one value.
void SetCells(vtkPolyData* data, const char* array, double value);

vtkSmartPointer<vtkMultiBlockDataSet> Blocks(
  const std::vector<vtkSmartPointer<vtkPolyData>>& blocks);

/// Light in scenes of several surfaces, against light in scenes of fewer. The lamp is the sun, 1000
/// lx across its light, and surfaces reflect nothing, unless a test changes that.
class FilterLightTest : public FilterTest
{
protected:
  using FilterTest::FilterTest;

  void SetUp() override;

  /// The light on each block, or on the one surface. There may be no error, and there must be that
  /// many warnings.
  std::vector<LightArrays> Light(vtkDataObject* input, int warnings = 0);

  double FieldValue(const char* name);

  /// All arrays must be those of a surface alone, over and over, up to a share of the root mean
  /// square of each. For the same photons that share may be far less than the noise.
  void ExpectLightOf(const LightArrays& alone, const LightArrays& light, double share);

  int Compared = 0;          ///< Surfaces.
  double LargestShare = 0.0; ///< By which values differed.
};
