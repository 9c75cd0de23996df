// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPhotometricReader.h"

#include "FieldArrays.h"
#include "LuminaireFields.h"
#include "LuminairePlace.h"
#include "PhotometricSurface.h"

#include "PhotonTransport/photometry/PhotometricFile.h"

#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <new>

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
  if (this->FileName.empty())
  {
    vtkErrorMacro("FileName is empty; it must name a photometric file, .ies or .ldt");
    return 1; // an error is said once: the executive would add its own
  }
  if (!(this->Size > 0.0) || !std::isfinite(this->Size))
  {
    vtkErrorMacro("Size is " << this->Size << "; it must be a finite number above 0");
    return 1;
  }
  try
  {
    const PhotometricSolid solid = PhotonTransport::ReadPhotometricFile(this->FileName);
    DrawPhotometricSolid(solid, this->Size, surface);
    AddFields(solid, surface->GetFieldData());
    // Where the solid is drawn: at the origin, aiming along -z.
    PhotonTransport::PhotometricLamp lamp;
    lamp.solid = solid;
    AddLuminaire(
      surface->GetFieldData(), { lamp, std::filesystem::path(this->FileName).stem().string() });
    RememberPlace(surface);
  }
  catch (const PhotonTransport::PhotometricFileError& error)
  {
    vtkErrorMacro("'" << this->FileName << "', " << error.what());
  }
  catch (const std::bad_alloc&)
  {
    surface->Initialize();
    vtkErrorMacro("out of memory for '" << this->FileName << "'");
  }
  catch (const std::exception& error)
  {
    vtkErrorMacro(<< error.what());
  }
  return 1;
}

void vtkPhotometricReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n"
     << indent << "Size: " << this->Size << "\n";
}
