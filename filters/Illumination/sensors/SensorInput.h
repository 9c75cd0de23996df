// SPDX-License-Identifier: BSD-3-Clause
// The points of data sets as sensors.
#ifndef SensorInput_h
#define SensorInput_h

#include "PhotonTransport/sensors/Sensor.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;

namespace Illumination
{

class ControllerRanks;

/// A data set whose points are sensors.
struct SensorBlock
{
  vtkDataSet* data;
  std::string name;  ///< For messages: " of block 2", or "" where there is only one.
  std::size_t first; ///< Its first sensor, of SensorInput::sensors.
};

struct SensorInput
{
  std::vector<SensorBlock> blocks;
  std::vector<PhotonTransport::Sensor> sensors;
  std::uint64_t withoutNormals = 0; ///< Points that face up for want of normals.
};

/// The points of a data set, or of all blocks of a composite data set that are data sets. Their
/// normals are the point normals, or those of the polygons if there are any, or up. Throws
/// InputError for points that are not finite and normals that are no direction.
SensorInput SensorsOf(vtkDataObject* data, const glm::dvec3& up);

/// Gives each rank the sensors of all, in the order of the ranks; its blocks stay its own.
void ShareSensors(ControllerRanks& ranks, SensorInput& input);

} // namespace Illumination

#endif
