// SPDX-License-Identifier: BSD-3-Clause
// Shows Embree, so it is only for EmbreeScene.cxx to include.
#pragma once

#include "PhotonTransport/scene/EmbreeVersion.h"
#include "PhotonTransport/scene/Ray.h"
#include "PhotonTransport/scene/RayPacket.h"

#include <algorithm>
#include <cstddef>

namespace PhotonTransport
{

/// Eight segments as Embree takes them, and whether they meet anything. Serves one group of
/// segments after the other.
class SegmentPacket
{
public:
  /// @param number How many there are, 1 to RayPacket::Size. @param together See EmbreeVersion.h.
  void FindOccluded(RTCScene scene, const Segment* segments, std::size_t number, bool together)
  {
    RayPacket::Mask wanted;
    for (std::size_t lane = 0; lane < RayPacket::Size; ++lane)
    {
      wanted.lanes[lane] = lane < number ? -1 : 0;
      this->Load(lane, segments[std::min(lane, number - 1)]);
    }
    PhotonTransport::FindOccluded(scene, wanted.lanes, this->Rays, together);
  }

  bool IsOccluded(std::size_t lane) const { return this->Rays.tfar[lane] < 0.0f; }

private:
  void Load(std::size_t lane, const Segment& segment)
  {
    this->Rays.org_x[lane] = segment.ray.origin.x;
    this->Rays.org_y[lane] = segment.ray.origin.y;
    this->Rays.org_z[lane] = segment.ray.origin.z;
    this->Rays.dir_x[lane] = segment.ray.direction.x;
    this->Rays.dir_y[lane] = segment.ray.direction.y;
    this->Rays.dir_z[lane] = segment.ray.direction.z;
    this->Rays.tnear[lane] = 0.0f;
    this->Rays.tfar[lane] = segment.length;
    this->Rays.time[lane] = 0.0f;
    this->Rays.mask[lane] = 0xffffffffu;
    this->Rays.id[lane] = 0;
    this->Rays.flags[lane] = 0;
  }

  RTCRay8 Rays;
};

} // namespace PhotonTransport
