// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/refinement/Refinement.h"

#include "PhotonTransport/refinement/CurvedPatch.h"
#include "PhotonTransport/threads/Threads.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace PhotonTransport
{
namespace
{

bool Before(const glm::vec3& p, const glm::vec3& q)
{
  return std::tie(p.x, p.y, p.z) < std::tie(q.x, q.y, q.z);
}

/// So many facets are worth a thread: a facet may have a thousand parts.
constexpr std::uint64_t FewFacets = 32;

/// Turns numbers into sums of those before them, plus `first`; the last of them is all.
void SumUp(std::vector<std::uint64_t>& numbers, std::uint64_t first)
{
  numbers.push_back(0);
  std::exclusive_scan(numbers.begin(), numbers.end(), numbers.begin(), first);
}

} // namespace

/// The parts of a facet, and the points inside it that they have, sorted.
struct Refinement::FacetParts
{
  std::vector<FacetTriangle> triangles;
  std::vector<glm::vec3> inside;

  explicit FacetParts(const CurvedPatch& patch)
  {
    patch.Subdivide([this](const FacetTriangle& part) { this->triangles.push_back(part); });
    for (const FacetTriangle& part : this->triangles)
    {
      for (const glm::vec3& p : part)
      {
        if (p.x != 0.0f && p.y != 0.0f && p.z != 0.0f)
        {
          this->inside.push_back(p);
        }
      }
    }
    std::sort(this->inside.begin(), this->inside.end(), Before);
    this->inside.erase(std::unique(this->inside.begin(), this->inside.end()), this->inside.end());
  }

  std::size_t IndexInside(const glm::vec3& p) const
  {
    return static_cast<std::size_t>(
      std::lower_bound(this->inside.begin(), this->inside.end(), p, Before) - this->inside.begin());
  }
};

Refinement::Refinement(const TriangleMesh& mesh)
  : Mesh(mesh)
  , Edges(this->Mesh)
  , Curves(this->Mesh, this->Edges)
  , FirstPart{ mesh.facets.size() }
{
}

Refinement::Refinement(const TriangleMesh& mesh, const RefinementLimits& limits)
  : Refinement(mesh)
{
  this->Divide(limits);
}

void Refinement::Divide(const RefinementLimits& limits)
{
  this->Limits = limits;
  this->Curves.Restore();
  this->Curves.Divide(limits);
  this->StraightenTurned();
  this->Count();
}

std::uint64_t Refinement::FacetsAtMost(const RefinementLimits& limits)
{
  this->Curves.Restore();
  this->Curves.Divide(limits);
  std::uint64_t sum = 0;
  for (std::size_t f = 0; f < this->Mesh.facets.size(); ++f)
  {
    int halvings = 0;
    for (std::size_t side = 0; side < 3; ++side)
    {
      halvings = std::max(halvings, this->Curves[this->Edges.EdgeOf(f, side)].halvings);
    }
    sum += std::uint64_t{ 1 } << (2 * halvings);
  }
  return sum;
}

const RefinementLimits& Refinement::Fit(std::uint64_t most)
{
  while (this->NumberOfFacets() > most && !this->IsTrivial())
  {
    // Halves of an edge have half its length and turn and a quarter of its sagitta.
    constexpr double Wider = 1.189207115; // 2^(1/4), so that facets decrease by about a third
    this->Limits.length *= Wider;
    this->Limits.turn *= Wider;
    this->Limits.sagitta *= Wider * Wider;
    this->Curves.Divide(this->Limits);
    this->Count();
  }
  return this->Limits;
}

CurvedPatch Refinement::PatchOf(std::size_t facet) const
{
  return { this->Mesh, this->Edges, this->Curves, this->Limits, facet };
}

/// A noisy normal may bend a patch so far that a part of it turns its back. The edges of such a
/// facet become straight, for their other facets too, of which one may turn because of it.
void Refinement::StraightenTurned()
{
  std::vector<std::uint32_t> facets(this->Mesh.facets.size());
  std::iota(facets.begin(), facets.end(), 0u);
  while (!facets.empty())
  {
    std::vector<std::uint8_t> turns(facets.size());
    ForEach(
      facets.size(), [&](std::size_t i) { turns[i] = this->PatchOf(facets[i]).Turns(); },
      FewFacets);
    std::vector<std::uint32_t> beside;
    for (std::size_t i = 0; i < facets.size(); ++i)
    {
      for (std::size_t side = 0; turns[i] && side < 3; ++side)
      {
        const std::uint32_t edge = this->Edges.EdgeOf(facets[i], side);
        this->Curves.Straighten(edge, this->Limits);
        this->Edges.ForEachSide(
          edge, [&](const FacetEdge& other) { beside.push_back(other.facet); });
      }
    }
    std::sort(beside.begin(), beside.end());
    beside.erase(std::unique(beside.begin(), beside.end()), beside.end());
    facets = std::move(beside);
  }
}

void Refinement::Count()
{
  const std::size_t facets = this->Mesh.facets.size();
  this->FirstPart.assign(facets, 1);
  this->FirstInside.assign(facets, 0);
  ForEach(
    facets,
    [&](std::size_t f)
    {
      const CurvedPatch patch = this->PatchOf(f);
      if (!patch.IsWhole())
      {
        const FacetParts parts(patch);
        this->FirstPart[f] = parts.triangles.size();
        this->FirstInside[f] = parts.inside.size();
      }
    },
    FewFacets);
  this->FirstOnPair.clear();
  for (const PointPair& pair : this->Edges.Pairs())
  {
    this->FirstOnPair.push_back((1u << this->Curves[pair.edge].halvings) - 1u);
  }
  SumUp(this->FirstPart, 0);
  SumUp(this->FirstOnPair, this->Mesh.points.size());
  SumUp(this->FirstInside, this->FirstOnPair.back());
}

/// The number of a point of a facet. @param parts Of the facet.
std::uint32_t Refinement::PointAt(
  std::size_t facet, const glm::vec3& barycentric, const FacetParts& parts) const
{
  for (int corner = 0; corner < 3; ++corner)
  {
    if (barycentric[corner] == 1.0f)
    {
      return this->Mesh.facets[facet][corner];
    }
  }
  for (std::size_t side = 0; side < 3; ++side)
  {
    if (barycentric[static_cast<int>(side)] == 0.0f)
    {
      const std::uint32_t number = this->Edges.PairOf(facet, side);
      const PointPair& pair = this->Edges.Pairs()[number];
      const auto next = static_cast<int>((side + 1) % 3), last = static_cast<int>((side + 2) % 3);
      const float along = barycentric[pair.to == this->Mesh.facets[facet][next] ? next : last];
      const float place = std::ldexp(along, this->Curves[pair.edge].halvings);
      return static_cast<std::uint32_t>(
        this->FirstOnPair[number] + static_cast<std::uint64_t>(place) - 1);
    }
  }
  return static_cast<std::uint32_t>(this->FirstInside[facet] + parts.IndexInside(barycentric));
}

RefinedMesh Refinement::Make() const
{
  RefinedMesh fine;
  fine.points = this->Mesh.points;
  fine.points.resize(this->NumberOfPoints());
  fine.facets.resize(this->NumberOfFacets());
  fine.origins.resize(this->NumberOfFacets());
  ForEach(this->Edges.Pairs().size(), [&](std::size_t pair) { this->AddPointsOn(pair, fine); });
  ForEach(
    this->Mesh.facets.size(), [&](std::size_t facet) { this->AddParts(facet, fine); }, FewFacets);
  return fine;
}

void Refinement::AddPointsOn(std::size_t number, RefinedMesh& fine) const
{
  const PointPair& pair = this->Edges.Pairs()[number];
  const int halvings = this->Curves[pair.edge].halvings;
  for (int i = 1; i < 1 << halvings; ++i)
  {
    fine.points[this->FirstOnPair[number] + static_cast<std::size_t>(i - 1)] =
      PointOnCurve(this->Mesh.points[pair.from], this->Mesh.points[pair.to],
        this->Curves[pair.edge].offset, std::ldexp(1.0, -halvings) * i);
  }
}

void Refinement::AddParts(std::size_t facet, RefinedMesh& fine) const
{
  const CurvedPatch patch = this->PatchOf(facet);
  const FacetParts parts(patch);
  for (std::size_t i = 0; i < parts.triangles.size(); ++i)
  {
    const FacetTriangle& part = parts.triangles[i];
    const std::size_t number = this->FirstPart[facet] + i;
    fine.origins[number] = { static_cast<std::uint32_t>(facet), part };
    for (int corner = 0; corner < 3; ++corner)
    {
      fine.facets[number][corner] =
        this->PointAt(facet, part[static_cast<std::size_t>(corner)], parts);
    }
  }
  for (std::size_t i = 0; i < parts.inside.size(); ++i)
  {
    fine.points[this->FirstInside[facet] + i] = patch.At(parts.inside[i]);
  }
}

} // namespace PhotonTransport
