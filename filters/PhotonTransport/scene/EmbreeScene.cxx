// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/EmbreeScene.h"

#include "PhotonTransport/scene/EmbreeVersion.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>
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
  for (const FacetPart& part : parts)
  {
    const auto first = static_cast<unsigned>(points.size());
    points.insert(points.end(), part.positions.begin(), part.positions.end());
    facets.emplace_back(first, first + 1, first + 2);
    facets[part.facet] = glm::uvec3(facets[part.facet].x);
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

bool HasHit(const RTCRayHit8& packet, std::size_t lane)
{
  return packet.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID;
}

/// A ray this many times as long as its hit is far from the origin is traced again from near.
constexpr float FarRay = 16.0f;

/// Where it starts then, before its hit, in lengths of the ray: 128 times the rounding of a
/// coordinate, which the error of the hit does not reach but where the ray is in the facet's plane.
constexpr float Approach = 0x1p-17f;

/// -1 for each lane whose hit is to be looked for again from near, else 0. @return Whether any is.
bool FindFarRays(const RTCRayHit8& packet, int (&far)[PacketSize])
{
  int any = 0;
  for (std::size_t lane = 0; lane < PacketSize; ++lane) // simple enough to become vector operations
  {
    const float length = packet.ray.tfar[lane];
    const float x = std::fabs(packet.ray.org_x[lane] + length * packet.ray.dir_x[lane]);
    const float y = std::fabs(packet.ray.org_y[lane] + length * packet.ray.dir_y[lane]);
    const float z = std::fabs(packet.ray.org_z[lane] + length * packet.ray.dir_z[lane]);
    const float most = length * (1.0f / FarRay);
    // Without a hit the length is infinite and so is, or is no number, at least one of the three.
    far[lane] = -static_cast<int>((x < most) & (y < most) & (z < most));
    any |= far[lane];
  }
  return any != 0;
}

/// The same ray from shortly before its hit to shortly behind it.
void LoadRayFromNear(RTCRayHit8& packet, std::size_t lane, const Ray& ray, float length)
{
  const double along = double{ length } * (1.0 - double{ Approach });
  const glm::dvec3 start = glm::dvec3(ray.origin) + along * glm::dvec3(ray.direction);
  LoadRay(packet, lane, { glm::vec3(start), ray.direction });
  packet.ray.tfar[lane] = 2.0f * Approach * length;
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
    if (this->scene)
    {
      rtcReleaseScene(this->scene);
    }
    if (this->device)
    {
      rtcReleaseDevice(this->device);
    }
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

  void StoreHit(const RTCRayHit8& packet, std::size_t lane, Hit& hit) const
  {
    // Rounding may put a hit on an edge just outside the facet.
    const float u = std::clamp(packet.hit.u[lane], 0.0f, 1.0f);
    const float v = std::clamp(packet.hit.v[lane], 0.0f, 1.0f - u);
    hit.facet = packet.hit.primID[lane];
    hit.barycentric = { 1.0f - u - v, u, v };
    hit.part = NoPart;
    if (hit.facet >= this->facets)
    {
      hit.part = hit.facet - static_cast<std::uint32_t>(this->facets);
      hit.inPart = hit.barycentric;
      hit.facet = this->parts[hit.part].facet;
      hit.barycentric = this->parts[hit.part].InFacet(hit.inPart);
    }
  }

  void IntersectPacket(const Ray* rays, Hit* hits, std::size_t count) const
  {
    alignas(32) int valid[PacketSize] = {};
    RTCRayHit8 packet;
    for (std::size_t lane = 0; lane < PacketSize; ++lane)
    {
      valid[lane] = lane < count ? -1 : 0;
      LoadRay(packet, lane, rays[std::min(lane, count - 1)]);
    }
    IntersectFirst(this->scene, valid, packet);
    for (std::size_t lane = 0; lane < count; ++lane)
    {
      hits[lane].facet = NoFacet;
      if (HasHit(packet, lane))
      {
        this->StoreHit(packet, lane, hits[lane]);
      }
    }
    alignas(32) int far[PacketSize];
    if (FindFarRays(packet, far))
    {
      this->IntersectAgain(packet, far, rays, hits, count);
    }
  }

  void IntersectAgain(const RTCRayHit8& packet, const int (&far)[PacketSize], const Ray* rays,
    Hit* hits, std::size_t count) const
  {
    RTCRayHit8 closer = packet;
    for (std::size_t lane = 0; lane < count; ++lane)
    {
      if (far[lane] != 0)
      {
        LoadRayFromNear(closer, lane, rays[lane], packet.ray.tfar[lane]);
      }
    }
    IntersectFirst(this->scene, far, closer);
    for (std::size_t lane = 0; lane < count; ++lane)
    {
      if (far[lane] != 0 && HasHit(closer, lane))
      {
        this->StoreHit(closer, lane, hits[lane]);
      }
    }
  }
};

EmbreeScene::EmbreeScene(
  std::vector<glm::vec3> points, std::vector<glm::uvec3> facets, std::vector<FacetPart> parts)
  : Impl(MakeProcessPtr<Implementation>())
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

const FacetPart& EmbreeScene::Part(std::uint32_t part) const
{
  return this->Impl->parts[part];
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
