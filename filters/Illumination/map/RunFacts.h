// SPDX-License-Identifier: BSD-3-Clause
// What a run tells of itself: field data and the table Accuracy.
#ifndef RunFacts_h
#define RunFacts_h

#include "Illumination/surface/SurfaceDescription.h"

#include "PhotonTransport/transport/IlluminationRun.h"

#include <cstdint>
#include <string>
#include <vector>

class vtkFieldData;
class vtkTable;

namespace Illumination
{

/// Adds what concerns the run as a whole: photon balance, time, effects, notes.
void AddFieldData(vtkFieldData* output, const PhotonTransport::IlluminationRun& run,
  PhotonTransport::StopReason reason, const std::vector<std::string>& notes);

/// Adds MemoryNeeded, the bytes that the run was expected to take at most.
void AddMemoryNeeded(vtkFieldData* output, std::uint64_t bytes);

/// Fills the table with a row for each round; without any it has columns and no row. There are
/// columns for the region where accuracy counts, if there is one.
void FillAccuracyTable(vtkTable* table, const std::vector<PhotonTransport::Accuracy>& rounds);

} // namespace Illumination

#endif
