// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSurfaceRefinement.h"

#include "Illumination/pipeline/InputError.h"
#include "Illumination/pipeline/Text.h"
#include "Illumination/pipeline/VtkVersion.h"
#include "Illumination/ranks/ControllerRanks.h"
#include "Illumination/refinement/RefinedBlocks.h"

#include "PhotonTransport/refinement/LimitedRefinement.h"

#include "vtkDataObject.h"
#include "vtkInformationVector.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <cstdint>
#include <limits>
#include <string>

using namespace Illumination;

vtkStandardNewMacro(vtkSurfaceRefinement);

namespace
{

using PhotonTransport::RefinementLimits;

/// Throws InputError unless the value lies in [least, most].
void RequireWithin(const char* property, double value, double least, double most, const char* range)
{
  if (!(value >= least && value <= most)) // NaN too
  {
    throw InputError(Text(property, " is ", value, "; it must be ", range));
  }
}

/// A limit of the core, where none is infinite.
double Limit(double value)
{
  return value > 0.0 ? value : RefinementLimits::None;
}

RefinementLimits LimitsOf(vtkSurfaceRefinement* filter)
{
  const double turn = filter->GetMaximumTurn();
  constexpr double Most = std::numeric_limits<double>::max();
  RequireWithin("MaximumTurn", turn, 0.0, 180.0, "within [0, 180] degrees");
  RequireWithin("CurvatureTolerance", filter->GetCurvatureTolerance(), 0.0, Most,
    "a finite length >= 0, where 0 is no limit");
  RequireWithin("MaximumEdgeLength", filter->GetMaximumEdgeLength(), 0.0, Most,
    "a finite length >= 0, where 0 is no limit");
  RequireWithin("FeatureAngle", filter->GetFeatureAngle(), 0.0, 180.0, "within [0, 180] degrees");
  RequireWithin("MaximumCells", filter->GetMaximumCells(), 1.0, 1e9, "from 1 to 1000000000");
  RefinementLimits limits;
  limits.length = Limit(filter->GetMaximumEdgeLength());
  limits.sagitta = Limit(filter->GetCurvatureTolerance());
  limits.turn = Limit(vtkMath::RadiansFromDegrees(turn));
  return limits;
}

/// ", by wider limits: MaximumTurn 14 degrees, MaximumEdgeLength 0.12".
std::string NamesOf(const RefinementLimits& limits)
{
  std::string names;
  const auto add = [&](const char* name, double value, const char* unit, double none)
  {
    if (value < none)
    {
      names += (names.empty() ? "" : ", ") + Text(name, " ", value, unit);
    }
  };
  add("MaximumTurn", vtkMath::DegreesFromRadians(limits.turn), " degrees", 180.0);
  add("CurvatureTolerance", limits.sagitta, "", RefinementLimits::None);
  add("MaximumEdgeLength", limits.length, "", RefinementLimits::None);
  return names.empty() ? ", none of them divided" : ", by wider limits: " + names;
}

} // namespace

void vtkSurfaceRefinement::Execute(
  vtkDataObject*, vtkInformationVector**, vtkInformationVector* outputs)
{
  const RefinementBlocks blocks(vtkDataObject::GetData(outputs), this->FeatureAngle);
  const auto refined = this->Refine(blocks);
  if (this->GetRanks().Any(refined.empty()))
  {
    return; // The input passes through.
  }
  for (std::size_t b = 0; b < refined.size(); ++b)
  {
    blocks.Blocks()[b].data->ShallowCopy(refined[b]);
  }
}

std::vector<vtkSmartPointer<vtkPolyData>> vtkSurfaceRefinement::Refine(
  const RefinementBlocks& blocks)
{
  const RefinementLimits limits = LimitsOf(this);
  const auto most = static_cast<std::uint64_t>(this->MaximumCells);
  // Without a pause between reports, since there are few of them.
  const auto goesOn = [this](double share, const char* text)
  {
    this->SetProgressText(text);
    this->UpdateProgress(share);
    return !AbortRequested(this);
  };
  if (!goesOn(0.2, "Finding curves"))
  {
    return {};
  }
  const PhotonTransport::LimitedRefinement limited = LimitFacets(blocks.Mesh(), limits, most);
  if (limited.widened)
  {
    this->Warn(Text("the limits ask for more triangles than MaximumCells, ", most,
      ". The surface has ", limited.refinement->NumberOfFacets(), NamesOf(limited.limits)));
  }
  if (!goesOn(0.5, "Dividing facets"))
  {
    return {};
  }
  const PhotonTransport::RefinedMesh fine = limited.refinement->Make();
  if (!goesOn(0.7, "Interpolating arrays"))
  {
    return {};
  }
  return RefinedBlocks(blocks, fine);
}

void vtkSurfaceRefinement::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "MaximumTurn: " << this->MaximumTurn << "\n"
     << indent << "CurvatureTolerance: " << this->CurvatureTolerance << "\n"
     << indent << "MaximumEdgeLength: " << this->MaximumEdgeLength << "\n"
     << indent << "FeatureAngle: " << this->FeatureAngle << "\n"
     << indent << "MaximumCells: " << this->MaximumCells << "\n";
}
