// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/GatherFlight.h"
#include "PhotonTransport/gathering/GatherScene.h"
#include "PhotonTransport/gathering/GatherSequence.h"
#include "PhotonTransport/gathering/NearGuide.h"
#include "PhotonTransport/gathering/Receiver.h"
#include "PhotonTransport/geometry/Pi.h"
#include "PhotonTransport/materials/BackwardScattering.h"
#include "PhotonTransport/openings/SeenOpenings.h"
#include "PhotonTransport/scene/HitPoint.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

namespace PhotonTransport
{

/// Follows rays from a receiver to the diffuse facets from which it receives light.
///
/// A ray reads the exitance of the cell that it meets. What the facet mirrors or lets through
/// clearly is followed further by roulette. A cell near by is no fine enough picture of the light
/// there: the ray is then followed wholly, with one sample of the lamps' direct light. Whether a
/// cell is near is drawn at random, so that no seam shows (PhotonGI's indirect usage threshold). Of
/// the lamps, rays bring only the skies' light, which is not drawn at receivers.
///
/// @tparam Sink Gets what rays find:
///  - NearUpTo(cell, front, length): the distance within which a cell of that length may be near
///  - OnCell(flight, cell, front): the diffuse exitance of a side of a cell
///  - OnLamp(flight, lux, lamp): light that a lamp sends where the ray ends
///  - OnFollowed(flight, cell, front): a side close to the receiver from which the ray is followed
///  - OnCaustics(flight, cell, front): the caustics on a side of a cell
template <class Sink>
class GatherWalk
{
public:
  explicit GatherWalk(const GatherScene& scene)
    : Gathered(scene)
  {
  }

  /// @param rays At most 2^16. Those without a direction are left out. @param through [ray]
  /// @param onwards By which rays go on from facets close to the receiver; by the cosine if null.
  void Follow(const std::vector<Ray>& rays, const std::vector<LightThrough>& through,
    const GatherSequence& sequence, Sink& sink, NearGuide* onwards = nullptr)
  {
    this->Onwards = onwards;
    this->Start(rays, through);
    while (!this->Rays.empty())
    {
      this->Hits.resize(this->Rays.size());
      this->Gathered.scene.Intersect(this->Rays.data(), this->Hits.data(), this->Rays.size());
      for (const Hit& hit : this->Hits)
      {
        this->Gathered.scene.PrefetchFacet(hit);
      }
      this->MeetAll(sequence, sink);
      this->Flights.insert(this->Flights.end(), this->Branches.begin(), this->Branches.end());
      this->Rays.insert(this->Rays.end(), this->BranchRays.begin(), this->BranchRays.end());
      this->Branches.clear();
      this->BranchRays.clear();
    }
  }

private:
  void Start(const std::vector<Ray>& rays, const std::vector<LightThrough>& through)
  {
    this->Flights.clear();
    this->Rays.clear();
    for (std::uint32_t i = 0; i < rays.size(); ++i)
    {
      if (rays[i].direction != glm::vec3(0.0f))
      {
        this->Flights.push_back({ i });
        if (!this->Gathered.openings.IsEmpty())
        {
          this->Flights.back().through = through[i];
        }
        this->Rays.push_back(rays[i]);
      }
    }
  }

  /// Keeps those that go on.
  void MeetAll(const GatherSequence& sequence, Sink& sink)
  {
    std::size_t onTheWay = 0;
    for (std::size_t i = 0; i < this->Rays.size(); ++i)
    {
      if (this->Meet(this->Flights[i], this->Rays[i], this->Hits[i], sequence, sink))
      {
        this->Flights[onTheWay] = this->Flights[i];
        this->Rays[onTheWay++] = this->Rays[i];
      }
    }
    this->Flights.resize(onTheWay);
    this->Rays.resize(onTheWay);
  }

  /// Where a ray has met a facet.
  struct Meeting
  {
    Hit hit;
    std::uint32_t cell;
    bool front;
    bool counts; ///< Whether the light of this facet is wanted; else it is on the way there.
    bool near;   ///< The ray is followed wholly, in place of reading the cell.
    bool close;  ///< The facet is close to the receiver.
  };

