// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIlluminationMapSmoothing.h"

#include "Illumination/map/MapBlocks.h"
#include "Illumination/pipeline/FieldArrays.h"
#include "Illumination/pipeline/InputError.h"
#include "Illumination/pipeline/Pipeline.h"
#include "Illumination/ranks/ControllerRanks.h"

#include "PhotonTransport/filtration/Filtration.h"
#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/threads/Threads.h"

#include "vtkDataObject.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>

using namespace Illumination;

vtkStandardNewMacro(vtkIlluminationMapSmoothing);

namespace
{

using PhotonTransport::FilteredMap;
using PhotonTransport::NoisyMap;

/// The user has asked to stop.
struct Aborted
{
};

/// What is smoothed, and what is known of its noise.
struct Maps
{
  std::vector<NoisyMap> parts;
  std::vector<double> hits;
  std::string note; ///< Where the knowledge of the noise comes from.
};

Maps ReadMaps(const MapBlocks& blocks, const std::string& map, const std::string& standardError)
{
  Maps maps;
  if (map == "Illuminance" && blocks.Have("PhotonHits"))
  {
    maps.hits = blocks.OfVertices(blocks.Values("PhotonHits"));
  }
  const std::string direct = map + "Direct";
  const std::string indirect = map + "Indirect";
  if (blocks.Have(direct + "Groups") && blocks.Have(indirect + "Groups"))
  {
    for (const std::string& part : { direct, indirect })
    {
      maps.parts.push_back({ part, blocks.OfVertices(blocks.Values(part)),
        blocks.OfVertices(blocks.Groups(part + "Groups")), {} });
    }
    maps.note = "direct and indirect light by the differences between four groups of photons";
    return maps;
  }
  maps.parts.push_back({ map, blocks.OfVertices(blocks.Values(map)), {}, {} });
  if (!standardError.empty() && blocks.Have(standardError))
  {
    maps.parts.front().standardError = blocks.OfVertices(blocks.Values(standardError));
    maps.note = "by the array '" + standardError + "'";
    if (!blocks.Have(map + "Caustic")) // maps by Final Gathering have one, and no group means
    {
      maps.note += "; GroupMeans of Illumination Map, switched on, would give a better result";
    }
  }
  else
  {
    maps.note = "by the map's roughness, which takes fine detail for noise: there are no group "
                "means and no array of standard errors";
  }
  return maps;
}

void AddMaps(const MapBlocks& blocks, const std::string& name, const Maps& maps,
  const std::vector<FilteredMap>& filtered)
{
  // Points without a triangle keep their light.
  const auto add = [&](const std::string& array, const auto& ofVertices, auto others)
  {
    auto values = blocks.OfPoints(ofVertices, std::move(others));
    blocks.CopyToGhosts(values);
    blocks.ForEachPart(values,
      [&](const MapBlocks::Block& block, const auto& own)
      { AddArray(block.data->GetPointData(), array.c_str(), own); });
  };
  std::vector<double> total(filtered.front().values.size(), 0.0);
  std::vector<double> error(total.size(), 0.0);
  for (const FilteredMap& part : filtered)
  {
    for (std::size_t p = 0; p < total.size(); ++p)
    {
      total[p] += part.values[p];
      error[p] = std::hypot(error[p], std::sqrt(part.squaredError[p]));
    }
  }
  const std::vector<double> none;
  add(name + "Smoothed", total, blocks.Values(name));
  add("StandardErrorSmoothed", error, none);
  if (filtered.size() == 1)
  {
    add("SmoothingScale", filtered.front().width, std::vector<float>());
    return;
  }
  std::vector<std::array<double, 2>> widths(total.size());
  for (std::size_t p = 0; p < widths.size(); ++p)
  {
    widths[p] = { filtered[0].width[p], filtered[1].width[p] };
  }
  add("SmoothingScale", widths, std::vector<std::array<double, 2>>());
  for (std::size_t i = 0; i < filtered.size(); ++i)
  {
    add(maps.parts[i].name + "Smoothed", filtered[i].values, blocks.Values(maps.parts[i].name));
  }
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

/// Empty if it was stopped.
std::vector<FilteredMap> Smoothed(vtkIlluminationMapSmoothing* filter, const MapBlocks& blocks,
  const Maps& maps, const PhotonTransport::FiltrationSettings& settings)
{
  std::vector<FilteredMap> filtered;
  PhotonTransport::Threads threads(settings.threads);
  try
  {
    threads.Run(
      [&]
      {
        const PhotonTransport::SmoothingGraph graph(blocks.Vertices(), blocks.Facets(),
          vtkMath::RadiansFromDegrees(filter->GetFeatureAngle()));
        filtered = Filtrate(graph, maps.parts, maps.hits, settings,
          [report = ProgressReport(filter)](double share) mutable
          {
            if (!report(share, "Smoothing"))
            {
              throw Aborted();
            }
          });
      });
  }
  catch (const Aborted&)
  {
    filtered.clear();
  }
  return filtered;
}

} // namespace

void vtkIlluminationMapSmoothing::Execute(
  vtkDataObject*, vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkDataObject* output = vtkDataObject::GetData(outputs);
  const PhotonTransport::FiltrationSettings settings = SettingsOf(this);
  Validate(settings);
  const MapBlocks blocks(output);
  const Maps maps = ReadMaps(blocks, this->IlluminanceArray, ArrayName(this->StandardErrorArray));
  try
  {
    const std::vector<FilteredMap> filtered = Smoothed(this, blocks, maps, settings);
    if (this->GetRanks().Any(filtered.empty()))
    {
      return; // The input passes through.
    }
    AddMaps(blocks, this->IlluminanceArray, maps, filtered);
    const std::vector<std::string> notes{ "smoothed " + maps.note };
    AddArray(output->GetFieldData(), "SmoothingNotes", notes);
  }
  catch (const PhotonTransport::InvalidInput& error)
  {
    const bool atPoint = error.Kind == PhotonTransport::InvalidInput::Where::Point;
    throw InputError((atPoint ? blocks.NameOfVertex(error.Index) + ": " : "") + error.what());
  }
}

void vtkIlluminationMapSmoothing::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n"
     << indent << "IlluminanceArray: " << this->IlluminanceArray << "\n"
     << indent << "StandardErrorArray: " << this->StandardErrorArray << "\n"
     << indent << "Strength: " << this->Strength << "\n"
     << indent << "Width: " << this->Width << "\n"
     << indent << "FeatureAngle: " << this->FeatureAngle << "\n"
     << indent << "NumberOfThreads: " << this->NumberOfThreads << "\n";
}
