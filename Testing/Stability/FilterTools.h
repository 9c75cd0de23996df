// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Messages.h"
#include "OutputData.h"

#include "vtkIlluminationMap.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <string>

class vtkDataArray;

/// The filter on a small sphere, or what a test makes of it, and all that VTK says meanwhile.
class FilterTest : public ::testing::Test
{
protected:
  /// @param protects What these tests protect against, for the table.
  explicit FilterTest(const char* protects)
    : Protects(protects)
  {
  }

  void SetUp() override;
  void TearDown() override;

  /// Runs the filter again, whatever it has.
  void Run();
  /// One error that says `words`, no warning; the input passes through untouched, without a map;
  /// and the filter makes a map once it is given the sphere.
  void ExpectError(const std::string& words);
  /// No error, no warning but of missing light where that may be, and a map of finite values.
  void ExpectMap();
  /// No warning, or where light may be missing one that says so.
  void ExpectNoOtherWarning();

  vtkDataArray* OutputArray(const char* name) const;
  /// The output's Notes, a line each.
  std::string Notes() const;

  /// What was measured, for the table; otherwise that tells the numbers of refusals and maps.
  void Measured(const std::string& what);

  bool LightMayBeMissing = false; ///< One warning may say that light met no front.
  vtkSmartPointer<vtkPolyData> Surface;
  vtkNew<vtkIlluminationMap> Filter;
  CaughtMessages Messages;

private:
  std::string Protects;
  std::string WhatWasMeasured;
  int Refusals = 0;
  int Maps = 0;
};

/// A sphere of 50 points with normals.
vtkSmartPointer<vtkPolyData> SmallSphere();

/// Every point of every array of doubles is finite.
bool AllFinite(vtkPolyData* data);
