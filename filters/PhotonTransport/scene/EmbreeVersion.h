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
/// @param valid As above. @param together Whether all rays go through the tree together, which is
/// faster where they are neighbours.
inline void FindOccluded(RTCScene scene, const int* valid, RTCRay8& rays, bool together)
{
#if ILLUMINATION_EMBREE_VERSION >= 4
  RTCOccludedArguments arguments;
  rtcInitOccludedArguments(&arguments);
  arguments.flags = together ? RTC_RAY_QUERY_FLAG_COHERENT : RTC_RAY_QUERY_FLAG_INCOHERENT;
  rtcOccluded8(valid, scene, &rays, &arguments);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  context.flags =
    together ? RTC_INTERSECT_CONTEXT_FLAG_COHERENT : RTC_INTERSECT_CONTEXT_FLAG_INCOHERENT;
  rtcOccluded8(valid, scene, &context, &rays);
#endif
}

} // namespace PhotonTransport
