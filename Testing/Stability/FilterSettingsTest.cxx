// SPDX-License-Identifier: BSD-3-Clause
// Properties that make no sense: one error each that says the value.
#include "FilterTools.h"

#include "vtkPointData.h"

#include <cmath>
#include <limits>
#include <sstream>

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double NoNumber = std::numeric_limits<double>::quiet_NaN();

using Filter = vtkIlluminationMap;

struct RealProperty
{
  const char* words; ///< Of the message, before the value.
  int lamp;
  double (Filter::*get)();
  void (Filter::*set)(double);
};

class FilterSettings : public FilterTest
{
protected:
  FilterSettings()
    : FilterTest("properties that make no sense: a crash, a hang, a silent correction")
  {
  }

  template <typename Value>
  void ExpectRefused(void (Filter::*set)(Value), Value bad, Value good, const std::string& words)
  {
    (this->Filter->*set)(bad);
    this->ExpectError(words);
    (this->Filter->*set)(good);
    this->ExpectMap();
  }
};

} // namespace

TEST_F(FilterSettings, RealNumbersThatAreNoneOrNegative)
{
  const RealProperty properties[] = {
    { "Reflectance is ", Filter::PARALLEL, &Filter::GetReflectance, &Filter::SetReflectance },
    { "half-angle ", Filter::SPOT, &Filter::GetSpotHalfAngle, &Filter::SetSpotHalfAngle },
    { "spot exponent ", Filter::SPOT, &Filter::GetSpotExponent, &Filter::SetSpotExponent },
    { "luminous flux ", Filter::POINT, &Filter::GetLuminousFlux, &Filter::SetLuminousFlux },
    { "illuminance ", Filter::PARALLEL, &Filter::GetParallelIlluminance,
      &Filter::SetParallelIlluminance },
    { "target relative error is ", Filter::PARALLEL, &Filter::GetTargetRelativeError,
      &Filter::SetTargetRelativeError },
    { "time limit is ", Filter::PARALLEL, &Filter::GetTimeLimit, &Filter::SetTimeLimit },
    { "metres per unit is ", Filter::PARALLEL, &Filter::GetMetresPerUnit,
      &Filter::SetMetresPerUnit },
    { "weight bound is ", Filter::PARALLEL, &Filter::GetWeightBound, &Filter::SetWeightBound },
  };
  for (const RealProperty& property : properties)
  {
    this->Filter->SetLampType(property.lamp);
    const double good = (this->Filter->*property.get)();
    for (const double bad : { NoNumber, Infinity, -Infinity, -1.0 })
    {
      std::ostringstream words;
      words << property.words << bad;
      this->ExpectRefused(property.set, bad, good, words.str());
    }
  }
}

TEST_F(FilterSettings, FeatureAngleThatIsNone)
{
  this->Surface->GetPointData()->Initialize(); // it is for surfaces without normals
  this->ExpectRefused(&Filter::SetFeatureAngle, NoNumber, 30.0, "FeatureAngle is nan");
}

TEST_F(FilterSettings, CountsOutOfRange)
{
  const vtkIdType tooMany = 10000000001;
  this->ExpectRefused(&Filter::SetPhotons, vtkIdType{ -5 }, vtkIdType{ 4096 }, "photons is -5");
  this->ExpectRefused(&Filter::SetPhotons, tooMany, vtkIdType{ 4096 }, "photons is 10000000001");
  this->ExpectRefused(
    &Filter::SetPhotons, VTK_ID_MAX, vtkIdType{ 4096 }, "photons is 9223372036854775807");
  this->ExpectRefused(&Filter::SetPhotons, VTK_ID_MIN, vtkIdType{ 4096 }, "photons is -92233720");
  this->ExpectRefused(&Filter::SetMaximumPathLength, -3, 10000, "path length is -3");
  this->ExpectRefused(&Filter::SetMaximumPathLength, 0, 10000, "path length is 0");
  this->ExpectRefused(&Filter::SetNumberOfThreads, -2, 0, "threads is -2");
  this->ExpectRefused(&Filter::SetNumberOfThreads, VTK_INT_MAX, 0, "threads is 2147483647");
}

TEST_F(FilterSettings, LampsThatAreNowhere)
{
  for (const double bad : { NoNumber, Infinity, 1e300 })
  {
    this->Filter->SetLampType(Filter::DISK);
    this->Filter->SetLampPosition(0.0, bad, 1.0);
    this->ExpectError("lamp position (0, " + std::string(std::isnan(bad) ? "nan" : ""));
    this->Filter->SetLampPosition(0.0, 0.0, 1.0);
    this->Filter->SetLampSize(bad, 1.0);
    this->ExpectError("lamp radius " + std::string(std::isnan(bad) ? "nan" : ""));
    this->Filter->SetLampType(Filter::RECTANGLE);
    this->ExpectError("lamp width ");
    this->Filter->SetLampSize(1.0, bad);
    this->ExpectError("lamp height ");
    this->Filter->SetLampSize(1.0, -1.0);
    this->ExpectError("lamp height -1");
    this->Filter->SetLampSize(1.0, 1.0);
    this->ExpectMap();
  }
  this->Filter->SetLampDirection(0.0, NoNumber, 1.0);
  this->ExpectError("lamp direction (0, nan, 1)");
  this->Filter->SetLampDirection(0.0, 1e-200, 0.0); // short, but a direction
  this->ExpectMap();
}
