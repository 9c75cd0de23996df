// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/GatherPass.h"
#include "PhotonTransport/gathering/GatheredMap.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace PhotonTransport
{

/// The light at points: first the vertices of the map, and then others in the order in which they
/// are added. On the front, and on the back if that is registered.
class LightSamples
{
public:
  /// @param front, back At the vertices; `back` is empty unless it is registered.
  LightSamples(const GatheredMap& front, const GatheredMap& back);

  std::size_t Number() const { return this->Sides[0].direct.size(); }

  /// Receives light at so many points more.
  /// @param make Makes the receiver for the i-th of them. @param report Gets how many points beyond
  /// the vertices have been done. @return False if it was stopped: then none is added.
  bool Add(std::size_t number,
    const std::function<void(std::size_t i, bool front, Receiver& receiver)>& make,
    const GatherPass& pass, const GatherPass::Report& report);

  /// The darkest light that errors are relative to, on both sides, lx.
  struct Floor
  {
    double front;
    double back;
  };
  /// By how much the mean of two samples misses the one in the middle between them, lx, on the side
  /// where that is more; 0 if it is within the tolerance or may be noise.
  double Miss(
    std::size_t a, std::size_t middle, std::size_t b, double tolerance, const Floor& darkest) const;

  /// Some of the samples as a map.
  GatheredMap Front(const std::vector<std::uint32_t>& samples) const;
  GatheredMap Back(const std::vector<std::uint32_t>& samples) const;

private:
  bool HasBack() const { return !this->Sides[1].direct.empty(); }
  void Resize(std::size_t number);
  GatheredMap Chosen(const GatheredMap& side, const std::vector<std::uint32_t>& samples) const;

  GatheredMap Sides[2];
  std::size_t Vertices;
  std::size_t Lamps; ///< That are kept apart.
};

} // namespace PhotonTransport
