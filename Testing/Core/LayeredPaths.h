// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/materials/BackwardScattering.h"

#include "RandomNumbers.h"

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

/// Paths between two patches by way of horizontal planes, in either direction.
namespace LayeredPaths
{

/// A horizontal square that shines by Lambert's law or receives light, on one side.
struct Patch
{
  glm::vec3 centre;
  float halfWidth;
  float side; ///< 1: up, -1: down.

  double Area() const { return 4.0 * double{ this->halfWidth } * double{ this->halfWidth }; }
};

/// An endless horizontal plane.
struct Plane
{
  float height;
  PhotonTransport::Roulette material;
  bool frontUp = true;
};

/// Planes from top to bottom, a patch that shines and one that receives. Patches let light pass.
struct Layers
{
  std::vector<Plane> planes;
  Patch source, receiver;
};

/// A path through the layers, which ends as `step` says.
struct Path
{
  glm::vec3 origin, direction;
  std::size_t above = 0; ///< Planes above it.
  PhotonTransport::Colour weight{ 1.0f };

  Path(const Patch& from, const std::vector<Plane>& planes, RandomNumbers& random)
  {
    const float x = 2.0f * random.Unit() - 1.0f;
    const float y = 2.0f * random.Unit() - 1.0f;
    this->origin = from.centre + from.halfWidth * glm::vec3(x, y, 0.0f);
    const float u = random.Unit();
    this->direction = from.side * PhotonTransport::CosineHemisphere(u, random.Unit());
    for (const Plane& plane : planes)
    {
      this->above += plane.height > this->origin.z ? 1 : 0;
    }
  }

  /// The plane that it meets; none if it escapes.
  const Plane* Next(const std::vector<Plane>& planes) const
  {
    const bool down = this->direction.z < 0.0f;
    const std::size_t next = down ? this->above : this->above - 1;
    return next < planes.size() && this->direction.z != 0.0f ? &planes[next] : nullptr;
  }
  /// Whether it crosses a patch on its way to the next plane.
  bool Crosses(const Patch& patch, const Plane* next) const
  {
    const float way = (patch.centre.z - this->origin.z) / this->direction.z;
    const float end = next ? (next->height - this->origin.z) / this->direction.z
                           : std::numeric_limits<float>::max();
    const glm::vec3 off = this->origin + way * this->direction - patch.centre;
    return way > 0.0f && way < end && this->direction.z * patch.side < 0.0f &&
      std::max(std::fabs(off.x), std::fabs(off.y)) < patch.halfWidth;
  }
  /// @param step Whether and how it goes on.
  void GoOn(const Plane& plane, const PhotonTransport::FollowedRay& step)
  {
    this->origin += (plane.height - this->origin.z) / this->direction.z * this->direction;
    this->origin.z = plane.height;
    if (!step.sameSide)
    {
      this->above = this->direction.z < 0.0f ? this->above + 1 : this->above - 1;
    }
    this->direction = step.direction;
    this->weight *= step.weight;
  }
};

/// Mean over many paths and its variance, by channel and of their luminous sum.
struct Estimate
{
  std::array<double, 4> mean{}, variance{};

  /// @param step Called as step(plane, path, sample).
  template <class Step>
  Estimate(const Layers& layers, const Patch& from, const Patch& to, double scale,
    RandomNumbers& random, const Step& step)
  {
    constexpr int Paths = 150'000;
    std::array<double, 4> sums{}, squares{};
    for (int i = 0; i < Paths; ++i)
    {
      const std::array<double, 4> values = Follow(layers, from, to, random, step);
      for (std::size_t c = 0; c < 4; ++c)
      {
        sums[c] += values[c];
        squares[c] += values[c] * values[c];
      }
    }
    for (std::size_t c = 0; c < 4; ++c)
    {
      this->mean[c] = scale * sums[c] / Paths;
      this->variance[c] =
        scale * scale * (squares[c] / Paths - std::pow(sums[c] / Paths, 2)) / Paths;
    }
  }

private:
  template <class Step>
  static std::array<double, 4> Follow(const Layers& layers, const Patch& from, const Patch& to,
    RandomNumbers& random, const Step& step)
  {
    Path path(from, layers.planes, random);
    PhotonTransport::Colour sum(0.0f);
    for (int order = 0; order < 1000; ++order)
    {
      const Plane* next = path.Next(layers.planes);
      // Light that comes straight is not what is tested.
      sum += order > 0 && path.Crosses(to, next) ? path.weight : PhotonTransport::Colour(0.0f);
      if (!next)
      {
        break;
      }
      const PhotonTransport::ScatteringSample sample{ random.Bits(), random.Unit(), random.Unit() };
      const PhotonTransport::FollowedRay onward = step(*next, path, sample);
      if (!onward.goesOn)
      {
        break;
      }
      path.GoOn(*next, onward);
    }
    return { double{ sum.x }, double{ sum.y }, double{ sum.z },
      double{ glm::dot(sum, PhotonTransport::LuminousWeights) } };
  }
};

} // namespace LayeredPaths
