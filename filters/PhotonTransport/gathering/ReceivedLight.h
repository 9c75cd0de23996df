// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/CellExitance.h"
#include "PhotonTransport/gathering/GatherWalk.h"

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <cstddef>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// Light that arrives at a receiver, in the units of what it is read from. Parts of channels are
/// luminous, so that they add up.
struct ReceivedLight
{
  double direct = 0.0;
  std::vector<double> indirect; ///< By what each replicate of the first pass tells.
  glm::dvec3 channels{ 0.0 };   ///< Of all light, direct and indirect.
  std::vector<double> ofLamps;  ///< All light, by lamp; empty unless lamps are kept apart.

  void Clear(std::size_t replicates, std::size_t lamps)
  {
    this->direct = 0.0;
    this->indirect.assign(replicates, 0.0);
    this->channels = glm::dvec3(0.0);
    this->ofLamps.assign(lamps, 0.0);
  }
};

/// The distance within which a side of a cell may be near; see GatherWalk.
/// @param length Of the cell.
inline float NearUpTo(const CellExitance& exitance, std::size_t side, float length)
{
  constexpr float Anywhere = 1e6f; // where nothing is known
  return exitance.known[side] != 0 ? NearCells * length : Anywhere;
}

/// Where the shares of even and of odd replicates sum to 1 each. [replicate]
std::vector<double> SharesOfHalves(const CellExitance& exitance);

/// Reads what rays find from the first pass, and adds it up.
class LightReader
{
public:
  explicit LightReader(const CellExitance& exitance);

  /// @param factors [ray] By how much what it finds counts.
  void Start(const std::vector<float>& factors, ReceivedLight& light)
  {
    this->Factors = factors.data();
    this->Light = &light;
    this->Found.assign(factors.size(), glm::vec2(0.0f));
    this->Expected.assign(factors.size(), 0.0f);
    this->Followed.assign(factors.size(), 0);
  }
  /// [ray] What to expect, without the factors: what was found, but of facets close to the
  /// receiver what the map tells of them, since a ray that is followed from there tells little.
  const std::vector<float>& ExpectedOfRays() const { return this->Expected; }
  /// [ray] 1 if it has met a facet close to the receiver and was followed from there.
  const std::vector<std::uint8_t>& FollowedRays() const { return this->Followed; }
  /// [ray] What was found, without the factors, by the even and by the odd replicates.
  const std::vector<glm::vec2>& FoundByRays() const { return this->Found; }

  // What GatherWalk asks of a sink.
  float NearUpTo(std::uint32_t cell, bool front, float length) const
  {
    return PhotonTransport::NearUpTo(this->Exitance, SideIndex(cell, front), length);
  }
  void OnCell(const GatherFlight& flight, std::uint32_t cell, bool front);
  void OnFollowed(const GatherFlight& flight, std::uint32_t cell, bool front);
  void OnCaustics(const GatherFlight& flight, std::uint32_t cell, bool front);
  void OnLamp(const GatherFlight& flight, const Colour& lux, std::uint32_t lamp);

private:
  /// Adds what even and odd replicates have found.
  void AddFound(const GatherFlight& flight, const glm::vec2& found)
  {
    this->Found[flight.ray] += found;
    if (!flight.expected)
    {
      this->Expected[flight.ray] += 0.5f * (found.x + found.y);
    }
  }
  void Add(const GatherFlight& flight, const float* ofCell);
  void AddOneChannel(const GatherFlight& flight, const float* ofCell);
  void AddByLamp(const GatherFlight& flight, const float* ofCell);

  const CellExitance& Exitance;
  const float* Factors = nullptr;
  ReceivedLight* Light = nullptr;
  std::vector<glm::vec2> Found;
  std::vector<float> Expected;
  std::vector<std::uint8_t> Followed;
  /// [replicate] Its share in the mean of the even or the odd replicates.
  std::vector<double> ShareOfHalf;
};

} // namespace PhotonTransport
