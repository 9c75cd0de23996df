// SPDX-License-Identifier: BSD-3-Clause
// Other fluxes, dimming and colours of luminaires change a map with lamps apart without tracing.
#include "GatheringTools.h"
#include "OutputData.h"

#include "vtkIlluminationMap.h"
#include "vtkLuminaireSource.h"

#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace
{

constexpr const char* Note = "the map was relit without tracing";

/// A round room with two lamps.
struct LitRoom
{
  LitRoom()
  {
    this->filter->SetInputData(RoundRoom(12));
    this->filter->AddLuminaireConnection(this->strong->GetOutputPort());
    this->filter->AddLuminaireConnection(this->weak->GetOutputPort());
    this->filter->SetLampContributions(true);
    this->filter->SetPhotons(50000);
    this->filter->SetProgressive(false);
  }

  vtkPolyData* Output()
  {
    this->filter->Update();
    return this->filter->GetOutput();
  }
  std::vector<double> Values(const char* name, int component = 0)
  {
    vtkDataArray* array = PointArray(this->Output(), name);
    std::vector<double> values;
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    {
      values.push_back(array->GetComponent(i, component));
    }
    return values;
  }
  /// Seconds that the run has traced in all, which no tracing leaves as they are.
  double SecondsTraced() { return FieldValue(this->Output(), "Seconds"); }
  bool HasNote() { return FieldText(this->Output(), "Notes").find(Note) != std::string::npos; }

  vtkSmartPointer<vtkLuminaireSource> strong = PointLamp(0.1, 0.05, 0.15, 900.0, "Strong");
  vtkSmartPointer<vtkLuminaireSource> weak = PointLamp(-0.2, 0.1, 0.0, 100.0, "Weak");
  vtkNew<vtkIlluminationMap> filter;
};

} // namespace

TEST(IlluminationMapRelight, DimmingTracesNothing)
{
  LitRoom room;
  const std::vector<double> before = room.Values("Illuminance");
  const std::vector<double> ofStrong = room.Values("Illuminance_Strong");
  const std::vector<double> ofWeak = room.Values("Illuminance_Weak");
  const std::vector<double> errors = room.Values("StandardError_Strong");
  const std::vector<double> allErrors = room.Values("StandardError");
  const double seconds = room.SecondsTraced();
  EXPECT_FALSE(room.HasNote());
  room.strong->SetDimming(0.25);
  room.weak->SetLuminousFlux(200.0);
  const std::vector<double> after = room.Values("Illuminance");
  EXPECT_EQ(room.SecondsTraced(), seconds);
  EXPECT_TRUE(room.HasNote());
  EXPECT_EQ(FieldText(room.Output(), "StoppedBy"), "photon limit\n");
  EXPECT_DOUBLE_EQ(FieldValue(room.Output(), "EmittedFlux"), 0.25 * 900.0 + 200.0);
  const std::vector<double> dimmed = room.Values("Illuminance_Strong");
  const std::vector<double> dimmedErrors = room.Values("StandardError_Strong");
  for (std::size_t i = 0; i < before.size(); ++i)
  {
    EXPECT_NEAR(after[i], 0.25 * ofStrong[i] + 2.0 * ofWeak[i], 1e-12 * after[i]);
    EXPECT_NEAR(dimmed[i], 0.25 * ofStrong[i], 1e-12 * dimmed[i]);
    EXPECT_NEAR(dimmedErrors[i], 0.25 * errors[i], 1e-12 * errors[i]);
  }
  room.strong->SetDimming(1.0);
  room.weak->SetLuminousFlux(100.0);
  EXPECT_EQ(room.Values("Illuminance"), before);
  EXPECT_EQ(room.Values("StandardError"), allErrors);
  EXPECT_EQ(room.SecondsTraced(), seconds);
  EXPECT_FALSE(room.HasNote());
}

TEST(IlluminationMapRelight, TheFluxOfTheOnlyLampTracesNothing)
{
  for (const int method :
    { vtkIlluminationMap::PHOTON_TRACING, vtkIlluminationMap::FINAL_GATHERING })
  {
    SCOPED_TRACE(method);
    LitRoom room;
    room.filter->RemoveAllInputConnections(1);
    room.filter->SetLampContributions(false);
    room.filter->SetMethod(method);
    room.filter->SetLampType(vtkIlluminationMap::POINT);
    room.filter->SetLampPosition(0.1, 0.05, 0.15);
    room.filter->SetLuminousFlux(1000.0);
    const std::vector<double> before = room.Values("Illuminance");
    const std::vector<double> errors = room.Values("StandardError");
    const double seconds = room.SecondsTraced();
    room.filter->SetLuminousFlux(1700.0);
    const std::vector<double> after = room.Values("Illuminance");
    const std::vector<double> errorsAfter = room.Values("StandardError");
    EXPECT_EQ(room.SecondsTraced(), seconds);
    EXPECT_EQ(FieldValue(room.Output(), "EmittedFlux"), 1700.0);
    EXPECT_FALSE(room.HasNote()) << "photons are where they would be";
    for (std::size_t i = 0; i < before.size(); ++i)
    {
      EXPECT_NEAR(after[i], 1.7 * before[i], 1e-14 * after[i]);
      EXPECT_NEAR(errorsAfter[i], 1.7 * errors[i], 1e-14 * errorsAfter[i]);
    }
  }
}

