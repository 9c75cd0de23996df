// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/EmbreeScene.h"

#include "PhotonTransport/scene/EmbreeVersion.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

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
void CopyToBuffer(
  RTCGeometry geometry, RTCBufferType type, RTCFormat format, const std::vector<Element>& elements)
{
  void* buffer =
    rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Element), elements.size());
  if (buffer)
  {
    std::memcpy(buffer, elements.data(), elements.size() * sizeof(Element));
  }
}

/// Adds the parts to what Embree gets, after the facets. A facet that has parts is left without
/// extent, so that the numbers of the others stay theirs.
void AddParts(const std::vector<FacetPart>& parts, std::vector<glm::vec3>& points,
  std::vector<glm::uvec3>& facets)
{
  const std::vector<glm::uvec3> whole = parts.empty() ? std::vector<glm::uvec3>() : facets;
  for (const FacetPart& part : parts)
  {
    const glm::uvec3& ids = whole[part.facet];
    const std::array<glm::vec3, 3> corners{ points[ids.x], points[ids.y], points[ids.z] };
    const auto first = static_cast<unsigned>(points.size());
    for (const glm::vec3& corner : part.corners)
    {
      points.push_back(PositionOf(corner, corners));
    }
    facets.emplace_back(first, first + 1, first + 2);
    facets[part.facet] = glm::uvec3(ids.x);
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

/// A ray this many times as long as its hit is far from the origin is traced again from near.
constexpr float FarRay = 16.0f;

/// Where it starts then, before its hit, in lengths of the ray: 128 times the rounding of a
/// coordinate, which the error of the hit does not reach but where the ray is in the facet's plane.
constexpr float Approach = 0x1p-17f;

/// The rays whose hits are to be looked for again, started near them.
/// @param again Set to -1 for each of them, else to 0. @return Whether there are any.
bool StartFarRaysNear(const RTCRayHit8& packet, const Ray* rays, std::size_t count,
  RTCRayHit8& closer, int (&again)[PacketSize])
{
  bool any = false;
  for (std::size_t lane = 0; lane < count; ++lane)
  {
    const float length = packet.ray.tfar[lane]; // infinite without a hit
    const glm::vec3 end = glm::abs(rays[lane].origin + length * rays[lane].direction);
    const float reach = std::max({ end.x, end.y, end.z });
    const bool far = length > FarRay * reach && length < std::numeric_limits<float>::max();
    again[lane] = far ? -1 : 0;
    if (far)
    {
      const double along = double{ length } * (1.0 - double{ Approach });
      const glm::dvec3 start =
        glm::dvec3(rays[lane].origin) + along * glm::dvec3(rays[lane].direction);
      LoadRay(closer, lane, { glm::vec3(start), rays[lane].direction });
      closer.ray.tfar[lane] = 2.0f * Approach * length;
      any = true;
    }
  }
  return any;
}

} // namespace

struct EmbreeScene::Implementation
{
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  std::size_t facets = 0;       ///< Primitives from here on are parts.
  std::vector<FacetPart> parts; ///< Of facets that are no primitives themselves.
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

  std::uint32_t FacetOf(std::uint32_t primitive) const
  {
    return primitive < this->facets ? primitive : this->parts[primitive - this->facets].facet;
  }

  Hit StoredHit(const RTCRayHit8& packet, std::size_t lane) const
  {
    if (packet.hit.geomID[lane] == RTC_INVALID_GEOMETRY_ID)
    {
      return Hit();
    }
    // Rounding may put a hit on an edge just outside the facet.
    const float u = std::clamp(packet.hit.u[lane], 0.0f, 1.0f);
    const float v = std::clamp(packet.hit.v[lane], 0.0f, 1.0f - u);
    const glm::vec3 barycentric(1.0f - u - v, u, v);
    const std::uint32_t primitive = packet.hit.primID[lane];
    if (primitive < this->facets)
    {
      return { primitive, barycentric };
    }
    const FacetPart& part = this->parts[primitive - this->facets];
    return { part.facet, part.InFacet(barycentric) };
  }

  void IntersectPacket(const Ray* rays, Hit* hits, std::size_t count) const
  {
    alignas(32) int valid[PacketSize] = {};
    RTCRayHit8 packet;
    for (std::size_t lane = 0; lane < count; ++lane)
    {
      valid[lane] = -1;
      LoadRay(packet, lane, rays[lane]);
    }
    IntersectFirst(this->scene, valid, packet);
    for (std::size_t lane = 0; lane < count; ++lane)
    {
      hits[lane] = this->StoredHit(packet, lane);
    }
    alignas(32) int again[PacketSize] = {};
    RTCRayHit8 closer;
    if (StartFarRaysNear(packet, rays, count, closer, again))
    {
      IntersectFirst(this->scene, again, closer);
      for (std::size_t lane = 0; lane < count; ++lane)
      {
        const Hit nearer = again[lane] != 0 ? this->StoredHit(closer, lane) : Hit();
        hits[lane] = nearer ? nearer : hits[lane];
      }
    }
  }
};

EmbreeScene::EmbreeScene(
  std::vector<glm::vec3> points, std::vector<glm::uvec3> facets, std::vector<FacetPart> parts)
  : Impl(std::make_unique<Implementation>())
{
  this->Impl->facets = facets.size();
  AddParts(parts, points, facets);
  this->Impl->parts = std::move(parts);
  this->Impl->device = rtcNewDevice(nullptr);
  if (!this->Impl->device)
  {
    throw std::runtime_error("Embree: no device");
  }
  rtcSetDeviceErrorFunction(this->Impl->device, KeepFirstMessage, &this->Impl->message);

  RTCGeometry geometry = rtcNewGeometry(this->Impl->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  CopyToBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, points);
  CopyToBuffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, facets);
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
    this->Impl->IntersectPacket(rays + first, hits + first, used);
  }
}

void EmbreeScene::ForEachNear(
  const glm::vec3& point, float distance, const std::function<void(std::uint32_t)>& f) const
{
  RTCPointQuery query{ point.x, point.y, point.z, 0.0f, distance };
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  std::function<void(std::uint32_t)> onPrimitive = [&](std::uint32_t primitive)
  { f(this->Impl->FacetOf(primitive)); };
  const auto call = [](RTCPointQueryFunctionArguments* found)
  {
    (*static_cast<std::function<void(std::uint32_t)>*>(found->userPtr))(found->primID);
    return false; // the distance stays as it is
  };
  rtcPointQuery(this->Impl->scene, &query, &context, call, &onPrimitive);
}

} // namespace PhotonTransport
