// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/openings/SeenOpening.h"

#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// All openings as they are seen from a point.
class SeenOpenings
{
public:
  /// A direction towards one of them.
  struct Sample
  {
    std::uint32_t opening;
    glm::vec3 direction;
    double weight; ///< As that of OpeningSample, for all openings together.

    /// See PhotonTransport::FactorOf. @param normal Unit.
    float FactorOf(const glm::vec3& normal) const
    {
      return static_cast<float>(PhotonTransport::FactorOf(this->direction, this->weight, normal));
    }
  };

  /// @param openings Must outlive it.
  SeenOpenings(const Openings& openings, const glm::vec3& from)
  {
    this->Seen.reserve(openings.List().size());
    for (const Opening& opening : openings.List())
    {
      this->Seen.emplace_back(opening, from);
      this->All += this->Seen.back().SolidAngle();
    }
  }

  double SolidAngle() const { return this->All; }
  const SeenOpening& operator[](std::size_t opening) const { return this->Seen[opening]; }

  /// Draws an opening by its solid angle, and a direction towards it. SolidAngle() must not be 0.
  /// @param choice, u, v In [0, 1).
  Sample Draw(double choice, float u, float v) const
  {
    double left = choice * this->All;
    std::uint32_t chosen = 0;
    while (chosen + 1 < this->Seen.size() && left >= this->Seen[chosen].SolidAngle())
    {
      left -= this->Seen[chosen++].SolidAngle();
    }
    const double own = this->Seen[chosen].SolidAngle();
    if (!(own > 0.0)) // rounding has led past all that are seen
    {
      return { chosen, glm::vec3(0.0f), 0.0 };
    }
    const OpeningSample sample = this->Seen[chosen].Sample(u, v);
    return { chosen, sample.direction, sample.weight * this->All / own };
  }

private:
  std::vector<SeenOpening> Seen;
  double All = 0.0;
};

} // namespace PhotonTransport
