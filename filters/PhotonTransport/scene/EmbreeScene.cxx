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
void ShareBuffer(
  RTCGeometry geometry, RTCBufferType type, RTCFormat format, const std::vector<Element>& elements)
{
  void* buffer =
    rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Element), elements.size());
  if (buffer)
  {
    std::memcpy(buffer, elements.data(), elements.size() * sizeof(Element));
  }
}

constexpr std::size_t PacketSize = 8;

void LoadRay(RTCRayHit8& packet, std::size_t lane, const Ray& ray)
{
  packet.ray.org_x[lane] = ray.origin.x;
  packet.ray.org_y[lane] = ray.origin.y;
  packet.ray.org_z[lane] = ray.origin.z;
  packet.ray.dir_x[lane] = ray.direction.x;
  packet.ray.dir_y[lane] = ray.direction.y;
  packet.ray.dir_z[lane] = ray.direction.z;
  packet.ray.tnear[lane] = 0.0f;
  packet.ray.tfar[lane] = std::numeric_limits<float>::infinity();
  packet.ray.time[lane] = 0.0f;
  packet.ray.mask[lane] = 0xffffffffu;
  packet.ray.id[lane] = 0;
  packet.ray.flags[lane] = 0;
  packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
  packet.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
}

Hit StoredHit(const RTCRayHit8& packet, std::size_t lane)
{
  if (packet.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID)
  {
    return Hit();
  }
  // Rounding may put a hit on an edge just outside the facet.
  const float u = std::clamp(packet.hit.u[lane], 0.0f, 1.0f);
  const float v = std::clamp(packet.hit.v[lane], 0.0f, 1.0f - u);
  return { packet.hit.primID[lane], { 1.0f - u - v, u, v } };
}

void IntersectPacket(RTCScene scene, const Ray* rays, Hit* hits, std::size_t count)
{
  alignas(32) int valid[PacketSize] = {};
  RTCRayHit8 packet;
  for (std::size_t lane = 0; lane < count; ++lane)
  {
    valid[lane] = -1;
    LoadRay(packet, lane, rays[lane]);
  }
  IntersectFirst(scene, valid, packet);
  for (std::size_t lane = 0; lane < count; ++lane)
  {
    hits[lane] = StoredHit(packet, lane);
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

void EmbreeScene::Intersect(const Ray* rays, Hit* hits, std::size_t count) const
{
  for (std::size_t first = 0; first < count; first += PacketSize)
  {
    const std::size_t used = std::min(PacketSize, count - first);
    IntersectPacket(this->Impl->scene, rays + first, hits + first, used);
  }
}

void EmbreeScene::ForEachNear(
  const glm::vec3& point, float distance, const std::function<void(std::uint32_t)>& f) const
{
  RTCPointQuery query{ point.x, point.y, point.z, 0.0f, distance };
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  const auto call = [](RTCPointQueryFunctionArguments* found)
  {
    (*static_cast<const std::function<void(std::uint32_t)>*>(found->userPtr))(found->primID);
    return false; // the distance stays as it is
  };
  rtcPointQuery(
    this->Impl->scene, &query, &context, call, const_cast<std::function<void(std::uint32_t)>*>(&f));
}

} // namespace PhotonTransport
