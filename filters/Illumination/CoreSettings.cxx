// SPDX-License-Identifier: BSD-3-Clause
#include "CoreSettings.h"

#include "vtkIlluminationMap.h"
#include "vtkIlluminationMapSmoothing.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace
{

glm::dvec3 Vector(const double v[3])
{
  return { v[0], v[1], v[2] };
}

/// The core counts without a sign and refuses 0 itself.
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

} // namespace

std::string ArrayName(const char* name)
{
  const std::string given = name ? name : "";
  return given == "None" ? "" : given;
}

PhotonTransport::Lamp LampOf(vtkIlluminationMap* filter)
{
  const glm::dvec3 position = Vector(filter->GetLampPosition());
  const glm::dvec3 direction = Vector(filter->GetLampDirection());
  const double* size = filter->GetLampSize();
  const double flux = filter->GetLuminousFlux();
  switch (filter->GetLampType())
  {
    case vtkIlluminationMap::POINT:
      return PhotonTransport::PointLamp{ position, flux };
    case vtkIlluminationMap::LAMBERTIAN_POINT:
      return PhotonTransport::LambertianPointLamp{ position, direction, flux };
    case vtkIlluminationMap::SPOT:
      return PhotonTransport::SpotLamp{ position, direction,
        vtkMath::RadiansFromDegrees(filter->GetSpotHalfAngle()), filter->GetSpotExponent(), flux };
    case vtkIlluminationMap::RECTANGLE:
      return PhotonTransport::RectangleLamp{ position, direction, size[0], size[1], flux };
    case vtkIlluminationMap::DISK:
      return PhotonTransport::DiskLamp{ position, direction, size[0], flux };
    case vtkIlluminationMap::EMITTING_FACETS:
      return PhotonTransport::EmittingFacets{};
    default:
      return PhotonTransport::ParallelLight{ direction, filter->GetParallelIlluminance() };
  }
}

PhotonTransport::TraceSettings SettingsOf(vtkIlluminationMap* filter)
{
  PhotonTransport::TraceSettings settings;
  settings.seed = static_cast<std::uint32_t>(filter->GetSeed());
  settings.sampling = static_cast<PhotonTransport::Sampling>(filter->GetSampling());
  settings.registration = static_cast<PhotonTransport::Registration>(filter->GetRegistration());
  settings.interreflection = filter->GetInterreflection();
  settings.registerBackSide = filter->GetRegisterBackSide();
  settings.weightBound = static_cast<float>(filter->GetWeightBound());
  settings.maximumPathLength =
    Count<std::uint32_t>(filter->GetMaximumPathLength(), "maximum path length");
  settings.threads = filter->GetNumberOfThreads();
  return settings;
}

PhotonTransport::StopRules RulesOf(vtkIlluminationMap* filter)
{
  PhotonTransport::StopRules rules;
  rules.photons = Count<std::uint64_t>(filter->GetPhotons(), "number of photons");
  rules.relativeError = filter->GetTargetRelativeError();
  rules.seconds = filter->GetTimeLimit();
  return rules;
}

std::uint64_t MemoryLimitOf(vtkIlluminationMap* filter)
{
  const double limit = filter->GetMemoryLimit();
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

SurfaceDescription DescriptionOf(vtkIlluminationMap* filter)
{
  SurfaceDescription description;
  description.reflectance = filter->GetReflectance();
  description.reflectanceArray = ArrayName(filter->GetReflectanceArray());
  if (filter->GetLampType() == vtkIlluminationMap::EMITTING_FACETS)
  {
    description.exitanceArray = ArrayName(filter->GetExitanceArray());
    if (description.exitanceArray.empty())
    {
      throw InputError("emitting facets need an ExitanceArray (lm/m^2 per cell); none is named");
    }
  }
  description.metresPerUnit = filter->GetMetresPerUnit();
  description.featureAngle = filter->GetFeatureAngle();
  if (std::isnan(description.featureAngle)) // all else is clamped when it is set
  {
    throw InputError("FeatureAngle is nan; it must be within [0, 180] degrees");
  }
  return description;
}

PhotonTransport::FiltrationSettings SettingsOf(vtkIlluminationMapSmoothing* filter)
{
  const double angle = filter->GetFeatureAngle();
  if (!(angle >= 0.0 && angle <= 180.0))
  {
    throw InputError(
      "FeatureAngle is " + std::to_string(angle) + "; it must be within [0, 180] degrees");
  }
  PhotonTransport::FiltrationSettings settings;
  settings.method = static_cast<PhotonTransport::FiltrationMethod>(filter->GetMethod());
  settings.strength = filter->GetStrength();
  settings.width = filter->GetWidth();
  settings.threads = filter->GetNumberOfThreads();
  return settings;
}
