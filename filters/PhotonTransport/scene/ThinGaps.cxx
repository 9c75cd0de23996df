// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/materials/Scattering.h"
#include "PhotonTransport/scene/CloseFacets.h"
#include "PhotonTransport/scene/Scene.h"
#include "PhotonTransport/threads/Threads.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <vector>

namespace PhotonTransport
{
namespace
{

/// Facets narrower than eight offsets are left out, since only neighbours are near their middle.
constexpr float Narrow = 8.0f;

/// Two facets nearer than this share of an offset, four times the rounding of a coordinate, may be
/// meant to be in one place, unless a solid body lies between them.
constexpr double Rounding = 0.125;

/// How far a look back goes at first, in offsets: not as far as the facet itself, yet far enough to
/// meet all that are not meant to be in its place. Asking whether anything is there takes less than
/// half the time of asking what is.
constexpr float FirstLook = 1.0f - 0x1p-5f;

/// A look back at a facet, from where rays that leave its middle start.
struct Probe
{
  std::uint32_t facet;
  bool front; ///< The side of the facet that is looked at.
  float offset;
};

class Search
{
public:
  explicit Search(const Scene& scene)
    : SearchedScene(scene)
  {
  }

  void LookAt(std::uint32_t facet)
  {
    this->Add(facet, true);
    if (this->LetsLightThrough(facet))
    {
      this->Add(facet, false);
    }
    if (this->Probes.size() + 2 > Together)
    {
      this->Look();
    }
  }

  ThinGaps Result()
  {
    this->Look();
    return this->Found;
  }

private:
  static constexpr std::size_t Together = 64;

  bool LetsLightThrough(std::uint32_t facet) const
  {
    const Scene& scene = this->SearchedScene;
    return (ScatteringsOf(scene.Materials()[scene.MaterialOfFacet()[facet]]) & Transmissions) != 0;
  }

  bool IsSolid(std::uint32_t facet) const
  {
    const Scene& scene = this->SearchedScene;
    return scene.Materials()[scene.MaterialOfFacet()[facet]].solid;
  }

  void Add(std::uint32_t f, bool front)
  {
    const Facet& facet = this->SearchedScene.Facets()[f];
    const glm::vec3 middle(1.0f / 3.0f);
    const glm::vec3 start = this->SearchedScene.SafeOrigin(f, middle, front);
    const float offset = OriginOffset * this->SearchedScene.Reach(start);
    if (facet.MarginPerOffset() * offset > EdgeClearance / Narrow)
    {
      this->NoteIfUnresolved(f, front, offset);
    }
    else
    {
      this->Probes.push_back({ f, front, offset });
      this->Rays.push_back({ start, front ? -facet.normal : facet.normal });
    }
  }

  void NoteIfUnresolved(std::uint32_t f, bool front, float offset)
  {
    const glm::uvec3& ids = this->SearchedScene.Facets()[f].vertices;
    const auto corner = [&](int c) { return this->SearchedScene.Vertices()[ids[c]].position; };
    const float longest = std::max({ glm::length(corner(1) - corner(0)),
      glm::length(corner(2) - corner(1)), glm::length(corner(0) - corner(2)) });
    if (front && longest < Narrow * offset)
    {
      this->Found.firstUnresolved = this->Found.unresolved++ == 0 ? f : this->Found.firstUnresolved;
    }
  }

  /// Leaves out probes that meet nothing before the facet. Solid bodies may have no gap at all, so
  /// theirs stay.
  void LeaveOutClear()
  {
    std::array<Segment, Together> segments;
    std::array<std::uint8_t, Together> occluded;
    for (std::size_t i = 0; i < this->Rays.size(); ++i)
    {
      segments[i] = { this->Rays[i], FirstLook * this->Probes[i].offset };
    }
    this->SearchedScene.FindOccluded(segments.data(), occluded.data(), this->Rays.size(), true);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < this->Rays.size(); ++i)
    {
      if (occluded[i] != 0 || this->IsSolid(this->Probes[i].facet))
      {
        this->Probes[kept] = this->Probes[i];
        this->Rays[kept++] = this->Rays[i];
      }
    }
    this->Probes.resize(kept);
    this->Rays.resize(kept);
  }

  void Look()
  {
    this->LeaveOutClear();
    std::array<Hit, Together> hits;
    this->SearchedScene.Intersect(this->Rays.data(), hits.data(), this->Rays.size());
    for (std::size_t i = 0; i < this->Rays.size(); ++i)
    {
      if (hits[i] && hits[i].facet != this->Probes[i].facet)
      {
        this->Judge(this->Probes[i], this->Rays[i], hits[i]);
      }
    }
    this->Probes.clear();
    this->Rays.clear();
  }

