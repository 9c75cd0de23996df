// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIlluminatedAppearance.h"

#include "vtkIlluminationMap.h"

#include "Illumination/appearance/SurfaceLuminance.h"
#include "Illumination/pipeline/FieldArrays.h"
#include "Illumination/pipeline/InputError.h"
#include "Illumination/pipeline/Pipeline.h"
#include "Illumination/pipeline/Text.h"
#include "Illumination/ranks/ControllerRanks.h"
#include "Illumination/surface/SurfaceDescription.h"

#include "PhotonTransport/appearance/DisplayTransform.h"

#include "vtkDataObject.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

using namespace Illumination;

vtkStandardNewMacro(vtkIlluminatedAppearance);

namespace
{

using PhotonTransport::DisplaySettings;

constexpr auto Automatic = "Automatic";

/// The user has asked to stop.
struct Aborted
{
};

/// Throws InputError unless the value lies in [least, most].
void RequireWithin(const char* property, double value, double least, double most, const char* range)
{
  if (!(value >= least && value <= most)) // NaN too
  {
    throw InputError(Text(property, " is ", value, "; it must be ", range));
  }
}

void RequireValid(vtkIlluminatedAppearance* filter)
{
  constexpr double Most = std::numeric_limits<float>::max();
  RequireWithin("Reflectance", filter->GetReflectance(), 0.0, 1.0, "within [0, 1]");
  RequireWithin("AdaptationLuminance", filter->GetAdaptationLuminance(), 0.0, Most,
    "a finite luminance >= 0 in cd/m^2, where 0 is automatic");
  RequireWithin("ExposureCompensation", filter->GetExposureCompensation(), -20.0, 20.0,
    "within [-20, 20] stops");
  RequireWithin(
    "HighlightCompression", filter->GetHighlightCompression(), 0.0, 1.0, "within [0, 1]");
  RequireWithin("WhiteLuminance", filter->GetWhiteLuminance(), 0.0, Most,
    "a finite luminance >= 0 in cd/m^2, where 0 is automatic");
  const double* white = filter->GetWhiteColour();
  for (int c = 0; c < 3; ++c)
  {
    RequireWithin("WhiteColour", white[c], 0.0, Most, "three finite numbers >= 0");
  }
  if (white[0] + white[1] + white[2] == 0.0)
  {
    throw InputError("WhiteColour is 0 0 0; at least one of red, green and blue must be above 0");
  }
}

std::string IlluminanceOf(ControllerRanks& ranks, const std::string& given, vtkDataObject* data)
{
  if (given != Automatic)
  {
    return given;
  }
  const std::vector<NamedSurface> surfaces = PartsOf(data).surfaces;
  const std::string smoothed = "IlluminanceSmoothed";
  const bool isSmoothed = std::all_of(surfaces.begin(), surfaces.end(),
    [&](const NamedSurface& block)
    {
      return block.data->GetNumberOfPoints() == 0 ||
        block.data->GetPointData()->HasArray(smoothed.c_str()) != 0;
    });
  return ranks.Any(!isSmoothed) ? "Illuminance" : smoothed;
}

PhotonTransport::Colour WhiteOf(vtkIlluminatedAppearance* filter, const SurfaceLuminance& luminance)
{
  const double* given = filter->GetWhiteColour();
  glm::dvec3 white(1.0);
  if (filter->GetWhiteBalance() == vtkIlluminatedAppearance::AUTOMATIC)
  {
    white = PhotonTransport::LuminousSum(luminance.light) > 0.0 ? luminance.light : white;
  }
  else if (filter->GetWhiteBalance() == vtkIlluminatedAppearance::BY_COLOUR)
  {
    white = { given[0], given[1], given[2] };
  }
  return PhotonTransport::Colour(white / std::max({ white.x, white.y, white.z }));
}

DisplaySettings SettingsOf(vtkIlluminatedAppearance* filter, const SurfaceLuminance& luminance)
{
  const auto chosen = [](double given, double found)
  {
    const double value = given > 0.0 ? given : found;
    return value > 0.0 ? value : 1.0; // all is dark, whatever the exposure
  };
  DisplaySettings settings;
  settings.adaptationLuminance = chosen(filter->GetAdaptationLuminance(), luminance.adaptation);
  settings.compensation = filter->GetExposureCompensation();
  settings.highlightCompression = filter->GetHighlightCompression();
  settings.whiteLuminance = chosen(filter->GetWhiteLuminance(), luminance.brightest);
  settings.white = WhiteOf(filter, luminance);
  return settings;
}

void AddArrays(const LuminousBlock& block, bool isColoured,
  const PhotonTransport::DisplayTransform& transform, vtkPolyData* data)
{
  const auto points = block.luminance.size();
  std::vector<double> luminance(points);
  std::vector<std::array<double, 3>> byColour(isColoured ? points : 0);
  vtkNew<vtkUnsignedCharArray> colours;
  colours->SetName("DisplayColours");
  colours->SetNumberOfComponents(3);
  colours->SetNumberOfTuples(static_cast<vtkIdType>(points));
  for (std::size_t p = 0; p < points; ++p)
  {
    const glm::dvec3& own = block.luminance[p];
    luminance[p] = PhotonTransport::LuminousSum(own);
    if (isColoured)
    {
      byColour[p] = { own.x, own.y, own.z };
    }
    colours->SetTypedTuple(static_cast<vtkIdType>(p), transform(own).data());
  }
  vtkPointData* arrays = data->GetPointData();
  AddArray(arrays, "Luminance", luminance);
  if (isColoured)
  {
    AddArray(arrays, "LuminanceRGB", byColour);
  }
  arrays->AddArray(colours);
  arrays->SetActiveScalars(colours->GetName());
}

/// Called between parts of the work with whether to go on.
using Step = std::function<void(bool goOn)>;

/// @return Whether the work was done; not if the user has stopped it.
bool Uninterrupted(const std::function<void(const Step&)>& work)
{
  try
  {
    work(
      [](bool goOn)
      {
        if (!goOn)
        {
          throw Aborted();
        }
      });
    return true;
  }
  catch (const Aborted&)
  {
    return false;
  }
}

void AddFieldData(vtkFieldData* fields, const DisplaySettings& settings,
  const std::string& illuminance, const LookDescription& looks, std::vector<std::string> notes)
{
  AddArray(fields, "AdaptationLuminance", std::vector<double>{ settings.adaptationLuminance });
  AddArray(fields, "WhiteLuminance", std::vector<double>{ settings.whiteLuminance });
  const PhotonTransport::Colour& white = settings.white;
  AddArray(
    fields, "WhiteColour", std::vector<std::array<double, 3>>{ { white.x, white.y, white.z } });
  const std::string reflectance = Text("diffuse reflectance: ",
    looks.reflectanceArray.empty() ? "" : "cell array '" + looks.reflectanceArray + "', elsewhere ",
    looks.reflectance);
  notes.insert(notes.begin(), { "illuminance: point array '" + illuminance + "'", reflectance });
  AddArray(fields, "AppearanceNotes", notes);
}

} // namespace

