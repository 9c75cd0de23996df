// SPDX-License-Identifier: BSD-3-Clause
// The properties of vtkIlluminationMap in the core's terms, and in print.
#include "vtkIlluminationMap.h"

#include "Illumination/luminaires/LampProperties.h"
#include "Illumination/luminaires/LuminaireCache.h"
#include "Illumination/luminaires/LuminaireFields.h"
#include "Illumination/luminaires/LuminaireInput.h"
#include "Illumination/luminaires/LuminaireNames.h"
#include "Illumination/pipeline/InputError.h"
#include "Illumination/pipeline/Pipeline.h"
#include "Illumination/surface/SurfaceDescription.h"

#include "PhotonTransport/adaptive/AdaptiveLimits.h"
#include "PhotonTransport/lights/Lamp.h"
#include "PhotonTransport/transport/IlluminationRun.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <sstream>
#include <type_traits>
#include <utility>

using namespace Illumination;

namespace
{

float Checked(double value, double least, double most, const char* property)
{
  if (!(value >= least && value <= most)) // NaN too
  {
    std::ostringstream message;
    message << property << " is " << value << "; it must be within [" << least << ", " << most
            << "]";
    throw InputError(message.str());
  }
  return static_cast<float>(value);
}

/// Refuses numbers below 0, which the core's unsigned types can't hold. The core refuses 0.
template <typename Unsigned, typename Signed>
Unsigned Count(Signed value, const char* what)
{
  if (value < 0)
  {
    throw InputError(
      "the " + std::string(what) + " is " + std::to_string(value) + "; it must be 1 or more");
  }
  return static_cast<Unsigned>(value);
}

// The types are the first kinds of lamps, and then that of facets.
static_assert(
  std::is_same_v<std::variant_alternative_t<vtkIlluminationMap::DISK, PhotonTransport::Lamp>,
    PhotonTransport::DiskLamp>);

PhotonTransport::Lamp LampOf(vtkIlluminationMap* filter)
{
  if (filter->GetLampType() == vtkIlluminationMap::EMITTING_FACETS)
  {
    return PhotonTransport::EmittingFacets{};
  }
  return PhotonTransport::DescribedLamp(static_cast<std::size_t>(filter->GetLampType()),
    LampProperties({ { "LuminairePosition", [=](int c) { return filter->GetLampPosition()[c]; } },
      { "LuminaireDirection", [=](int c) { return filter->GetLampDirection()[c]; } },
      { "LuminaireSize", [=](int part) { return filter->GetLampSize()[part]; } },
      { "LuminousFlux", [=](int) { return filter->GetLuminousFlux(); } },
      { "LuminaireIlluminance", [=](int) { return filter->GetParallelIlluminance(); } },
      { "SpotHalfAngle", [=](int) { return filter->GetSpotHalfAngle(); } },
      { "SpotExponent", [=](int) { return filter->GetSpotExponent(); } } }));
}

/// The material of cells that no array describes.
PhotonTransport::Material MaterialOf(vtkIlluminationMap* filter)
{
  using PhotonTransport::Colour;
  PhotonTransport::Material material;
  const auto share = [](double value, const char* property)
  { return Colour(Checked(value, 0.0, 1.0, property)); };
  material.diffuseReflectance = share(filter->GetReflectance(), "Reflectance");
  material.specularReflectance = share(filter->GetSpecularReflectance(), "SpecularReflectance");
  material.glossyReflectance = share(filter->GetGlossyReflectance(), "GlossyReflectance");
  material.diffuseTransmittance = share(filter->GetDiffuseTransmittance(), "DiffuseTransmittance");
  material.clearTransmittance = share(filter->GetClearTransmittance(), "ClearTransmittance");
  material.roughness = Checked(filter->GetRoughness(), 0.0, 1.0, "Roughness");
  material.refractiveIndex = Checked(filter->GetRefractiveIndex(), 1.0, 4.0, "RefractiveIndex");
  material.solid = filter->GetSolidBody();
  return material;
}

PhotonTransport::Luminaire LuminaireOf(const LuminaireInput& input)
{
  std::optional<PhotonTransport::Luminaire> luminaire;
  try
  {
    luminaire = ReadLuminaire(input.data);
  }
  catch (const InputError& error)
  {
    throw InputError(input.name + ": " + error.what());
  }
  if (!luminaire)
  {
    throw InputError(input.name +
      " is none: it has neither the field data of a luminaire nor a cell array 'Exitance'. "
      "Luminaires lose theirs in filters like Append Geometry; Group Datasets keeps them");
  }
  return *std::move(luminaire);
}

/// All ways of scattering but those that are switched off. One that has no switch is on.
PhotonTransport::ScatteringSet SwitchedOn(vtkIlluminationMap* filter)
{
  using PhotonTransport::Scattering;
  const std::pair<Scattering, bool> switches[] = { { Scattering::DiffuseReflection,
                                                     filter->GetInterreflection() },
    { Scattering::SpecularReflection, filter->GetSpecularReflection() },
    { Scattering::GlossyReflection, filter->GetGlossyReflection() },
    { Scattering::DiffuseTransmission, filter->GetDiffuseTransmission() },
    { Scattering::ClearTransmission, filter->GetClearTransmission() },
    { Scattering::Refraction, filter->GetRefraction() } };
  PhotonTransport::ScatteringSet set = PhotonTransport::AllScatterings;
  for (const auto& [scattering, on] : switches)
  {
    set &= on ? set : ~SetOf(scattering);
  }
  return set;
}

} // namespace

