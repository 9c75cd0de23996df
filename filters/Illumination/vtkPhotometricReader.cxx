// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPhotometricReader.h"

#include "Illumination/luminaires/LuminaireFields.h"
#include "Illumination/luminaires/LuminairePlace.h"
#include "Illumination/luminaires/PhotometricSurface.h"
#include "Illumination/pipeline/FieldArrays.h"
#include "Illumination/pipeline/InputError.h"

#include "PhotonTransport/photometry/PhotometricFile.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <new>
#include <sstream>
#include <string>
#include <utility>

using namespace Illumination;

vtkStandardNewMacro(vtkPhotometricReader);

namespace
{

using PhotonTransport::PhotometricSolid;

void AddFields(const PhotometricSolid& solid, vtkFieldData* fields)
{
  const auto addNumber = [&](const char* name, double value)
  { AddArray(fields, name, std::vector<double>{ value }); };
  const double flux = Flux(solid);
  addNumber("LuminaireFlux", flux);
  addNumber("RatedFlux", solid.ratedFlux);
  addNumber("InputPower", solid.inputPower);
  if (solid.inputPower > 0.0 && std::isfinite(flux / solid.inputPower))
  {
    addNumber("Efficacy", flux / solid.inputPower);
  }
  using Type = PhotometricSolid::Type;
  const char* type = solid.type == Type::C ? "C" : solid.type == Type::B ? "B" : "A";
  AddArray(fields, "PhotometricType", std::vector<std::string>{ type });
  AddArray(fields, "Description", std::vector<std::string>{ solid.description });
  AddArray(fields, "Notes", solid.notes);
}

} // namespace

vtkPhotometricReader::vtkPhotometricReader()
{
  this->SetNumberOfInputPorts(0);
}

int vtkPhotometricReader::CanReadFile(const char* name)
{
  return name && PhotonTransport::IsPhotometricFileName(name) && std::ifstream(name) ? 1 : 0;
}

int vtkPhotometricReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  auto* surface = vtkPolyData::GetData(output);
  try
  {
    this->Read(surface);
  }
  catch (const std::exception& error)
  {
    surface->Initialize();
    AddLuminaireError(surface->GetFieldData(), error.what());
    vtkErrorMacro(<< error.what());
  }
  return 1; // an error is said once: the executive would add its own
}

void vtkPhotometricReader::Read(vtkPolyData* surface)
{
  if (this->FileName.empty())
  {
    throw InputError("FileName is empty; it must name a photometric file, .ies or .ldt");
  }
  if (!(this->Size > 0.0) || !std::isfinite(this->Size))
  {
    std::ostringstream message;
    message << "Size is " << this->Size << "; it must be a finite number above 0";
    throw InputError(message.str());
  }
  try
  {
    // Where the solid is drawn, the lamp is: at the origin, aiming along -z.
    PhotonTransport::PhotometricLamp lamp;
    lamp.solid = PhotonTransport::ReadPhotometricFile(this->FileName);
    DrawPhotometricSolid(lamp.solid, this->Size, surface);
    AddFields(lamp.solid, surface->GetFieldData());
    const std::string name = std::filesystem::path(this->FileName).stem().string();
    AddLuminaire(surface->GetFieldData(), { std::move(lamp), name });
    RememberPlace(surface);
  }
  catch (const PhotonTransport::PhotometricFileError& error)
  {
    throw InputError("'" + this->FileName + "', " + error.what());
  }
  catch (const std::bad_alloc&)
  {
    throw InputError("out of memory for '" + this->FileName + "'");
  }
}

void vtkPhotometricReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n"
     << indent << "Size: " << this->Size << "\n";
}
