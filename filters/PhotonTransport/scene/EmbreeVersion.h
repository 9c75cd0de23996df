// SPDX-License-Identifier: BSD-3-Clause
// The one place for differences between Embree 3.13 and 4. Not for other headers to include: the
// core shows no Embree to its users.
#pragma once

#if ILLUMINATION_EMBREE_VERSION >= 4
#include <embree4/rtcore.h>
#else
#include <embree3/rtcore.h>
#endif

namespace PhotonTransport
{

/// @param valid -1 for each ray in use, else 0; aligned to 32 bytes.
inline void IntersectFirst(RTCScene scene, const int* valid, RTCRayHit8& rayHits)
{
#if ILLUMINATION_EMBREE_VERSION >= 4
  rtcIntersect8(valid, scene, &rayHits, nullptr);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect8(valid, scene, &context, &rayHits);
#endif
}

/// Sets the far end of each ray that meets anything to minus infinity.
/// @param valid As above.
inline void FindOccluded(RTCScene scene, const int* valid, RTCRay8& rays)
{
#if ILLUMINATION_EMBREE_VERSION >= 4
  rtcOccluded8(valid, scene, &rays, nullptr);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcOccluded8(valid, scene, &context, &rays);
#endif
}

} // namespace PhotonTransport