LookDescription vtkIlluminatedAppearance::DescribeLooks(vtkDataObject* data)
{
  LookDescription looks{ ArrayName(this->ReflectanceArray), false, this->Reflectance,
    ArrayName(this->ExitanceArray), false };
  const bool findsReflectance = looks.reflectanceArray == Automatic;
  const bool findsExitance = looks.exitanceArray == Automatic;
  looks.reflectanceArrayIsNamed = !findsReflectance && !looks.reflectanceArray.empty();
  looks.exitanceArrayIsNamed = !findsExitance && !looks.exitanceArray.empty();

  SurfaceDescription made; // without a map: the usual arrays
  vtkNew<vtkIlluminationMap> map;
  bool ownLamp = false;
  const bool isMap = map->RecallSettings(data->GetFieldData(), ownLamp);
  if (isMap)
  {
    made = map->DescribeSurface(!ownLamp);
  }
  if (findsReflectance)
  {
    const std::string usual = made.materialArrays ? "DiffuseReflectance" : "";
    looks.reflectanceArray = made.reflectanceArray.empty() ? usual : made.reflectanceArray;
    looks.reflectance = isMap ? made.material.diffuseReflectance.x : looks.reflectance;
  }
  if (findsExitance)
  {
    looks.exitanceArray = made.exitanceArray.empty() ? "Exitance" : made.exitanceArray;
  }
  return looks;
}

void vtkIlluminatedAppearance::Execute(
  vtkDataObject*, vtkInformationVector**, vtkInformationVector* outputs)
{
  RequireValid(this);
  vtkDataObject* output = vtkDataObject::GetData(outputs);
  ControllerRanks& ranks = this->GetRanks();
  const LookDescription description = this->DescribeLooks(output);
  const std::string illuminance = IlluminanceOf(ranks, this->IlluminanceArray, output);
  ProgressReport report(this);
  SurfaceLuminance luminance;
  const bool isRead = Uninterrupted(
    [&](const Step& step)
    {
      luminance = LuminanceOf(output, illuminance, description,
        [&](double share) { step(report(0.6 * share, "Computing luminance")); });
    });
  if (ranks.Any(!isRead))
  {
    return; // the input passes through
  }
  Adapt(ranks, luminance);
  const DisplaySettings settings = SettingsOf(this, luminance);
  const PhotonTransport::DisplayTransform transform(settings);
  const bool isColoured = Uninterrupted(
    [&](const Step& step)
    {
      for (std::size_t b = 0; b < luminance.blocks.size(); ++b)
      {
        const LuminousBlock& block = luminance.blocks[b];
        AddArrays(block, luminance.isColoured, transform, block.surface.data);
        step(report(
          0.6 + 0.4 * static_cast<double>(b + 1) / static_cast<double>(luminance.blocks.size()),
          "Choosing colours"));
      }
    });
  if (ranks.Any(!isColoured))
  {
    return;
  }
  for (const LuminousBlock& block : luminance.blocks)
  {
    block.data->ShallowCopy(block.surface.data);
  }
  AddFieldData(output->GetFieldData(), settings, illuminance, description, luminance.notes);
}

void vtkIlluminatedAppearance::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IlluminanceArray: " << this->IlluminanceArray << "\n"
     << indent << "ReflectanceArray: " << this->ReflectanceArray << "\n"
     << indent << "Reflectance: " << this->Reflectance << "\n"
     << indent << "ExitanceArray: " << this->ExitanceArray << "\n"
     << indent << "AdaptationLuminance: " << this->AdaptationLuminance << "\n"
     << indent << "ExposureCompensation: " << this->ExposureCompensation << "\n"
     << indent << "HighlightCompression: " << this->HighlightCompression << "\n"
     << indent << "WhiteLuminance: " << this->WhiteLuminance << "\n"
     << indent << "WhiteBalance: " << this->WhiteBalance << "\n"
     << indent << "WhiteColour: " << this->WhiteColour[0] << ", " << this->WhiteColour[1] << ", "
     << this->WhiteColour[2] << "\n";
}
