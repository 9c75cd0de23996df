// SPDX-License-Identifier: BSD-3-Clause
#include "BareEmbree.h"

#include "PhotonTransport/scene/EmbreeVersion.h"

#include <oneapi/tbb/blocked_range.h>
#include <oneapi/tbb/parallel_for.h>
#include <oneapi/tbb/task_arena.h>

#include <limits>

namespace
{

void IntersectFirst(RTCScene scene, RTCRayHit& rayHit)
{
#if ILLUMINATION_EMBREE_VERSION >= 4
  rtcIntersect1(scene, &rayHit, nullptr);
#else
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(scene, &context, &rayHit);
#endif
}

} // namespace

struct BareEmbree::Implementation
{
  explicit Implementation(int threads)
    : arena(threads)
  {
  }

  tbb::task_arena arena;
  std::vector<PhotonTransport::Ray> rays;
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
};

BareEmbree::BareEmbree(const PhotonTransport::Scene& scene,
  const std::vector<PhotonTransport::Ray>& rays, int threads, bool robust)
  : Impl(std::make_unique<Implementation>(threads))
{
  this->Impl->rays = rays;
  this->Impl->device = rtcNewDevice(nullptr);
  RTCGeometry geometry = rtcNewGeometry(this->Impl->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  auto* points = static_cast<glm::vec3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX,
    0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3), scene.Vertices().size()));
  for (const PhotonTransport::Vertex& vertex : scene.Vertices())
  {
    *points++ = vertex.position;
  }
  auto* indices = static_cast<glm::uvec3*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX,
    0, RTC_FORMAT_UINT3, sizeof(glm::uvec3), scene.Facets().size()));
  for (const PhotonTransport::Facet& facet : scene.Facets())
  {
    *indices++ = facet.vertices;
  }
  rtcCommitGeometry(geometry);
  this->Impl->scene = rtcNewScene(this->Impl->device);
  rtcSetSceneFlags(this->Impl->scene, robust ? RTC_SCENE_FLAG_ROBUST : RTC_SCENE_FLAG_NONE);
  rtcAttachGeometry(this->Impl->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(this->Impl->scene);
}

BareEmbree::~BareEmbree()
{
  rtcReleaseScene(this->Impl->scene);
  rtcReleaseDevice(this->Impl->device);
}

void BareEmbree::Replay()
{
  this->Impl->arena.execute(
    [&]
    {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, this->Impl->rays.size(), 1024),
        [&](const tbb::blocked_range<std::size_t>& range)
        {
          for (std::size_t i = range.begin(); i < range.end(); ++i)
          {
            const PhotonTransport::Ray& ray = this->Impl->rays[i];
            RTCRayHit rayHit{};
            rayHit.ray.org_x = ray.origin.x;
            rayHit.ray.org_y = ray.origin.y;
            rayHit.ray.org_z = ray.origin.z;
            rayHit.ray.dir_x = ray.direction.x;
            rayHit.ray.dir_y = ray.direction.y;
            rayHit.ray.dir_z = ray.direction.z;
            rayHit.ray.tfar = std::numeric_limits<float>::infinity();
            rayHit.ray.mask = 0xffffffffu;
            rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            IntersectFirst(this->Impl->scene, rayHit);
          }
        });
    });
}
