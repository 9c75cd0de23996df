// SPDX-License-Identifier: BSD-3-Clause
#include "vtkLuminaireSource.h"

#include "Illumination/luminaires/LuminaireFields.h"
#include "Illumination/luminaires/LuminaireGeometry.h"
#include "Illumination/luminaires/LuminairePlace.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <exception>

vtkStandardNewMacro(vtkLuminaireSource);

vtkLuminaireSource::vtkLuminaireSource()
{
  this->SetNumberOfInputPorts(0);
}

int vtkLuminaireSource::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  vtkPolyData* out = vtkPolyData::GetData(output);
  try
  {
    const LuminaireGlyph glyph = this->MakeGlyph();
    const PhotonTransport::Luminaire luminaire = this->MakeLuminaire();
    out->ShallowCopy(LuminaireGeometry(luminaire.lamp, glyph));
    AddLuminaire(out->GetFieldData(), luminaire);
    RememberPlace(out);
  }
  catch (const std::exception& error)
  {
    out->Initialize();
    AddLuminaireError(out->GetFieldData(), error.what());
    vtkErrorMacro(<< error.what());
  }
  return 1; // as vtkIlluminationMap does: an error is said once
}

void vtkLuminaireSource::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto print = [&](const char* name, const double* values, int count)
  {
    os << indent << name << ":";
    std::for_each(values, values + count, [&](double value) { os << " " << value; });
    os << "\n";
  };
  os << indent << "Type: " << this->Type << "\n";
  os << indent << "LuminaireName: " << this->LuminaireName << "\n";
  print("Position", this->Position, 3);
  print("Direction", this->Direction, 3);
  print("Size", this->Size, 2);
  print("Rotation", &this->Rotation, 1);
  print("SpotHalfAngle", &this->SpotHalfAngle, 1);
  print("SpotExponent", &this->SpotExponent, 1);
  print("LuminousFlux", &this->LuminousFlux, 1);
  print("Illuminance", &this->Illuminance, 1);
  os << indent << "SkyType: " << this->SkyType << "\n";
  print("SunAltitude", &this->SunAltitude, 1);
  print("SunAzimuth", &this->SunAzimuth, 1);
  os << indent << "FileName: " << this->FileName << "\n";
  print("Dimming", &this->Dimming, 1);
  print("LightColour", this->LightColour, 3);
  print("GlyphSize", &this->GlyphSize, 1);
}
