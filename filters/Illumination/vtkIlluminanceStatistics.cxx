// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIlluminanceStatistics.h"

#include "Illumination/pipeline/FieldArrays.h"
#include "Illumination/pipeline/InputError.h"
#include "Illumination/pipeline/Pipeline.h"
#include "Illumination/pipeline/Text.h"
#include "Illumination/reports/StatisticsParts.h"
#include "Illumination/reports/StatisticsTable.h"

#include "vtkCompositeDataSet.h"
#include "vtkDataObject.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

#include <cmath>
#include <exception>
#include <new>
#include <vector>

using namespace Illumination;

vtkStandardNewMacro(vtkIlluminanceStatistics);

namespace
{

using Pieces = std::vector<vtkSmartPointer<vtkDataObject>>;

/// The data of all ranks, on rank 0; nothing on the others. All ranks must call this.
Pieces PiecesOfAllRanks(vtkDataObject* own)
{
  vtkMultiProcessController* controller = vtkMultiProcessController::GetGlobalController();
  if (!controller || controller->GetNumberOfProcesses() < 2)
  {
    return { own };
  }
  Pieces pieces;
  controller->Gather(own, pieces, 0);
  return controller->GetLocalProcessId() == 0 ? pieces : Pieces();
}

void RequireRange(const char* name, double value, bool isIn, const char* range)
{
  if (!(std::isfinite(value) && isIn))
  {
    throw InputError(Text(name, " is ", value, "; it must be ", range));
  }
}

/// What the properties say, checked.
StatisticsArrays ArraysOf(vtkIlluminanceStatistics* filter)
{
  const double target = filter->GetTarget();
  const double factor = filter->GetMaintenanceFactor();
  const double reflectance = filter->GetReflectance();
  const double metres = filter->GetMetresPerUnit();
  RequireRange("Target", target, target >= 0.0, "0 or more");
  RequireRange("MaintenanceFactor", factor, factor > 0.0 && factor <= 1.0, "within (0, 1]");
  RequireRange(
    "Reflectance", reflectance, reflectance >= 0.0 && reflectance <= 1.0, "within [0, 1]");
  RequireRange("MetresPerUnit", metres, metres > 0.0, "greater than 0");
  return { filter->GetIlluminanceArray(), ArrayName(filter->GetStandardErrorArray()), {},
    ArrayName(filter->GetPartArray()), ArrayName(filter->GetValidArray()),
    ArrayName(filter->GetReflectanceArray()), reflectance, metres };
}

std::string NoteOn(NoiseSource noise, const std::string& standardErrorArray)
{
  switch (noise)
  {
    case NoiseSource::Groups:
      return "errors: by the differences between four groups of photons";
    case NoiseSource::StandardErrors:
      return "errors of Mean, MeanOfPoints, ShareAtTarget, Flux and MeanLuminance: the largest "
             "that "
             "they can be, as if the noise of all points by '" +
        standardErrorArray +
        "' went together; with Photon Tracing, GroupMeans of Illumination Map tells how it does";
    default:
      return "no errors: there are no group means and no array of standard errors in all blocks; "
             "where the map has noise, Minimum is too low and Maximum too high";
  }
}

std::vector<std::string> NotesOn(
  const StatisticsParts& parts, const std::string& standardErrorArray)
{
  std::vector<std::string> notes{ NoteOn(parts.Noise(), standardErrorArray) };
  if (parts.InvalidPoints() > 0)
  {
    notes.push_back(Text(parts.InvalidPoints(), " points are not valid and were left out"));
  }
  if (parts.OtherBlocks() > 0)
  {
    notes.push_back(Text(parts.OtherBlocks(), " blocks are no data sets and were left out"));
  }
  return notes;
}

} // namespace

vtkIlluminanceStatistics::vtkIlluminanceStatistics()
{
  this->SetNumberOfInputPorts(1);
  this->SetNumberOfOutputPorts(1);
}

int vtkIlluminanceStatistics::FillInputPortInformation(int, vtkInformation* info)
{
  info->Set(INPUT_REQUIRED_DATA_TYPE(), "vtkDataSet");
  info->Append(INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  return 1;
}

int vtkIlluminanceStatistics::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  // An observer may disconnect the input.
  const vtkSmartPointer<vtkDataObject> in = vtkDataObject::GetData(input[0]);
  vtkTable* table = vtkTable::GetData(output);
  std::string error;
  try
  {
    this->Summarise(in, table);
    return 1;
  }
  catch (const std::bad_alloc&)
  {
    error = "out of memory for an input of " + std::to_string(in->GetActualMemorySize()) + " KiB";
  }
  catch (const std::exception& thrown)
  {
    error = thrown.what();
  }
  FillStatisticsTable(table, {}, {}, false);
  vtkErrorMacro(<< error);
  return 1;
}

void vtkIlluminanceStatistics::Summarise(vtkDataObject* input, vtkTable* table)
{
  const StatisticsUnits units{ this->Unit == FOOT_CANDLES, this->MaintenanceFactor };
  FillStatisticsTable(table, {}, units, false);
  const Pieces pieces = PiecesOfAllRanks(input); // before anything can fail on one rank
  if (pieces.empty())
  {
    return;
  }
  const StatisticsArrays arrays = ArraysOf(this);
  const StatisticsParts parts(pieces, arrays);
  const double target = this->Target * (units.footCandles ? LuxInFootCandle : 1.0);
  std::vector<StatisticsRow> rows;
  ProgressReport report(this);
  bool goOn = true;
  for (const auto& [key, part] : parts.Parts())
  {
    const double done =
      static_cast<double>(rows.size()) / static_cast<double>(parts.Parts().size());
    rows.push_back({ part.name,
      PhotonTransport::Summarise(part.light, part.facets, target / this->MaintenanceFactor,
        [&] { return goOn = goOn && report(done, "Summarising " + part.name); }) });
    if (!goOn)
    {
      return; // the table is empty
    }
  }
  FillStatisticsTable(table, rows, units, parts.Noise() != NoiseSource::Unknown);
  AddArray(table->GetFieldData(), "Notes", NotesOn(parts, this->StandardErrorArray));
}

void vtkIlluminanceStatistics::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IlluminanceArray: " << this->IlluminanceArray << "\n"
     << indent << "StandardErrorArray: " << this->StandardErrorArray << "\n"
     << indent << "PartArray: " << this->PartArray << "\n"
     << indent << "ValidArray: " << this->ValidArray << "\n"
     << indent << "Target: " << this->Target << "\n"
     << indent << "MaintenanceFactor: " << this->MaintenanceFactor << "\n"
     << indent << "Unit: " << this->Unit << "\n"
     << indent << "ReflectanceArray: " << this->ReflectanceArray << "\n"
     << indent << "Reflectance: " << this->Reflectance << "\n"
     << indent << "MetresPerUnit: " << this->MetresPerUnit << "\n";
}
