// SPDX-License-Identifier: BSD-3-Clause
#ifndef StatisticsTable_h
#define StatisticsTable_h

#include "PhotonTransport/statistics/LightSummary.h"

#include <string>
#include <vector>

class vtkTable;

namespace Illumination
{

struct StatisticsRow
{
  std::string name;
  PhotonTransport::LightSummary light; ///< lx
};

/// How rows are shown.
struct StatisticsUnits
{
  bool footCandles;         ///< In place of lux.
  double maintenanceFactor; ///< By which all light is multiplied.
};

/// lx in a foot-candle, which is a lumen on a square foot of 0.3048 m a side.
constexpr double LuxInFootCandle = 1.0 / (0.3048 * 0.3048);

/// Replaces the table's columns. @param errors Whether the noise is known, so that there are
/// columns for errors.
void FillStatisticsTable(vtkTable* table, const std::vector<StatisticsRow>& rows,
  const StatisticsUnits& units, bool errors);

} // namespace Illumination

#endif
