// SPDX-License-Identifier: BSD-3-Clause
// Colours and lamps apart, and their standard errors.
#include "GatheringTools.h"
#include "OutputData.h"

#include "vtkIlluminationMap.h"
#include "vtkLuminaireSource.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace
{

/// A room that reflects much red and little blue.
vtkSmartPointer<vtkPolyData> ColouredRoom()
{
  auto room = RoundRoom(12);
  vtkNew<vtkDoubleArray> reflectance;
  reflectance->SetName("DiffuseReflectance");
  reflectance->SetNumberOfComponents(3);
  reflectance->SetNumberOfTuples(room->GetNumberOfCells());
  const double own[3] = { 0.8, 0.5, 0.2 };
  for (vtkIdType c = 0; c < room->GetNumberOfCells(); ++c)
  {
    reflectance->SetTuple(c, own);
  }
  room->GetCellData()->AddArray(reflectance);
  return room;
}

/// Lit by a strong and a weak lamp.
vtkSmartPointer<vtkIlluminationMap> Lit(int seed, int sampling, vtkIdType photons)
{
  auto map = vtkSmartPointer<vtkIlluminationMap>::New();
  map->SetInputData(ColouredRoom());
  static const auto strong = PointLamp(0.1, 0.05, 0.15, 900.0, "Strong");
  static const auto weak = PointLamp(-0.2, 0.1, 0.0, 100.0, "Weak");
  map->AddLuminaireConnection(strong->GetOutputPort());
  map->AddLuminaireConnection(weak->GetOutputPort());
  map->SetLampContributions(true);
  map->SetSampling(sampling);
  map->SetSeed(seed);
  map->SetPhotons(photons);
  map->Update();
  return map;
}

/// Of the values that one component of an array has in independent maps.
class Calibration
{
public:
  void Add(vtkDataArray* values, vtkDataArray* errors, int component)
  {
    const auto number = static_cast<std::size_t>(values->GetNumberOfTuples());
    this->Sum.resize(number, 0.0);
    this->Squares.resize(number, 0.0);
    for (std::size_t i = 0; i < number; ++i)
    {
      const double value = values->GetComponent(static_cast<vtkIdType>(i), component);
      this->Sum[i] += value;
      this->Squares[i] += value * value;
      this->Told += std::pow(errors->GetComponent(static_cast<vtkIdType>(i), component), 2.0);
    }
    ++this->Maps;
  }

  /// RMS of what errors are said to be, by the RMS of what they are.
  double ToldOverTrue() const
  {
    double variances = 0.0;
    for (std::size_t i = 0; i < this->Sum.size(); ++i)
    {
      variances +=
        (this->Squares[i] - this->Sum[i] * this->Sum[i] / this->Maps) / (this->Maps - 1.0);
    }
    return std::sqrt(this->Told / this->Maps / variances);
  }

private:
  std::vector<double> Sum, Squares;
  double Told = 0.0;
  double Maps = 0.0;
};

/// The sampling, and how many photons.
class PartErrors : public ::testing::TestWithParam<std::tuple<int, vtkIdType>>
{
};

} // namespace

// With random numbers the errors must be right; a sequence that spreads photons evenly may make
// them smaller than what is told, by the root of 1.5 at most where hits are as if by chance.
TEST_P(PartErrors, AreWhatMapsOfOtherSeedsDifferBy)
{
  constexpr int Seeds = 60;
  const auto [sampling, photons] = GetParam();
  std::map<std::string, Calibration> parts;
  for (int seed = 1; seed <= Seeds; ++seed)
  {
    const auto map = Lit(seed, sampling, photons);
    for (int c = 0; c < 3; ++c)
    {
      parts["channel " + std::to_string(c)].Add(PointArray(map->GetOutput(), "IlluminanceRGB"),
        PointArray(map->GetOutput(), "StandardErrorRGB"), c);
    }
    for (const std::string lamp : { "Strong", "Weak" })
    {
      parts[lamp].Add(PointArray(map->GetOutput(), ("Illuminance_" + lamp).c_str()),
        PointArray(map->GetOutput(), ("StandardError_" + lamp).c_str()), 0);
    }
  }
  // 60 maps of some hundred points: a standard deviation of the ratio below 3 %.
  for (const auto& [name, part] : parts)
  {
    EXPECT_GT(part.ToldOverTrue(), 0.9) << name;
    EXPECT_LT(part.ToldOverTrue(), sampling == vtkIlluminationMap::SOBOL ? 1.35 : 1.25) << name;
  }
}

INSTANTIATE_TEST_SUITE_P(IlluminationMap, PartErrors,
  ::testing::Combine(::testing::Values(vtkIlluminationMap::SOBOL, vtkIlluminationMap::RANDOM),
    ::testing::Values(20000, 1500)));
