// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/CellExitance.h"
#include "PhotonTransport/gathering/GatherFlight.h"
#include "PhotonTransport/gathering/LightSampler.h"
#include "PhotonTransport/gathering/ReceivedLight.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// Keeps what each ray finds, by replicate of the first pass, so that it can be weighed in many
/// ways. It is a sink of GatherWalk, and all light counts alike, whatever its way.
class RayLight
{
public:
  explicit RayLight(const CellExitance& exitance)
    : Exitance(exitance)
  {
  }

  void Start(std::size_t rays) { this->Found.assign(rays * this->Exitance.Replicates(), 0.0f); }
  /// [replicate] pi times the luminance that a ray sees, in units of illuminance.
  const float* Of(std::size_t ray) const { return &this->Found[ray * this->Exitance.Replicates()]; }

  // What GatherWalk asks of a sink.
  float NearUpTo(std::uint32_t cell, bool front, float length) const
  {
    return PhotonTransport::NearUpTo(this->Exitance, SideIndex(cell, front), length);
  }
  void OnCell(const GatherFlight& flight, std::uint32_t cell, bool front)
  {
    this->Add(flight, this->Exitance.leaving.Of(SideIndex(cell, front)));
  }
  void OnFollowed(const GatherFlight&, std::uint32_t, bool) {}
  void OnCaustics(const GatherFlight& flight, std::uint32_t cell, bool front)
  {
    if (const float* caustics = this->Exitance.caustic.Of(SideIndex(cell, front)))
    {
      this->Add(flight, caustics);
    }
  }
  void OnLamp(const GatherFlight& flight, const Colour& lux, std::uint32_t)
  {
    const auto sum = static_cast<float>(SumOfChannels(flight.weight * lux));
    float* found = &this->Found[flight.ray * this->Exitance.Replicates()];
    for (std::size_t r = 0; r < this->Exitance.Replicates(); ++r)
    {
      found[r] += sum;
    }
  }

private:
  /// @param ofCell [replicate][channel]
  void Add(const GatherFlight& flight, const float* ofCell)
  {
    float* found = &this->Found[flight.ray * this->Exitance.Replicates()];
    for (std::size_t r = 0; r < this->Exitance.Replicates(); ++r)
    {
      for (int c = 0; c < static_cast<int>(this->Exitance.channels); ++c)
      {
        found[r] += flight.weight[c] * *ofCell++;
      }
    }
  }

  const CellExitance& Exitance;
  std::vector<float> Found; ///< [ray][replicate]
};

} // namespace PhotonTransport
