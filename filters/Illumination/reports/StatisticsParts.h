// SPDX-License-Identifier: BSD-3-Clause
// What rows of statistics are about: surfaces and sensors, cut into parts.
#ifndef StatisticsParts_h
#define StatisticsParts_h

#include "Illumination/reports/PartLabels.h"
#include "Illumination/reports/StatisticsArrays.h"

#include "PhotonTransport/statistics/LightSummary.h"

#include "vtkSmartPointer.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

class vtkDataObject;

namespace Illumination
{

struct StatisticsPart
{
  std::string name;
  PhotonTransport::NoisyValues light;
  PhotonTransport::SummarisedFacets facets;
};

/// Where the knowledge of the noise comes from.
enum class NoiseSource
{
  Unknown,
  StandardErrors,
  Groups
};

/// Surfaces and points with an illumination map, by part.
class StatisticsParts
{
public:
  /// Throws InputError for arrays that are missing or hold what can't be summarised.
  /// @param pieces Data sets or composite ones, by rank; blocks of the same number are parts of
  /// one.
  /// @param arrays Groups are found by the name of the map.
  StatisticsParts(
    const std::vector<vtkSmartPointer<vtkDataObject>>& pieces, const StatisticsArrays& arrays);

  const std::map<PartKey, StatisticsPart>& Parts() const { return this->ByKey; }
  NoiseSource Noise() const { return this->NoiseFrom; }
  std::size_t InvalidPoints() const { return this->Invalid; }
  std::size_t OtherBlocks() const { return this->Input.others; }

private:
  void FindNoise();
  void AddSurface(const NamedBlock& block);
  void AddPoints(const NamedBlock& block);
  StatisticsPart& PartOf(const PartKey& key, const std::string& name);

  StatisticsArrays Arrays;
  NamedBlocks Input;
  std::map<PartKey, StatisticsPart> ByKey;
  NoiseSource NoiseFrom = NoiseSource::Unknown;
  std::size_t Invalid = 0;
};

} // namespace Illumination

#endif
