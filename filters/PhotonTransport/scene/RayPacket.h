// SPDX-License-Identifier: BSD-3-Clause
// Shows Embree, so it is only for EmbreeScene.cxx to include.
#pragma once

#include "PhotonTransport/scene/EmbreeVersion.h"
#include "PhotonTransport/scene/Ray.h"

#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

namespace PhotonTransport
{

/// A ray is traced again from near its hit if it is this many times as long as its hit is far from
/// the scene's origin.
constexpr float FarRay = 16.0f;

/// How far before its hit such a ray starts the second time, in lengths of the ray: 128 times the
/// rounding of a coordinate. The error of the hit is less unless the ray is in the facet's plane.
constexpr float Approach = 0x1p-17f;

/// Eight rays as Embree takes them, and what each meets first. Serves one group of rays after the
/// other.
class RayPacket
{
public:
  static constexpr std::size_t Size = 8;

  /// For each ray whether it is wanted: -1, else 0.
  struct alignas(32) Mask
  {
    int lanes[Size];
  };

  /// Barycentric coordinates of all hits.
  struct Coordinates
  {
    alignas(16) float a[Size], b[Size], c[Size];
  };

  /// Sets what Embree leaves as it is.
  RayPacket()
  {
    for (std::size_t lane = 0; lane < Size; ++lane)
    {
      this->Data.ray.tnear[lane] = 0.0f;
      this->Data.ray.time[lane] = 0.0f;
      this->Data.ray.mask[lane] = 0xffffffffu;
      this->Data.ray.id[lane] = 0;
      this->Data.ray.flags[lane] = 0;
      this->Data.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
      this->Data.hit.u[lane] = this->Data.hit.v[lane] = 0.0f;
    }
  }

  void Load(std::size_t lane, const Ray& ray)
  {
    this->Data.ray.org_x[lane] = ray.origin.x;
    this->Data.ray.org_y[lane] = ray.origin.y;
    this->Data.ray.org_z[lane] = ray.origin.z;
    this->Data.ray.dir_x[lane] = ray.direction.x;
    this->Data.ray.dir_y[lane] = ray.direction.y;
    this->Data.ray.dir_z[lane] = ray.direction.z;
    this->Data.ray.tfar[lane] = std::numeric_limits<float>::infinity();
    this->Data.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    this->Data.hit.primID[lane] = NoFacet; // which it still is if nothing is hit
  }

  /// The same ray from shortly before its hit to shortly behind it.
  void LoadFromNear(std::size_t lane, const Ray& ray)
  {
    const float length = this->Data.ray.tfar[lane];
    const double along = double{ length } * (1.0 - double{ Approach });
    const glm::dvec3 start = glm::dvec3(ray.origin) + along * glm::dvec3(ray.direction);
    this->Load(lane, { glm::vec3(start), ray.direction });
    this->Data.ray.tfar[lane] = 2.0f * Approach * length;
  }

  void Intersect(RTCScene scene, const Mask& wanted)
  {
    IntersectFirst(scene, wanted.lanes, this->Data);
  }

  /// NoFacet if the ray meets nothing.
  std::uint32_t Primitive(std::size_t lane) const { return this->Data.hit.primID[lane]; }

  Coordinates BarycentricCoordinates() const
  {
    // Vectors of four by hand: compilers make sixteen comparisons of a loop.
    using Four = float __attribute__((vector_size(16)));
    Coordinates all;
    for (std::size_t lane = 0; lane < Size; lane += 4)
    {
      Four b, c;
      std::memcpy(&b, &this->Data.hit.u[lane], sizeof b);
      std::memcpy(&c, &this->Data.hit.v[lane], sizeof c);
      // Rounding may put a hit on an edge just outside the facet.
      const Four zero{};
      const Four one = zero + 1.0f;
      b = b < zero ? zero : b;
      b = one < b ? one : b;
      const Four rest = one - b;
      c = c < zero ? zero : c;
      c = rest < c ? rest : c;
      const Four a = rest - c;
      std::memcpy(&all.a[lane], &a, sizeof a);
      std::memcpy(&all.b[lane], &b, sizeof b);
      std::memcpy(&all.c[lane], &c, sizeof c);
    }
    return all;
  }

  /// Finds the rays whose hits are to be looked for again from near. @return Whether there are any.
  bool FindFar(Mask& far) const
  {
    int any = 0;
    for (std::size_t lane = 0; lane < Size; ++lane) // simple enough to become vector operations
    {
      const auto& ray = this->Data.ray;
      const float length = ray.tfar[lane];
      const float x = std::fabs(ray.org_x[lane] + length * ray.dir_x[lane]);
      const float y = std::fabs(ray.org_y[lane] + length * ray.dir_y[lane]);
      const float z = std::fabs(ray.org_z[lane] + length * ray.dir_z[lane]);
      const float most = length * (1.0f / FarRay);
      // Without a hit the length is infinite and so is, or is no number, at least one of the three.
      far.lanes[lane] = -static_cast<int>((x < most) & (y < most) & (z < most));
      any |= far.lanes[lane];
    }
    return any != 0;
  }

private:
  RTCRayHit8 Data;
};

} // namespace PhotonTransport
