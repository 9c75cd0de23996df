// SPDX-License-Identifier: BSD-3-Clause
#include "Illumination/reports/StatisticsTable.h"

#include "Illumination/pipeline/FieldArrays.h"

#include "vtkDataSetAttributes.h"
#include "vtkTable.h"

#include <algorithm>
#include <cstdint>
#include <iterator>

namespace Illumination
{
namespace
{

using PhotonTransport::Estimate;
using PhotonTransport::LightSummary;

/// A column for a value, and one for its error.
struct ValueColumn
{
  const char* name;
  const char* error;
  Estimate LightSummary::*value;
  double factor;
};

/// [row] What valueOf(row) returns.
template <typename Value, typename Function>
std::vector<Value> Column(const std::vector<StatisticsRow>& rows, const Function& valueOf)
{
  std::vector<Value> column;
  column.reserve(rows.size());
  std::transform(rows.begin(), rows.end(), std::back_inserter(column), valueOf);
  return column;
}

} // namespace

void FillStatisticsTable(vtkTable* table, const std::vector<StatisticsRow>& rows,
  const StatisticsUnits& units, bool errors)
{
  const double maintained = units.maintenanceFactor;
  const double illuminance = maintained / (units.footCandles ? LuxInFootCandle : 1.0);
  const ValueColumn columns[] = {
    { "Mean", "MeanError", &LightSummary::mean, illuminance },
    { "MeanOfPoints", "MeanOfPointsError", &LightSummary::meanOfPoints, illuminance },
    { "Minimum", "MinimumError", &LightSummary::minimum, illuminance },
    { "Maximum", "MaximumError", &LightSummary::maximum, illuminance },
    { "U0", "U0Error", &LightSummary::uniformity, 1.0 },
    { "Ud", "UdError", &LightSummary::diversity, 1.0 },
    { "ShareAtTarget", "ShareAtTargetError", &LightSummary::shareAtTarget, 1.0 },
    { "Flux", "FluxError", &LightSummary::flux, maintained },
    { "MeanLuminance", "MeanLuminanceError", &LightSummary::luminance, maintained },
  };
  table->Initialize();
  vtkDataSetAttributes* data = table->GetRowData();
  AddArray(
    data, "Name", Column<std::string>(rows, [](const StatisticsRow& row) { return row.name; }));
  AddArray(data, "Unit",
    Column<std::string>(
      rows, [&](const StatisticsRow&) { return units.footCandles ? "fc" : "lx"; }));
  AddArray(data, "Points",
    Column<std::uint64_t>(rows, [](const StatisticsRow& row) { return row.light.points; }));
  AddArray(
    data, "Area", Column<double>(rows, [](const StatisticsRow& row) { return row.light.area; }));
  for (const ValueColumn& column : columns)
  {
    AddArray(data, column.name,
      Column<double>(rows,
        [&](const StatisticsRow& row) { return column.factor * (row.light.*column.value).value; }));
    if (errors)
    {
      AddArray(data, column.error,
        Column<double>(rows,
          [&](const StatisticsRow& row)
          { return column.factor * (row.light.*column.value).error; }));
    }
  }
}

} // namespace Illumination