  /// The side that a ray meets, as photons find it, so that it reads the cell on which they were
  /// counted. @param hit Moved to another facet where that one lies in the same place and counts.
  bool MeetsFront(const Ray& ray, Hit& hit)
  {
    const Scene& scene = this->Gathered.scene;
    const bool front = glm::dot(ray.direction, scene.Facets()[hit.facet].normal) < 0.0f ||
      scene.PreferFront(ray, hit);
    if (scene.MaySharePlace(hit))
    {
      scene.FindSharers(hit, this->Sharers);
    }
    return front;
  }

  /// @return Whether the ray goes on.
  bool Meet(GatherFlight& flight, Ray& ray, Hit& hit, const GatherSequence& sequence, Sink& sink)
  {
    const GatherScene& g = this->Gathered;
    const float distance = DistanceTo(g.scene, ray, hit);
    if (flight.through.opening != LightThrough::Anywhere &&
      !this->LooksThrough(flight, ray, distance))
    {
      return false;
    }
    if (!hit)
    {
      this->Escape(flight, ray, sink);
      return false;
    }
    const bool front = this->MeetsFront(ray, hit);
    const bool counts = !flight.through.IsOpening();
    Meeting at{ hit, g.cells.At(hit.facet, hit.barycentric), front, counts, false, false };
    const Roulette& material = g.materials.roulettes[g.materials.ofFacet[hit.facet]];
    const float nearUpTo = sink.NearUpTo(at.cell, front, g.cells.Length(hit.facet));
    const bool ends = (distance >= nearUpTo || !counts) && ScattersOnlyDiffusely(material);
    std::array<std::uint32_t, 4> bits{};
    if (!ends)
    {
      bits = sequence.Numbers(
        g.seed, flight.ray, flight.order, flight.branched ? sequence.OfBranch : 0u);
      at.near = counts && distance < (1.0f - UnitFloat(bits[3])) * nearUpTo &&
        flight.order + 1 < g.maximumPathLength;
      at.close = at.near && flight.close && distance < NearCells * g.cells.Length(hit.facet);
    }
    if (at.close && !flight.expected)
    {
      sink.OnFollowed(flight, at.cell, front);
      flight.expected = true;
    }
    if (!at.near && counts)
    {
      sink.OnCell(flight, at.cell, front);
    }
    return !ends && this->GoOn(flight, ray, at, material, bits, sequence, sink);
  }

  /// Draws in which way a ray goes on: diffusely only from a facet near by, whose exitance has not
  /// been read.
  /// @return Whether it does.
  bool GoOn(GatherFlight& flight, Ray& ray, const Meeting& at, const Roulette& material,
    const std::array<std::uint32_t, 4>& bits, const GatherSequence& sequence, Sink& sink)
  {
    const GatherScene& g = this->Gathered;
    const glm::vec3& facetNormal = g.scene.Facets()[at.hit.facet].normal;
    const glm::vec3 normal = at.front ? facetNormal : -facetNormal;
    const ScatteringSample sample{ bits[0], UnitFloat(bits[1]), UnitFloat(bits[2]) };
    const FollowedRay next = FollowBack(material, sample, ray.direction, normal, at.front);
    const bool diffuse = IsDiffuse(next.how);
    if (!next.goesOn || (g.switchedOn & SetOf(next.how)) == 0 || (diffuse && !at.near) ||
      ++flight.order >= g.maximumPathLength || (!at.counts && !next.undeflected))
    {
      return false;
    }
    flight.weight *= next.weight;
    flight.direct = flight.direct && next.undeflected;
    flight.undeflected = diffuse || (flight.undeflected && next.undeflected);
    flight.through = flight.undeflected ? flight.through : LightThrough();
    flight.close = flight.close && diffuse;
    const bool leavesFront = at.front == next.sameSide;
    ray = { g.scene.SafeOrigin(at.hit, leavesFront), next.direction };
    if (diffuse)
    {
      this->Near.normal = next.sameSide ? normal : -normal;
      this->Near.starts.assign(1, { ray.origin, this->Near.normal });
      this->Near.position = ray.origin;
      this->ReceiveNear(flight, ray, sequence, sink);
      sink.OnCaustics(flight, at.cell, leavesFront);
      if (at.close && this->Onwards)
      {
        const NearGuide::Way way = this->Onwards->At(this->Near.normal, sample.u, sample.v);
        ray.direction = way.direction;
        flight.weight *= way.weight;
        return way.weight > 0.0f;
      }
    }
    return true;
  }