PhotonTransport::Lighting vtkIlluminationMap::MakeLighting(const Luminaires& luminaires)
{
  if (luminaires.empty())
  {
    return LampOf(this);
  }
  PhotonTransport::Lighting lighting;
  this->LampsRead->Renew();
  for (const LuminaireInput& input : luminaires)
  {
    lighting.luminaires.push_back(
      this->LampsRead->Of(input.data, [&] { return LuminaireOf(input); }));
  }
  GiveNames(lighting.luminaires);
  return lighting;
}

PhotonTransport::TraceSettings vtkIlluminationMap::MakeTraceSettings()
{
  PhotonTransport::TraceSettings settings;
  settings.seed = static_cast<std::uint32_t>(this->Seed);
  settings.sampling = static_cast<PhotonTransport::Sampling>(this->Sampling);
  settings.method = static_cast<PhotonTransport::Method>(this->Method);
  settings.gatherRays =
    this->GatherRays == 0 ? 0 : Count<std::uint32_t>(this->GatherRays, "number of gather rays");
  settings.registration = static_cast<PhotonTransport::Registration>(this->Registration);
  settings.scatterings = SwitchedOn(this);
  settings.colour = this->Colour;
  settings.registerBackSide = this->RegisterBackSide;
  settings.curvedSurface = this->CurvedSurface;
  settings.lampsApart = this->LampContributions;
  settings.weightBound = static_cast<float>(this->WeightBound);
  settings.maximumPathLength = Count<std::uint32_t>(this->MaximumPathLength, "maximum path length");
  settings.threads = this->NumberOfThreads;
  return settings;
}

PhotonTransport::StopRules vtkIlluminationMap::MakeStopRules()
{
  PhotonTransport::StopRules rules;
  const double photons = this->PhotonsAsDouble;
  if (!std::isfinite(photons) || photons != std::floor(photons)) // the core refuses other ranges
  {
    std::ostringstream message;
    message << "the number of photons is " << photons << "; it must be a whole number";
    throw InputError(message.str());
  }
  rules.photons = Count<std::uint64_t>(this->Photons, "number of photons");
  rules.relativeError = this->TargetRelativeError;
  rules.countFacetError = this->CountFacetError;
  rules.seconds = this->TimeLimit;
  return rules;
}

PhotonTransport::AdaptiveLimits vtkIlluminationMap::MakeAdaptiveLimits()
{
  PhotonTransport::AdaptiveLimits limits;
  limits.tolerance = this->RefinementTolerance;
  limits.facets = Count<std::uint64_t>(this->MaximumCells, "MaximumCells");
  Validate(limits);
  return limits;
}

std::uint64_t vtkIlluminationMap::MemoryLimitInBytes()
{
  const double limit = this->MemoryLimit;
  if (!(limit >= 0.0) || !std::isfinite(limit))
  {
    std::ostringstream message;
    message << "MemoryLimit is " << limit << " GiB; it must be 0 (what the machine has) or more";
    throw InputError(message.str());
  }
  // No machine has 2^33 GiB; and a limit, however small, is not 0.
  const double bytes = std::min(limit, 0x1p33) * 0x1p30;
  return static_cast<std::uint64_t>(std::ceil(bytes));
}

