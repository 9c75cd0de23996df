// SPDX-License-Identifier: BSD-3-Clause
// Materials from Surface Material and lamps from Luminaire reach the tracer: effects go on by what
// cells have and off by their switches, colours add up, each luminaire's part too, and what can't
// be used gives one error.
#include "Messages.h"
#include "OutputData.h"

#include "vtkIlluminationMap.h"

#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkLuminaireSource.h"
#include "vtkNew.h"
#include "vtkSphereSource.h"
#include "vtkSurfaceMaterial.h"

#include <cmath>

namespace
{

/// A hollow ball seen from inside, with a lamp in it.
struct Ball
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkSurfaceMaterial> material;
  vtkNew<vtkIlluminationMap> filter;
  CaughtMessages messages;

  Ball()
  {
    this->sphere->SetThetaResolution(24);
    this->sphere->SetPhiResolution(12);
    this->material->SetInputConnection(this->sphere->GetOutputPort());
    this->filter->SetInputConnection(this->material->GetOutputPort());
    this->filter->SetPhotons(100'000);
    this->filter->SetLampType(vtkIlluminationMap::PARALLEL);
    this->filter->SetRegisterBackSide(true);
  }
  vtkPolyData* Output()
  {
    this->filter->Update();
    return this->filter->GetOutput();
  }
  bool Says(const std::string& words)
  {
    return FieldText(this->Output(), "Effects").find(words) != std::string::npos;
  }
};

} // namespace

TEST(IlluminationMapMaterials, EffectsGoOnByWhatCellsHave)
{
  Ball ball;
  ball.material->SetPreset(vtkSurfaceMaterial::MIRROR);
  EXPECT_TRUE(ball.Says("specular reflection: on") && ball.Says("interreflection: off"))
    << "a mirror";
  EXPECT_TRUE(ball.Says("colour: off")) << "a mirror has no colour";
  ball.material->SetPreset(vtkSurfaceMaterial::CLEAR_GLASS);
  EXPECT_TRUE(ball.Says("clear transmission: on, 480 of 480")) << "glass";
  // Light crosses the pane above and lands on the one below.
  vtkDataArray* back = PointArray(ball.Output(), "IlluminanceBack");
  EXPECT_TRUE(back && back->GetRange()[1] > 100.0) << "light behind glass";
  ball.filter->SetUseMaterialArrays(false);
  EXPECT_TRUE(ball.Says("clear transmission: off, no triangle")) << "arrays switched off";
}

TEST(IlluminationMapMaterials, EffectsGoOffByTheirSwitches)
{
  Ball ball;
  ball.material->SetPreset(vtkSurfaceMaterial::CLEAR_GLASS);
  EXPECT_EQ(FieldValue(ball.Output(), "FluxSwitchedOff"), 0.0) << "all is on";
  ball.filter->SetClearTransmission(false);
  vtkPolyData* output = ball.Output();
  EXPECT_TRUE(ball.Says("clear transmission: off, switched off though")) << "said";
  const double emitted = FieldValue(output, "EmittedFlux");
  const double lost = FieldValue(output, "FluxSwitchedOff");
  // Of the disk's flux nearly all meets the ball, and glass absorbs a few per cent.
  EXPECT_TRUE(lost > 0.8 * emitted && lost < emitted) << "flux that was not carried";
  EXPECT_EQ(FieldValue(output, "PhotonsEmitted"),
    FieldValue(output, "PhotonsAbsorbed") + FieldValue(output, "PhotonsEscaped") +
      FieldValue(output, "PhotonsCutOff"))
    << "balance";
  EXPECT_EQ(PointArray(output, "IlluminanceBack")->GetRange()[1], 0.0) << "none behind the glass";
}

TEST(IlluminationMapMaterials, ColoursAddUp)
{
  Ball ball;
  ball.material->SetDiffuseReflectance(0.9, 0.5, 0.1);
  vtkPolyData* output = ball.Output();
  vtkDataArray* rgb = PointArray(output, "IlluminanceRGB");
  vtkDataArray* lux = PointArray(output, "Illuminance");
  EXPECT_TRUE(rgb && rgb->GetNumberOfComponents() == 3) << "a map by colour";
  for (vtkIdType p = 0; rgb && p < rgb->GetNumberOfTuples(); ++p)
  {
    const double* c = rgb->GetTuple3(p);
    const double sum = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
    // The weights are floats in the core.
    EXPECT_LE(std::fabs(sum - lux->GetTuple1(p)), 1e-6 * lux->GetTuple1(p)) << "colours add up";
  }
  ball.filter->SetColour(false);
  output = ball.Output();
  EXPECT_FALSE(PointArray(output, "IlluminanceRGB")) << "one channel";
  EXPECT_TRUE(ball.Says("colour: off, switched off though")) << "said";
}

