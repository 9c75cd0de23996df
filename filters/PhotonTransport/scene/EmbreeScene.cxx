// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/EmbreeScene.h"

#include "PhotonTransport/scene/EmbreeVersion.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>

namespace PhotonTransport
{
namespace
{

/// Embree reports through a callback; the first message is the one that explains.
void KeepFirstMessage(void* message, RTCError, const char* text)
{
  auto* kept = static_cast<std::string*>(message);
  if (kept->empty())
  {
    *kept = text ? text : "unknown error";
  }
}

template <typename Element>
void ShareBuffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format,
  const std::vector<Element>& elements)
{
  void* buffer =
    rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Element), elements.size());
  if (buffer)
  {
    std::memcpy(buffer, elements.data(), elements.size() * sizeof(Element));
  }
}

} // namespace

struct EmbreeScene::Implementation
{
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::string message;

  ~Implementation()
  {
    rtcReleaseScene(this->scene);
    rtcReleaseDevice(this->device);
  }

  void ThrowOnError() const
  {
    if (!this->message.empty())
    {
      throw std::runtime_error("Embree: " + this->message);
    }
  }
};

EmbreeScene::EmbreeScene(
  const std::vector<glm::vec3>& points, const std::vector<glm::uvec3>& facets)
  : Impl(std::make_unique<Implementation>())
{
  this->Impl->device = rtcNewDevice(nullptr);
  if (!this->Impl->device)
  {
    throw std::runtime_error("Embree: no device");
  }
  rtcSetDeviceErrorFunction(this->Impl->device, KeepFirstMessage, &this->Impl->message);

  RTCGeometry geometry = rtcNewGeometry(this->Impl->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  ShareBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, points);
  ShareBuffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, facets);
  rtcCommitGeometry(geometry);

  this->Impl->scene = rtcNewScene(this->Impl->device);
  // Robust: rays must not slip through shared edges. The default (medium) build quality: high
  // gained no rate that could be measured.
  rtcSetSceneFlags(this->Impl->scene, RTC_SCENE_FLAG_ROBUST);
  rtcAttachGeometry(this->Impl->scene, geometry);
  rtcReleaseGeometry(geometry);
  rtcCommitScene(this->Impl->scene);
  this->Impl->ThrowOnError();
}

EmbreeScene::~EmbreeScene() = default;
EmbreeScene::EmbreeScene(EmbreeScene&&) noexcept = default;
EmbreeScene& EmbreeScene::operator=(EmbreeScene&&) noexcept = default;

Hit EmbreeScene::Intersect(const Ray& ray) const
{
  RTCRayHit rayHit;
  rayHit.ray.org_x = ray.origin.x;
  rayHit.ray.org_y = ray.origin.y;
  rayHit.ray.org_z = ray.origin.z;
  rayHit.ray.dir_x = ray.direction.x;
  rayHit.ray.dir_y = ray.direction.y;
  rayHit.ray.dir_z = ray.direction.z;
  rayHit.ray.tnear = 0.0f;
  rayHit.ray.tfar = std::numeric_limits<float>::infinity();
  rayHit.ray.time = 0.0f;
  rayHit.ray.mask = 0xffffffffu;
  rayHit.ray.id = 0;
  rayHit.ray.flags = 0;
  rayHit.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  rayHit.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  IntersectFirst(this->Impl->scene, rayHit);

  Hit hit;
  if (rayHit.hit.geomID != RTC_INVALID_GEOMETRY_ID)
  {
    // Rounding may put a hit on an edge just outside the facet.
    const float u = std::clamp(rayHit.hit.u, 0.0f, 1.0f);
    const float v = std::clamp(rayHit.hit.v, 0.0f, 1.0f - u);
    hit.facet = rayHit.hit.primID;
    hit.barycentric = { 1.0f - u - v, u, v };
  }
  return hit;
}

} // namespace PhotonTransport