SurfaceDescription vtkIlluminationMap::DescribeSurface(bool otherLamps)
{
  SurfaceDescription description;
  description.material = MaterialOf(this);
  description.reflectanceArray = ArrayName(this->ReflectanceArray);
  description.materialArrays = this->UseMaterialArrays;
  if (this->LampType == EMITTING_FACETS && !otherLamps)
  {
    description.exitanceArray = ArrayName(this->ExitanceArray);
    if (description.exitanceArray.empty())
    {
      throw InputError("emitting facets need an ExitanceArray (lm/m^2 per cell); none is named");
    }
  }
  description.metresPerUnit = this->MetresPerUnit;
  description.featureAngle = this->FeatureAngle;
  if (std::isnan(description.featureAngle)) // all else is clamped when it is set
  {
    throw InputError("FeatureAngle is nan; it must be within [0, 180] degrees");
  }
  return description;
}

void vtkIlluminationMap::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto vector = [](const double* v)
  { return std::to_string(v[0]) + ", " + std::to_string(v[1]) + ", " + std::to_string(v[2]); };
  os << indent << "LampType: " << this->LampType << "\n"
     << indent << "LampPosition: " << vector(this->LampPosition) << "\n"
     << indent << "LampDirection: " << vector(this->LampDirection) << "\n"
     << indent << "LampSize: " << this->LampSize[0] << ", " << this->LampSize[1] << "\n"
     << indent << "SpotHalfAngle: " << this->SpotHalfAngle << "\n"
     << indent << "SpotExponent: " << this->SpotExponent << "\n"
     << indent << "LuminousFlux: " << this->LuminousFlux << "\n"
     << indent << "ParallelIlluminance: " << this->ParallelIlluminance << "\n"
     << indent << "Reflectance: " << this->Reflectance << "\n"
     << indent << "SpecularReflectance: " << this->SpecularReflectance << "\n"
     << indent << "GlossyReflectance: " << this->GlossyReflectance << "\n"
     << indent << "Roughness: " << this->Roughness << "\n"
     << indent << "DiffuseTransmittance: " << this->DiffuseTransmittance << "\n"
     << indent << "ClearTransmittance: " << this->ClearTransmittance << "\n"
     << indent << "RefractiveIndex: " << this->RefractiveIndex << "\n"
     << indent << "SolidBody: " << this->SolidBody << "\n"
     << indent << "UseMaterialArrays: " << this->UseMaterialArrays << "\n"
     << indent << "ReflectanceArray: " << this->ReflectanceArray << "\n"
     << indent << "ExitanceArray: " << this->ExitanceArray << "\n"
     << indent << "Method: " << this->Method << "\n"
     << indent << "GatherRays: " << this->GatherRays << "\n"
     << indent << "AdaptiveRefinement: " << this->AdaptiveRefinement << "\n"
     << indent << "RefinementTolerance: " << this->RefinementTolerance << "\n"
     << indent << "MaximumCells: " << this->MaximumCells << "\n"
     << indent << "Registration: " << this->Registration << "\n"
     << indent << "Photons: " << this->Photons << "\n"
     << indent << "TargetRelativeError: " << this->TargetRelativeError << "\n"
     << indent << "AccuracyRegionArray: " << this->AccuracyRegionArray << "\n"
     << indent << "AccuracyRegionBlocks: " << this->AccuracyRegionBlocks.size() << "\n"
     << indent << "CountFacetError: " << this->CountFacetError << "\n"
     << indent << "TimeLimit: " << this->TimeLimit << "\n"
     << indent << "Seed: " << this->Seed << "\n"
     << indent << "Sampling: " << this->Sampling << "\n"
     << indent << "Interreflection: " << this->Interreflection << "\n"
     << indent << "SpecularReflection: " << this->SpecularReflection << "\n"
     << indent << "GlossyReflection: " << this->GlossyReflection << "\n"
     << indent << "DiffuseTransmission: " << this->DiffuseTransmission << "\n"
     << indent << "ClearTransmission: " << this->ClearTransmission << "\n"
     << indent << "Refraction: " << this->Refraction << "\n"
     << indent << "Colour: " << this->Colour << "\n"
     << indent << "LampContributions: " << this->LampContributions << "\n"
     << indent << "RegisterBackSide: " << this->RegisterBackSide << "\n"
     << indent << "CurvedSurface: " << this->CurvedSurface << "\n"
     << indent << "GroupMeans: " << this->GroupMeans << "\n"
     << indent << "MaximumPhotons: " << this->MaximumPhotons << "\n"
     << indent << "PhotonPaths: " << this->PhotonPaths << "\n"
     << indent << "MetresPerUnit: " << this->MetresPerUnit << "\n"
     << indent << "FeatureAngle: " << this->FeatureAngle << "\n"
     << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n"
     << indent << "WeightBound: " << this->WeightBound << "\n"
     << indent << "MaximumPathLength: " << this->MaximumPathLength << "\n"
     << indent << "MemoryLimit: " << this->MemoryLimit << "\n";
}