TEST(IlluminationMapMaterials, PartsOfLuminairesAddUp)
{
  Ball ball;
  vtkNew<vtkLuminaireSource> sun;
  sun->SetType(vtkLuminaireSource::PARALLEL);
  sun->SetLuminaireName("Sun");
  vtkNew<vtkLuminaireSource> lamp;
  lamp->SetType(vtkLuminaireSource::POINT);
  lamp->SetPosition(2.0, 0.0, 0.0);
  ball.filter->AddLuminaireConnection(sun->GetOutputPort());
  ball.filter->AddLuminaireConnection(lamp->GetOutputPort());
  ball.filter->SetLampContributions(true);
  vtkPolyData* output = ball.Output();
  vtkDataArray* bySun = PointArray(output, "Illuminance_Sun");
  vtkDataArray* byLamp = PointArray(output, "Illuminance_Lamp 2"); // it has no name of its own
  vtkDataArray* all = PointArray(output, "Illuminance");
  EXPECT_TRUE(bySun && byLamp) << "parts by name";
  for (vtkIdType p = 0; bySun && byLamp && p < all->GetNumberOfTuples(); ++p)
  {
    const double sum = bySun->GetTuple1(p) + byLamp->GetTuple1(p);
    EXPECT_LE(std::fabs(sum - all->GetTuple1(p)), 1e-12 * all->GetTuple1(p)) << "parts add up";
  }
  const double before = FieldValue(output, "EmittedFlux");
  lamp->SetDimming(0.5);
  EXPECT_LT(std::fabs(FieldValue(ball.Output(), "EmittedFlux") - (before - 500.0)), 1e-9 * before)
    << "a luminaire is dimmed";
  lamp->SetType(vtkLuminaireSource::PHOTOMETRIC_FILE);
  lamp->SetFileName(ILLUMINATION_TEST_DATA "/photometry/tilt_included.ies");
  EXPECT_TRUE(Holds(FieldText(ball.Output(), "Notes"),
    "photometric file of luminaire 'Lamp 2', line 10: the number "
    "after the ballast factor is 0.8"))
    << "what was assumed of a photometric file";
  ball.filter->RemoveAllLuminaires();
  EXPECT_FALSE(Holds(FieldText(ball.Output(), "Notes"), "photometric")) << "of that alone";
  EXPECT_TRUE(PointArray(ball.Output(), "Illuminance_Lamp")) << "the own lamp again";
  EXPECT_EQ(ball.messages->Errors, 0) << ball.messages->Text;
}

TEST(IlluminationMapMaterials, WhatCannotBeUsedGivesOneError)
{
  Ball ball;
  vtkNew<vtkSphereSource> none;
  ball.filter->AddLuminaireConnection(none->GetOutputPort());
  ball.Output();
  EXPECT_EQ(ball.messages->Errors, 1) << "a ball is no luminaire";
  EXPECT_TRUE(Holds(ball.messages->Text, "luminaire 1 is none"));
  EXPECT_FALSE(PointArray(ball.filter->GetOutput(), "Illuminance")) << "no map";
  ball.filter->RemoveAllLuminaires();

  // Arrays that nobody checked before.
  ball.material->Update();
  vtkNew<vtkPolyData> surface;
  surface->ShallowCopy(ball.material->GetOutput());
  vtkNew<vtkFloatArray> specular;
  specular->SetName("SpecularReflectance");
  specular->SetNumberOfTuples(surface->GetNumberOfCells());
  specular->Fill(0.1);
  specular->SetValue(7, 0.75f);
  surface->GetCellData()->AddArray(specular);
  ball.filter->SetInputData(surface);
  ball.Output();
  EXPECT_EQ(ball.messages->Errors, 2) << "too much light";
  EXPECT_TRUE(Holds(ball.messages->Text,
    "cell 7: the reflectances and transmittances sum to 1.25; they must not exceed 1 together"));
}
