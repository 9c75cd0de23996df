// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/GatherPass.h"
#include "PhotonTransport/gathering/GatherWalk.h"
#include "PhotonTransport/gathering/Guide.h"
#include "PhotonTransport/sensors/Glare.h"
#include "PhotonTransport/sensors/RayLight.h"
#include "PhotonTransport/sensors/SensorKernels.h"

#include <array>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// What a sensor has measured.
struct SensorReading
{
  /// 0 for a point inside a solid body or outside of a room: more of the rays that leave it meet a
  /// back that lets no light through than meet anything else. All else is 0 then. Otherwise 1. It
  /// is so wide that a reading has no gaps between its values, which Ranks::SumAll would add up.
  std::uint64_t valid = 0;
  Measured<double> lux{};
  Measured<double> standardError{}; ///< lx
  std::array<GlareRating, SensorDirections::Views> glare{};
};

/// Reads one sensor after another. Light straight from lamps comes by shadow rays to places on
/// them, all other light, that of skies included, by rays into all directions and then, as many
/// again, to where light comes from. One set of both serves all measures.
class SensorReader
{
public:
  /// Both must outlive it.
  SensorReader(const GatherPass& pass, const SensorDirections& directions);

  /// @param at In free space. @param index Of the sensor, for its random numbers.
  void Read(
    const Receiver& at, const glm::dvec3& normal, std::uint64_t index, SensorReading& reading);

private:
  bool IsInsideSolid(const Receiver& at, std::uint64_t index);
  void AddLamps(const Receiver& at, std::uint64_t index);
  void AddGlare(const ArrivedLight& light, std::array<double, SensorDirections::Views>& sums) const;
  void Probe(const Receiver& at, std::uint64_t index);
  void GatherGuided(const Receiver& at, std::uint64_t index);
  void GatherThroughOpenings(const Receiver& at, std::uint64_t index);
  void GatherThrough(std::uint32_t opening, const SeenOpening& seen, std::size_t side,
    const Receiver& at, std::uint64_t index);
  void StartRays();
  void AddRay(const Receiver& at, const glm::vec3& direction, double factor);
  void Follow(const LightThrough& through, const GatherSequence& sequence, std::size_t side);
  void AddVariance(std::size_t side);
  void Store(SensorReading& reading) const;

  const GatherPass& Pass;
  const SensorDirections& Directions;
  const GatherScene& Gathered;
  const CellExitance& Exitance;
  std::vector<double> ShareOfHalf; ///< [replicate]
  GatherWalk<RayLight> Walk;
  RayLight Light;
  Guide ToLight;
  DirectResult OfLamps;
  glm::dvec3 Normal{ 0.0 };

  // Of the rays that are followed together.
  std::vector<Ray> Rays;
  std::vector<LightThrough> Through;
  std::vector<Measured<float>> Weights;              ///< [ray] By how much its light counts.
  std::vector<std::array<Measured<float>, 2>> Added; ///< [ray] By even and by odd replicates.

  // Of the sensor that is read, in units of light.
  Measured<double> Lamps{};
  std::vector<Measured<double>> Gained; ///< [replicate] By rays.
  Measured<double> VarianceOfLamps{};
  Measured<double> VarianceOfRays{};
  std::array<GlareSum, SensorDirections::Views> Glare{};
};

} // namespace PhotonTransport