  void Judge(const Probe& probe, const Ray& ray, const Hit& hit)
  {
    const Facet& other = this->SearchedScene.Facets()[hit.facet];
    const bool inFront = probe.front && glm::dot(ray.direction, other.normal) > 0.0f;
    const bool lit = inFront || this->LetsLightThrough(hit.facet) || !probe.front;
    const double gap = double{ probe.offset } - this->WayTo(ray, hit);
    const double least = this->IsSolid(probe.facet) ? 0.0 : this->OnePlace(probe, ray);
    if (!lit || gap < least || this->ShareAPoint(probe.facet, hit.facet))
    {
      return;
    }
    const double unit = 1.0 / this->SearchedScene.GetPlacement().scale;
    if (this->Found.number++ == 0 || gap * unit < this->Found.gap)
    {
      this->Found.facet = probe.facet;
      this->Found.other = hit.facet;
      this->Found.gap = std::max(0.0, gap * unit);
      this->Found.offset = double{ probe.offset } * unit;
    }
  }

  /// How far apart two facets may be that are meant to be in one place.
  double OnePlace(const Probe& probe, const Ray& ray) const
  {
    const double data = 2.0 *
      this->SearchedScene.GetRounding().Along(glm::dvec3(ray.direction), glm::dvec3(ray.origin));
    return std::max(Rounding * double{ probe.offset }, data);
  }

  double WayTo(const Ray& ray, const Hit& hit) const
  {
    const glm::uvec3& ids = this->SearchedScene.Facets()[hit.facet].vertices;
    const auto corner = [&](unsigned id)
    { return glm::dvec3(this->SearchedScene.Vertices()[id].position); };
    const glm::dvec3 a = corner(ids.x);
    const glm::dvec3 end = a + double{ hit.barycentric.y } * (corner(ids.y) - a) +
      double{ hit.barycentric.z } * (corner(ids.z) - a);
    return glm::dot(end - glm::dvec3(ray.origin), glm::dvec3(ray.direction));
  }

  bool ShareAPoint(std::uint32_t one, std::uint32_t other) const
  {
    const auto corner = [&](std::uint32_t facet, int c)
    {
      return this->SearchedScene.Vertices()[this->SearchedScene.Facets()[facet].vertices[c]]
        .position;
    };
    for (int i = 0; i < 9; ++i)
    {
      if (corner(one, i / 3) == corner(other, i % 3))
      {
        return true;
      }
    }
    return false;
  }

  const Scene& SearchedScene;
  std::vector<Probe> Probes;
  std::vector<Ray> Rays;
  ThinGaps Found;
};

/// Adds what was found among facets that come later in the list.
void Add(ThinGaps& found, const ThinGaps& later)
{
  if (later.number > 0 && (found.number == 0 || later.gap < found.gap))
  {
    found.facet = later.facet;
    found.other = later.other;
    found.gap = later.gap;
    found.offset = later.offset;
  }
  found.firstUnresolved = found.unresolved == 0 ? later.firstUnresolved : found.firstUnresolved;
  found.number += later.number;
  found.unresolved += later.unresolved;
}

} // namespace

/// Whether something may lie before the middle of a facet, nearer than rays start there, or whether
/// the facet may be too small for that to be found out.
///
/// A ray that looks back at the middle from an offset away stays in the facet's box of
/// FindCloseFacets: along the larger components of the normal its margins are 36 offsets or more,
/// unless the offset is enlarged next to the origin or between sheets, and along the others the
/// facet itself reaches 9 offsets or more from the middle if a height is 32 offsets. So the boxes
/// of all that the ray may meet meet that of the facet. What lies beyond an edge of the facet, or
/// has the facet beyond an edge of its own, reaches over it by 2 offsets at most (HalfSliver), seen
/// along an axis. The middle is a third of a height from the edges, at least 6 offsets as seen
/// along the axis, and the ray moves by less than one across the axis.
bool Scene::MayHaveGap(std::uint32_t facet, const std::vector<std::uint8_t>& close) const
{
  constexpr float WideEnough = EdgeClearance / 32.0f;
  constexpr float UsualReach = 0x1p-4f;
  return (close[facet] & MayBeBefore) != 0 || this->LeastReach > UsualReach ||
    this->FacetRecords[facet].MarginPerOffset() * OriginOffset > WideEnough;
}

/// @param close What FindCloseFacets says.
void Scene::FindThinGaps(const std::vector<std::uint8_t>& close)
{
  constexpr std::size_t Chunk = 4096;
  const std::size_t facets = this->FacetRecords.size();
  std::vector<ThinGaps> chunks((facets + Chunk - 1) / Chunk);
  ParallelFor(0, chunks.size(),
    [&](std::uint64_t begin, std::uint64_t end)
    {
      for (std::uint64_t c = begin; c < end; ++c)
      {
        Search search(*this);
        const auto last = static_cast<std::uint32_t>(std::min((c + 1) * Chunk, facets));
        for (auto f = static_cast<std::uint32_t>(c * Chunk); f < last; ++f)
        {
          if (this->MayHaveGap(f, close))
          {
            search.LookAt(f);
          }
        }
        chunks[c] = search.Result();
      }
    });
  ThinGaps& all = this->Found.thinGaps;
  for (const ThinGaps& chunk : chunks)
  {
    Add(all, chunk);
  }
  for (std::uint32_t* facet : { &all.facet, &all.other, &all.firstUnresolved })
  {
    *facet = this->InSurface(*facet);
  }
}

} // namespace PhotonTransport
