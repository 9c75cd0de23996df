// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/scene/EmbreeScene.h"

#include "PhotonTransport/scene/EmbreeVersion.h"
#include "PhotonTransport/scene/RayPacket.h"
#include "PhotonTransport/scene/SegmentPacket.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
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

void ShareBuffers(
  RTCGeometry geometry, const LargeArray<Vertex>& vertices, const LargeArray<Facet>& facets)
{
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
    vertices.data(), offsetof(Vertex, position), sizeof(Vertex), vertices.size());
  rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, facets.data(),
    offsetof(Facet, vertices), sizeof(Facet), facets.size());
}

/// Embree gets copies, with the parts after the facets. A facet that has parts stays in the list
/// without extent, so that the other facets keep their numbers.
void CopyBuffersWithParts(RTCGeometry geometry, const LargeArray<Vertex>& vertices,
  const LargeArray<Facet>& facets, const std::vector<FacetPart>& parts)
{
  std::vector<glm::vec3> points;
  points.reserve(vertices.size() + 3 * parts.size());
  for (const Vertex& vertex : vertices)
  {
    points.push_back(vertex.position);
  }
  std::vector<glm::uvec3> indices;
  indices.reserve(facets.size() + parts.size());
  for (const Facet& facet : facets)
  {
    indices.push_back(facet.vertices);
  }
  for (const FacetPart& part : parts)
  {
    const auto first = static_cast<unsigned>(points.size());
    points.insert(points.end(), part.positions.begin(), part.positions.end());
    indices.emplace_back(first, first + 1, first + 2);
    indices[part.facet] = glm::uvec3(indices[part.facet].x);
  }
  CopyToBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, points);
  CopyToBuffer(geometry, RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3, indices);
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

  void StoreHit(const RayPacket& packet, const RayPacket::Coordinates& coordinates,
    std::size_t lane, Hit& hit) const
  {
    hit.facet = packet.Primitive(lane);
    hit.barycentric = { coordinates.a[lane], coordinates.b[lane], coordinates.c[lane] };
    hit.part = NoPart;
    if (hit.facet >= this->facets)
    {
      this->MovePartToFacet(hit);
    }
  }

  /// It is not inlined, since it is rare and the hot code must stay small.
  [[gnu::noinline]] void MovePartToFacet(Hit& hit) const
  {
    if (hit)
    {
      hit.part = hit.facet - static_cast<std::uint32_t>(this->facets);
      hit.inPart = hit.barycentric;
      hit.facet = this->parts[hit.part].facet;
      hit.barycentric = this->parts[hit.part].InFacet(hit.inPart);
    }
  }

  /// @param rays As many as a packet holds. @param count How many of their hits are wanted.
  [[gnu::noinline]] void IntersectPacket(RayPacket& packet, const RayPacket::Mask& wanted,
    const Ray* rays, Hit* hits, std::size_t count) const
  {
    for (std::size_t lane = 0; lane < RayPacket::Size; ++lane)
    {
      packet.Load(lane, rays[lane]);
    }
    packet.Intersect(this->scene, wanted);
    const RayPacket::Coordinates coordinates = packet.BarycentricCoordinates();
    for (std::size_t lane = 0; lane < count; ++lane)
    {
      this->StoreHit(packet, coordinates, lane, hits[lane]);
    }
    RayPacket::Mask far;
    if (packet.FindFar(far))
    {
      this->IntersectAgain(packet, far, rays, hits, count);
    }
  }

  /// For fewer rays than a packet holds: the last one fills it.
  void IntersectFew(RayPacket& packet, const Ray* rays, Hit* hits, std::size_t count) const
  {
    RayPacket::Mask wanted;
    std::array<Ray, RayPacket::Size> filled;
    for (std::size_t lane = 0; lane < RayPacket::Size; ++lane)
    {
      wanted.lanes[lane] = lane < count ? -1 : 0;
      filled[lane] = rays[std::min(lane, count - 1)];
    }
    this->IntersectPacket(packet, wanted, filled.data(), hits, count);
  }

  [[gnu::noinline]] void IntersectAgain(RayPacket& packet, const RayPacket::Mask& far,
    const Ray* rays, Hit* hits, std::size_t count) const
  {
    for (std::size_t lane = 0; lane < count; ++lane)
    {
      if (far.lanes[lane] != 0)
      {
        packet.LoadFromNear(lane, rays[lane]);
      }
    }
    packet.Intersect(this->scene, far);
    const RayPacket::Coordinates coordinates = packet.BarycentricCoordinates();
    for (std::size_t lane = 0; lane < count; ++lane)
    {
      if (far.lanes[lane] != 0 && packet.Primitive(lane) != NoFacet)
      {
        this->StoreHit(packet, coordinates, lane, hits[lane]);
      }
    }
  }
};

EmbreeScene::EmbreeScene(
  const LargeArray<Vertex>& vertices, const LargeArray<Facet>& facets, std::vector<FacetPart> parts)
  : Impl(MakeProcessPtr<Implementation>())
{
  this->Impl->facets = facets.size();
  this->Impl->parts = std::move(parts);
  this->Impl->device = rtcNewDevice(nullptr);
  if (!this->Impl->device)
  {
    throw std::runtime_error("Embree: no device");
  }
  rtcSetDeviceErrorFunction(this->Impl->device, KeepFirstMessage, &this->Impl->message);

  RTCGeometry geometry = rtcNewGeometry(this->Impl->device, RTC_GEOMETRY_TYPE_TRIANGLE);
  if (this->Impl->parts.empty())
  {
    ShareBuffers(geometry, vertices, facets);
  }
  else
  {
    CopyBuffersWithParts(geometry, vertices, facets, this->Impl->parts);
  }
  rtcCommitGeometry(geometry);

  this->Impl->scene = rtcNewScene(this->Impl->device);
  // Robust, since rays must not slip through shared edges. The build quality is the default
  // (medium), since high quality gained no rate that could be measured.
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
  static constexpr RayPacket::Mask All{ { -1, -1, -1, -1, -1, -1, -1, -1 } };
  RayPacket packet;
  std::size_t first = 0;
  for (; first + RayPacket::Size <= count; first += RayPacket::Size)
  {
    this->Impl->IntersectPacket(packet, All, rays + first, hits + first, RayPacket::Size);
  }
  if (first < count)
  {
    this->Impl->IntersectFew(packet, rays + first, hits + first, count - first);
  }
}

void EmbreeScene::FindOccluded(
  const Segment* segments, std::uint8_t* occluded, std::size_t count, bool neighbours) const
{
  SegmentPacket packet;
  for (std::size_t first = 0; first < count; first += RayPacket::Size)
  {
    const std::size_t number = std::min(count - first, RayPacket::Size);
    packet.FindOccluded(this->Impl->scene, segments + first, number, neighbours);
    for (std::size_t lane = 0; lane < number; ++lane)
    {
      occluded[first + lane] = packet.IsOccluded(lane);
    }
  }
}

const FacetPart& EmbreeScene::Part(std::uint32_t part) const
{
  return this->Impl->parts[part];
}

std::size_t EmbreeScene::NumberOfParts() const
{
  return this->Impl->parts.size();
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
