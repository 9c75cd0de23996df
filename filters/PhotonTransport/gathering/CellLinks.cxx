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
LinkTable CellLinks::FindLinks(
  const CellExitance& exitance, std::vector<std::uint32_t>& placeOf) const
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
  std::vector<std::uint32_t> next = met.List(isNew);
  // Most sides are among the first. Memory that is not written to costs nothing.
  LinkTable table = tracer.EmptyFor(std::min(placeOf.size(), 2 * next.size()));
  for (; !next.empty(); next = met.List(isNew))
  {
    for (std::size_t i = 0; i < next.size(); ++i)
    {
      placeOf[next[i]] = static_cast<std::uint32_t>(table.sides.size() + i);
      if (this->Shares.Of(next[i]).IsTranslucent())
      {
        met.Add(OtherSide(next[i])); // its light comes through
      }
    }
    tracer.Trace(next, table);
  }
  return table;
}

std::uint64_t CellLinks::MemoryNeed(
  std::size_t cells, std::size_t replicates, std::size_t channels, std::size_t lamps)
{
  const std::size_t values = channels * std::max<std::size_t>(1, lamps);
  const std::size_t strata = LinkTracer::StrataFor(cells, replicates);
  constexpr std::size_t WithOpenings = 2; // as many rays again may go to openings
  constexpr std::size_t Sweeping = 3;     // lists of values while LinkSolver is at work
  const std::uint64_t perSide = LinkTable::BytesPerSide(replicates, values) +
    replicates *
      (WithOpenings * strata * strata * LinkTable::BytesPerLink(channels) +
        Sweeping * values * sizeof(float));
  constexpr std::uint64_t Lists = 3 * sizeof(std::uint32_t) + sizeof(std::uint8_t); // of all sides
  return 2 * std::uint64_t{ cells } * (perSide + Lists);
}

void CellLinks::Solve(CellExitance& exitance) const
{
  std::vector<std::uint32_t> placeOf;
  LinkTable table = this->FindLinks(exitance, placeOf);
  if (exitance.caustic.Of(0))
  {
    AddCaustics(exitance, table);
  }
  for (std::uint32_t& link : table.links)
  {
    link = placeOf[link]; // LinkTracer links no black side, and all others have a place
  }
  std::vector<const DiffuseShares*> shares;
  std::vector<std::uint32_t> others;
  for (const std::uint32_t side : table.sides)
  {
    shares.push_back(&this->Shares.Of(side));
    others.push_back(placeOf[OtherSide(side)]);
  }
  const LinkSolver solver(table, exitance.Replicates(), shares, others);
  const std::vector<float> arriving = solver.Arriving();
  const std::vector<float> leaving = solver.Leaving(arriving);
  for (std::uint32_t side = 0; side < placeOf.size(); ++side)
  {
    exitance.known[side] = placeOf[side] != NoSide || this->Shares.IsBlack(side);
  }
  const std::size_t perSide = exitance.Replicates() * table.values;
  ForEach(table.sides.size(),
    [&](std::size_t k)
    { Store(&leaving[k * perSide], &arriving[k * perSide], table.sides[k], exitance); });
}

} // namespace PhotonTransport
