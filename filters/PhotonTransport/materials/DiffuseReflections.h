// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/sampling/ScatteringSamples.h"

#include <glm/vec3.hpp>

#include <array>
#include <cstddef>

namespace PhotonTransport
{

/// Finds the directions of many photons together that are reflected diffusely, with the bits of
/// ReflectDiffusely.
class DiffuseReflections
{
public:
  static constexpr std::size_t Most = ScatteringSamples::Most;

  /// The next photon, about the unit normal.
  void Add(const glm::vec3& normal, const ScatteringSample& sample)
  {
    this->X[this->Count] = normal.x;
    this->Y[this->Count] = normal.y;
    this->Z[this->Count] = normal.z;
    this->U[this->Count] = sample.u;
    this->V[this->Count++] = sample.v;
  }
  /// Calls store(place, direction) for all in the order of Add, and starts anew.
  template <typename F>
  void Reflect(const F& store)
  {
    this->FindDirections();
    for (std::size_t i = 0; i < this->Count; ++i)
    {
      store(i, glm::vec3(this->X[i], this->Y[i], this->Z[i]));
    }
    this->Count = 0;
  }

private:
  void FindDirections(); ///< In place of normals.

  std::size_t Count = 0;
  alignas(64) std::array<float, Most> X, Y, Z; ///< Of normals; then of directions.
  alignas(64) std::array<float, Most> U, V;
};

} // namespace PhotonTransport
