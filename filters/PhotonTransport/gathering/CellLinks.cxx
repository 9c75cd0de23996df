// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/gathering/CellLinks.h"

#include "PhotonTransport/gathering/CellSides.h"
#include "PhotonTransport/gathering/GatherWalk.h"
#include "PhotonTransport/gathering/LinkSolver.h"
#include "PhotonTransport/gathering/LinkTracer.h"
#include "PhotonTransport/geometry/Frame.h"
#include "PhotonTransport/sampling/Strata.h"
#include "PhotonTransport/sampling/Warps.h"
#include "PhotonTransport/threads/Threads.h"

#include <algorithm>

namespace PhotonTransport
{
namespace
{

/// Bytes of lists of all sides while links are found: which rays have met, their places in the
/// table, and those to be traced next.
constexpr std::uint64_t BytesOfAnySide = sizeof(std::uint8_t) + 2 * sizeof(std::uint32_t);
/// Bytes of lists of the sides of the table, which grow.
constexpr std::uint64_t BytesOfSolvedSide = 2 * (sizeof(void*) + sizeof(std::uint32_t));

/// Notes which sides rays meet. See GatherWalk.
struct MeetingSink
{
  SidesMet& met;
  float NearUpTo(std::uint32_t, bool, float) const { return 0.0f; }
  void OnCell(const GatherFlight&, std::uint32_t cell, bool front)
  {
    this->met.Add(SideIndex(cell, front));
  }
  void OnFollowed(const GatherFlight&, std::uint32_t, bool) {}
  void OnCaustics(const GatherFlight&, std::uint32_t, bool) {}
  void OnLamp(const GatherFlight&, const Colour&, std::uint32_t) {}
};

/// Adds to the direct light of each side the caustics that photons have brought there.
void AddCaustics(const CellExitance& exitance, LinkTable& table)
{
  const std::size_t lamps = std::max<std::size_t>(1, exitance.lamps);
  float* direct = table.direct.data();
  for (const std::uint32_t side : table.sides)
  {
    const float* caustic = exitance.caustic.Of(side);
    const float* byLamp = exitance.causticByLamp.Of(side);
    for (std::size_t r = 0; r < exitance.Replicates(); ++r)
    {
      for (std::size_t i = 0; i < exitance.channels * lamps; ++i, ++direct)
      {
        *direct += byLamp ? byLamp[i] : caustic[r * exitance.channels + i];
      }
    }
  }
}

/// Gives links the places of their sides in the tables, and adds caustics to the direct light.
void Join(std::vector<LinkTable>& tables, const std::vector<std::uint32_t>& placeOf,
  const CellExitance& exitance)
{
  for (LinkTable& table : tables)
  {
    if (exitance.caustic.Of(0))
    {
      AddCaustics(exitance, table);
    }
    for (std::uint32_t& link : table.links)
    {
      link = placeOf[link]; // LinkTracer links no black side, and all others have a place
    }
  }
}

/// Replaces what is known of a side. @param leaving, arriving [replicate][channel][lamp]
void Store(const float* leaving, const float* arriving, std::uint32_t side, CellExitance& exitance)
{
  const std::size_t lamps = std::max<std::size_t>(1, exitance.lamps);
  float* out = exitance.leaving.Of(side);
  float* byLamp = exitance.leavingByLamp.Of(side);
  std::fill(out, out + exitance.Replicates() * exitance.channels, 0.0f);
  if (byLamp)
  {
    std::fill(byLamp, byLamp + exitance.channels * lamps, 0.0f);
  }
  double mean = 0.0;
  for (std::size_t r = 0; r < exitance.Replicates(); ++r)
  {
    for (std::size_t i = 0; i < exitance.channels * lamps; ++i, ++leaving, ++arriving)
    {
      out[r * exitance.channels + i / lamps] += *leaving;
      mean += exitance.shareOf[r] * *arriving;
      if (byLamp)
      {
        byLamp[i] += static_cast<float>(exitance.shareOf[r] * *leaving);
      }
    }
  }
  exitance.illuminance[side] = static_cast<float>(mean);
}

} // namespace

CellLinks::CellLinks(const GatherScene& scene, const Viewers& viewers, const Effects& effects,
  std::uint32_t gatherRays)
  : Gathered(scene)
  , Shares(scene.scene, scene.cells, effects)
  , Strata(gatherRays < 576 ? 2
        : gatherRays < 1024 ? 3
                            : 4)
{
  SidesMet met(scene.cells.Number());
  constexpr std::uint64_t Grain = 64;
  ParallelFor(
    0, viewers.number,
    [&](std::uint64_t begin, std::uint64_t end)
    {
      GatherWalk<MeetingSink> walk(scene);
      MeetingSink sink{ met };
      Receiver receiver;
      std::vector<Ray> rays;
      for (std::uint64_t i = begin; i < end; ++i)
      {
        const GatherSequence sequence{ ReceiverStream::Links, i };
        viewers.make(i, receiver);
        this->AddRays(receiver, sequence, rays);
        walk.Follow(rays, std::vector<LightThrough>(rays.size()), sequence, sink);
      }
    },
    Grain);
  this->Seen = met.List([&](std::uint32_t side) { return !this->Shares.IsBlack(side); });
}

/// A few rays, spread over all directions.
void CellLinks::AddRays(
  const Receiver& receiver, const GatherSequence& sequence, std::vector<Ray>& rays) const
{
  constexpr std::size_t Side = 4;
  const bool all = receiver.IsInFreeSpace();
  const Frame frame(all ? glm::vec3(0.0f, 0.0f, 1.0f) : receiver.normal);
  rays.clear();
  for (std::uint32_t i = 0; i < Side * Side && !receiver.starts.empty(); ++i)
  {
    const glm::vec2 place =
      PlaceInStratum(sequence.Numbers(this->Gathered.seed, i, sequence.AtStart), i, Side);
    const glm::vec3 direction =
      frame.ToWorld(all ? UniformSphere(place.x, place.y) : CosineHemisphere(place.x, place.y));
    if (const glm::vec3* start = receiver.StartTowards(direction))
    {
      rays.push_back({ *start, direction });
    }
  }
}

bool CellLinks::PhotonsAreFew(const PhotonCounts& counts) const
{
  constexpr double Few = 4.0;        // on a side
  constexpr double ManySides = 0.25; // of all
  const auto number = std::count_if(this->Seen.begin(), this->Seen.end(),
    [&](std::uint32_t side) { return counts.CountOn(CellOf(side), IsFront(side)) < Few; });
  return static_cast<double>(number) > ManySides * static_cast<double>(this->Seen.size());
}

/// All sides that count for what receivers see, with their links to each other.
std::vector<LinkTable> CellLinks::FindLinks(
  const CellExitance& exitance, std::vector<std::uint32_t>& placeOf, const Watch& watch) const
{
  SidesMet met(this->Gathered.cells.Number());
  for (const std::uint32_t side : this->Seen)
  {
    met.Add(side);
  }
  placeOf.assign(this->Gathered.cells.Number() * 2, NoSide);
  const LinkTracer tracer(this->Gathered, this->Shares, exitance, this->Strata, met);
  const auto isNew = [&](std::uint32_t side)
  { return placeOf[side] == NoSide && !this->Shares.IsBlack(side); };
  std::vector<LinkTable> tables;
  std::uint32_t place = 0;
  std::uint64_t bytes = placeOf.size() * BytesOfAnySide;
  for (std::vector<std::uint32_t> next = met.List(isNew); !next.empty(); next = met.List(isNew))
  {
    for (const std::uint32_t side : next)
    {
      placeOf[side] = place++;
      if (this->Shares.Of(side).IsTranslucent())
      {
        met.Add(OtherSide(side)); // its light comes through
      }
    }
    for (std::size_t first = 0; first < next.size(); first += LinkTracer::SidesOfSlice)
    {
      const std::size_t number = std::min(next.size() - first, LinkTracer::SidesOfSlice);
      tables.push_back(tracer.Trace(next, first, number));
      bytes += tables.back().Bytes();
      watch(bytes + tables.back().Bytes()); // a slice is there twice for a while
    }
  }
  return tables;
}

void CellLinks::Solve(CellExitance& exitance, const Watch& watch) const
{
  std::vector<std::uint32_t> placeOf;
  std::vector<LinkTable> tables = this->FindLinks(exitance, placeOf, watch);
  Join(tables, placeOf, exitance);
  std::vector<const DiffuseShares*> shares;
  std::vector<std::uint32_t> others;
  std::uint64_t largest = 0; // of slices, which were there twice: the heap may keep the other one
  std::uint64_t bytes = placeOf.size() * BytesOfAnySide;
  for (const LinkTable& table : tables)
  {
    for (const std::uint32_t side : table.sides)
    {
      shares.push_back(&this->Shares.Of(side));
      others.push_back(placeOf[OtherSide(side)]);
    }
    bytes += table.Bytes() + table.sides.size() * BytesOfSolvedSide +
      table.sides.size() * LinkSolver::BytesPerSide(exitance.Replicates(), table.values);
    largest = std::max(largest, table.Bytes());
  }
  watch(bytes + largest);
  const LinkSolver solver(tables, exitance.Replicates(), shares, others);
  const std::vector<float> arriving = solver.Arriving();
  const std::vector<float> leaving = solver.Leaving(arriving);
  for (std::uint32_t side = 0; side < placeOf.size(); ++side)
  {
    exitance.known[side] = placeOf[side] != NoSide || this->Shares.IsBlack(side);
  }
  const std::size_t perSide =
    shares.empty() ? 0 : arriving.size() / shares.size(); // [replicate][channel][lamp]
  for (const LinkTable& table : tables)
  {
    ForEach(table.sides.size(),
      [&](std::size_t k)
      {
        const std::size_t place = placeOf[table.sides[k]] * perSide;
        Store(&leaving[place], &arriving[place], table.sides[k], exitance);
      });
  }
}

} // namespace PhotonTransport
