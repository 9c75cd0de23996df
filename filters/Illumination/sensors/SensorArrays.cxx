// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/sensors/SensorArrays.h"

#include "Illumination/pipeline/FieldArrays.h"

#include "PhotonTransport/geometry/Pi.h"

#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <sstream>
#include <type_traits>

namespace Illumination
{
namespace
{

using PhotonTransport::SensorDirections;
using PhotonTransport::SensorReading;
namespace Measure = PhotonTransport::Measure;

/// "Illuminance" becomes "StandardError", "VerticalIlluminance" "StandardErrorVertical".
std::string NameOfError(std::string name)
{
  const std::string common = "Illuminance";
  const std::size_t place = name.rfind(common);
  return "StandardError" + (place == std::string::npos ? name : name.substr(0, place));
}

/// The readings of one block.
class Columns
{
public:
  Columns(const SensorBlock& block, const std::vector<SensorReading>& all, double azimuth)
    : Arrays(block.data->GetPointData())
    , Readings(all.data() + block.first)
    , Number(static_cast<std::size_t>(block.data->GetNumberOfPoints()))
    , Azimuth(azimuth)
  {
  }

  void Add(const char* name, const std::function<double(const SensorReading&)>& valueOf) const
  {
    std::vector<double> values(this->Number);
    std::transform(this->Readings, this->Readings + this->Number, values.begin(), valueOf);
    AddArray(this->Arrays, name, values);
  }

  /// A component for each view. @param valueOf Of (reading, view).
  void AddViews(
    const char* name, const std::function<double(const SensorReading&, std::size_t)>& valueOf) const
  {
    std::vector<std::array<double, SensorDirections::Views>> values(this->Number);
    for (std::size_t i = 0; i < this->Number; ++i)
    {
      for (std::size_t v = 0; v < SensorDirections::Views; ++v)
      {
        values[i][v] = valueOf(this->Readings[i], v);
      }
    }
    AddArray(this->Arrays, name, values);
    for (std::size_t v = 0; v < SensorDirections::Views; ++v)
    {
      std::ostringstream degrees;
      degrees << "towards " << std::fmod(this->Azimuth + 90.0 * static_cast<double>(v), 360.0)
              << " deg";
      this->Arrays->GetArray(name)->SetComponentName(
        static_cast<vtkIdType>(v), degrees.str().c_str());
    }
  }

  void AddMeasure(const char* name, std::size_t measure) const
  {
    this->Add(name, [=](const SensorReading& reading) { return reading.lux[measure]; });
    this->Add(NameOfError(name).c_str(),
      [=](const SensorReading& reading) { return reading.standardError[measure]; });
  }
  void AddMeasureOfViews(const char* name, std::size_t measure) const
  {
    this->AddViews(
      name, [=](const SensorReading& reading, std::size_t v) { return reading.lux[measure + v]; });
    this->AddViews(NameOfError(name).c_str(),
      [=](const SensorReading& reading, std::size_t v)
      { return reading.standardError[measure + v]; });
  }

  void AddValid() const
  {
    std::vector<std::uint8_t> valid(this->Number);
    std::transform(this->Readings, this->Readings + this->Number, valid.begin(),
      [](const SensorReading& reading) { return static_cast<std::uint8_t>(reading.valid); });
    AddNumbers<vtkUnsignedCharArray>(this->Arrays, "Valid", valid);
  }

private:
  vtkPointData* Arrays;
  const SensorReading* Readings;
  std::size_t Number;
  double Azimuth; ///< Degrees.
};

} // namespace

std::optional<double> OutdoorIlluminance(
  const PhotonTransport::Lighting& lighting, const glm::dvec3& up, std::string& why)
{
  double sum = 0.0;
  bool anySky = false;
  for (const PhotonTransport::Luminaire& luminaire : lighting.luminaires)
  {
    const std::string name = "luminaire '" + luminaire.name + "' ";
    std::visit(
      [&](const auto& lamp)
      {
        using Kind = std::decay_t<decltype(lamp)>;
        constexpr bool IsUniform = std::is_same_v<Kind, PhotonTransport::UniformSky>;
        if constexpr (IsUniform || std::is_same_v<Kind, PhotonTransport::CieSky>)
        {
          anySky = true;
          constexpr double SameHorizon = 0.9999;
          if (!(glm::dot(glm::normalize(lamp.up), up) > SameHorizon))
          {
            why = name + "has another direction up";
          }
          if constexpr (IsUniform)
          {
            sum += PhotonTransport::Pi * lamp.luminance;
          }
          else
          {
            sum += lamp.horizontalIlluminance;
            if (lamp.type != 1 && lamp.type != 16)
            {
              why = name + "is no overcast sky";
            }
          }
        }
        else
        {
          why = name + "is no sky";
        }
      },
      luminaire.lamp);
  }
  why = anySky ? why : "";
  return anySky && why.empty() && sum > 0.0 ? std::optional(sum) : std::nullopt;
}

bool NoneHasLuminance(const PhotonTransport::Lighting& lighting)
{
  return std::none_of(lighting.luminaires.begin(), lighting.luminaires.end(),
    [](const PhotonTransport::Luminaire& luminaire)
    {
      if (const auto* lamp = std::get_if<PhotonTransport::PhotometricLamp>(&luminaire.lamp))
      {
        return lamp->solid.width * lamp->solid.length > 0.0;
      }
      return PhotonTransport::ClassOf(luminaire.lamp) == PhotonTransport::LampClass::Area &&
        !std::holds_alternative<PhotonTransport::LineLamp>(luminaire.lamp);
    });
}

void AddSensorArrays(const std::vector<SensorBlock>& blocks,
  const std::vector<SensorReading>& readings, std::optional<double> outdoors, double azimuth)
{
  for (const SensorBlock& block : blocks)
  {
    if (block.data->GetNumberOfPoints() == 0)
    {
      continue;
    }
    const Columns columns(block, readings, azimuth);
    columns.AddMeasure("Illuminance", Measure::Own);
    columns.AddMeasure("HorizontalIlluminance", Measure::Horizontal);
    columns.AddMeasureOfViews("VerticalIlluminance", Measure::Vertical);
    columns.AddMeasure("CylindricalIlluminance", Measure::Cylindrical);
    columns.AddMeasureOfViews("SemicylindricalIlluminance", Measure::Semicylindrical);
    columns.AddMeasure("HemisphericalIlluminance", Measure::Hemispherical);
    columns.AddMeasure("SphericalIlluminance", Measure::Spherical);
    if (outdoors)
    {
      const double percent = 100.0 / *outdoors;
      columns.Add("DaylightFactor",
        [=](const SensorReading& reading) { return percent * reading.lux[Measure::Horizontal]; });
      columns.Add("StandardErrorDaylightFactor",
        [=](const SensorReading& reading)
        { return percent * reading.standardError[Measure::Horizontal]; });
    }
    columns.AddViews(
      "UGR", [](const SensorReading& reading, std::size_t v) { return reading.glare[v].ugr; });
    columns.AddViews("StandardErrorUGR",
      [](const SensorReading& reading, std::size_t v) { return reading.glare[v].standardError; });
    columns.AddValid();
    block.data->GetPointData()->SetActiveScalars("HorizontalIlluminance");
  }
}

} // namespace Illumination