  /// Whether a segment that comes straight from the receiver may bring the light that is wanted.
  /// @param distance To its end.
  bool LooksThrough(GatherFlight& flight, const Ray& ray, float distance) const
  {
    const bool inwards = false; // light comes against the ray
    const std::optional<OpeningCrossing> crossing =
      this->Gathered.openings.FirstCrossing(ray, inwards, distance);
    if (!crossing)
    {
      // It may go on through a pane, and cross an opening behind it.
      return !flight.through.IsOpening() || std::isfinite(distance);
    }
    const bool wanted = crossing->opening == flight.through.opening;
    flight.through = LightThrough();
    return wanted;
  }

  /// Light from the sky is direct light of the last place that received it: where mirrors, gloss or
  /// glass have sent it there it is a caustic, which photons have brought.
  void Escape(const GatherFlight& flight, const Ray& ray, Sink& sink)
  {
    if (flight.undeflected && this->Gathered.lamps.HasSky())
    {
      // Directions are distributed as the cosine over pi.
      this->Gathered.lamps.SkyRadiance(ray.direction,
        [&](std::uint32_t lamp, const Colour& radiance)
        { sink.OnLamp(flight, static_cast<float>(Pi) * radiance, lamp); });
    }
  }

  /// What a diffuse facet near by receives straight from the lamps and through openings. The ray
  /// itself brings the rest.
  void ReceiveNear(GatherFlight& flight, const Ray& ray, const GatherSequence& sequence, Sink& sink)
  {
    const std::array<std::uint32_t, 4> bits =
      sequence.Numbers(this->Gathered.seed, flight.ray, flight.order, sequence.OfLamps);
    std::uint32_t lamp = 0;
    const Colour lux = this->Gathered.lamps.Sample(this->Near, LampNumber(bits), lamp);
    sink.OnLamp(flight, lux, lamp);
    if (!this->Gathered.openings.IsEmpty())
    {
      this->BranchOff(flight, ray.origin, bits);
      flight.through = { LightThrough::NoOpening };
    }
  }

  /// Sends one more ray to one of the openings, drawn by the solid angles under which they are
  /// seen.
  void BranchOff(
    const GatherFlight& flight, const glm::vec3& origin, const std::array<std::uint32_t, 4>& bits)
  {
    const SeenOpenings openings(this->Gathered.openings, origin);
    if (!(openings.SolidAngle() > 0.0))
    {
      return;
    }
    const SeenOpenings::Sample sample =
      openings.Draw(bits[1] * 0x1p-32, UnitFloat(bits[2]), UnitFloat(bits[3]));
    const float factor = sample.FactorOf(this->Near.normal);
    if (factor > 0.0f)
    {
      this->Branches.push_back(flight);
      this->Branches.back().branched = true;
      this->Branches.back().through = { sample.opening };
      this->Branches.back().weight *= factor;
      this->BranchRays.push_back({ origin, sample.direction });
    }
  }

  GatherScene Gathered;
  std::vector<GatherFlight> Flights;
  std::vector<Ray> Rays;
  std::vector<Hit> Hits;
  std::vector<GatherFlight> Branches; ///< That have just left.
  std::vector<Ray> BranchRays;
  std::vector<Sharer> Sharers;
  Receiver Near;
  NearGuide* Onwards = nullptr;
};

} // namespace PhotonTransport