TEST(IlluminationMapRelight, LampsThatAreOffAreTraced)
{
  LitRoom room;
  room.weak->SetDimming(0.0);
  const double seconds = room.SecondsTraced();
  for (const double light : room.Values("Illuminance_Weak"))
  {
    EXPECT_EQ(light, 0.0);
  }
  room.weak->SetDimming(1.0);
  const std::vector<double> on = room.Values("Illuminance");
  EXPECT_EQ(room.SecondsTraced(), seconds);
  LitRoom other;
  EXPECT_EQ(on, other.Values("Illuminance"));
}

// What a target of accuracy says after relighting is told, and nothing is traced for it.
TEST(IlluminationMapRelight, OnlyOtherRulesGoOn)
{
  LitRoom room;
  room.filter->SetTargetRelativeError(0.1);
  const double seconds = room.SecondsTraced();
  const double emitted = FieldValue(room.Output(), "PhotonsEmitted");
  room.strong->SetDimming(0.01);
  EXPECT_EQ(room.SecondsTraced(), seconds);
  EXPECT_EQ(FieldText(room.Output(), "StoppedBy"), "target relative error\n");
  room.filter->SetGroupMeans(false); // another array, another execution
  EXPECT_EQ(room.SecondsTraced(), seconds);
  room.filter->SetTargetRelativeError(0.02);
  EXPECT_GT(FieldValue(room.Output(), "PhotonsEmitted"), emitted);
  EXPECT_TRUE(room.HasNote()) << "photons are in the shares of the former fluxes";
}

TEST(IlluminationMapRelight, ColoursOfLampsInGreyRooms)
{
  LitRoom room;
  const std::vector<double> before = room.Values("Illuminance");
  const double seconds = room.SecondsTraced();
  EXPECT_FALSE(PointArray(room.Output(), "IlluminanceRGB"));
  room.weak->SetLightColour(1.0, 0.0, 0.0);
  EXPECT_EQ(room.SecondsTraced(), seconds);
  EXPECT_EQ(room.Values("Illuminance"), before);
  const std::vector<double> green = room.Values("IlluminanceRGB", 1);
  const std::vector<double> strong = room.Values("Illuminance_Strong");
  const std::vector<double> greenErrors = room.Values("StandardErrorRGB", 1);
  const std::vector<double> strongErrors = room.Values("StandardError_Strong");
  for (std::size_t i = 0; i < green.size(); ++i)
  {
    EXPECT_NEAR(green[i], strong[i], 1e-6 * strong[i]) << "white light has equal channels";
    EXPECT_NEAR(greenErrors[i], strongErrors[i], 1e-6 * strongErrors[i]);
  }
  // Stored photons have colours of their own, so they call for tracing.
  room.filter->SetMaximumPhotons(100);
  room.weak->SetLightColour(0.0, 1.0, 0.0);
  EXPECT_FALSE(room.HasNote());
}

TEST(IlluminationMapRelight, StoredPhotonsHaveTheNewFlux)
{
  LitRoom room;
  room.filter->SetMaximumPhotons(1000000);
  const auto fluxOf = [&](int lamp)
  {
    room.Output();
    vtkPolyData* photons = vtkPolyData::SafeDownCast(room.filter->GetOutputDataObject(2));
    double flux = 0.0;
    for (vtkIdType i = 0; i < photons->GetNumberOfPoints(); ++i)
    {
      flux += PointArray(photons, "Luminaire")->GetTuple1(i) == lamp
        ? PointArray(photons, "Flux")->GetTuple1(i)
        : 0.0;
    }
    return flux;
  };
  const double strong = fluxOf(0);
  const double weak = fluxOf(1);
  room.strong->SetDimming(0.5);
  EXPECT_NEAR(fluxOf(0), 0.5 * strong, 1e-9 * strong);
  EXPECT_NEAR(fluxOf(1), weak, 1e-9 * weak);
  EXPECT_TRUE(room.HasNote());
}

TEST(IlluminationMapRelight, OtherChangesTraceAnew)
{
  LitRoom room;
  room.strong->SetDimming(0.5);
  room.Output();
  room.weak->SetPosition(0.2, 0.1, 0.0);
  const std::vector<double> moved = room.Values("Illuminance_Weak");
  LitRoom anew;
  anew.strong->SetDimming(0.5);
  anew.weak->SetPosition(0.2, 0.1, 0.0);
  EXPECT_EQ(moved, anew.Values("Illuminance_Weak"));
  room.filter->SetLampContributions(false);
  room.Output();
  room.strong->SetDimming(0.7);
  room.Output();
  EXPECT_FALSE(room.HasNote()) << "lamps are not apart";
  room.filter->SetLampContributions(true);
  room.filter->SetMethod(vtkIlluminationMap::FINAL_GATHERING);
  room.Output();
  room.strong->SetDimming(0.5);
  room.Output();
  EXPECT_FALSE(room.HasNote()) << "final gathering traces anew";
}

TEST(IlluminationMapRelight, TheFiltersOwnLampToo)
{
  vtkNew<vtkIlluminationMap> filter;
  filter->SetInputData(RoundRoom(12));
  filter->SetLampType(vtkIlluminationMap::POINT);
  filter->SetLampPosition(0.0, 0.0, 0.0);
  filter->SetLampContributions(true);
  filter->SetPhotons(20000);
  filter->SetProgressive(false);
  filter->Update();
  const double seconds = FieldValue(filter->GetOutput(), "Seconds");
  filter->SetLuminousFlux(500.0);
  filter->Update();
  EXPECT_EQ(FieldValue(filter->GetOutput(), "Seconds"), seconds);
  EXPECT_DOUBLE_EQ(FieldValue(filter->GetOutput(), "EmittedFlux"), 500.0);
}
