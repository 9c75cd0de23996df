// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/gathering/LinkTracer.h"

#include "PhotonTransport/gathering/GatherWalk.h"
#include "PhotonTransport/geometry/Frame.h"
#include "PhotonTransport/openings/SeenOpenings.h"
#include "PhotonTransport/sampling/Strata.h"
#include "PhotonTransport/sampling/Warps.h"
#include "PhotonTransport/threads/Threads.h"

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{
namespace
{

/// Sides come after vertices among those that draw numbers.
constexpr std::uint64_t FirstSide = std::uint64_t{ 1 } << 34;

} // namespace

/// Keeps what rays find as links. See GatherWalk.
struct LinkTracer::Sink
{
  const SharesOfSides& shares;
  LinkTable& table;
  SidesMet& met;
  std::size_t lamps;            ///< That are kept apart, or 1.
  float share;                  ///< Of a ray.
  float* direct;                ///< [channel][lamp] Of the side and replicate in work.
  std::vector<float> factors{}; ///< [ray] Beyond the share; empty where it is 1.

  float ShareOf(const GatherFlight& flight, int channel) const
  {
    return (this->factors.empty() ? 1.0f : this->factors[flight.ray]) * this->share *
      flight.weight[channel];
  }

  float NearUpTo(std::uint32_t, bool, float) const { return 0.0f; }
  void OnCell(const GatherFlight& flight, std::uint32_t cell, bool front)
  {
    const auto side = static_cast<std::uint32_t>(SideIndex(cell, front));
    if (this->shares.IsBlack(side))
    {
      return;
    }
    this->met.Add(side);
    this->table.links.push_back(side);
    for (int c = 0; c < static_cast<int>(this->table.channels); ++c)
    {
      this->table.weights.push_back(this->ShareOf(flight, c));
    }
  }
  void OnFollowed(const GatherFlight&, std::uint32_t, bool) {}
  void OnCaustics(const GatherFlight&, std::uint32_t, bool) {}
  void OnLamp(const GatherFlight& flight, const Colour& lux, std::uint32_t lamp)
  {
    for (int c = 0; c < static_cast<int>(this->table.channels); ++c)
    {
      this->direct[static_cast<std::size_t>(c) * this->lamps + (this->lamps > 1 ? lamp : 0)] +=
        this->ShareOf(flight, c) * lux[c];
    }
  }
};

/// What one thread works with.
struct LinkTracer::Workspace
{
  explicit Workspace(const GatherScene& scene)
    : walk(scene)
  {
  }
  GatherWalk<Sink> walk;
  std::vector<Ray> rays;
  std::vector<LightThrough> through; ///< [ray]
  Receiver start;
  std::uint32_t facet = 0;
};

LinkTracer::LinkTracer(const GatherScene& scene, const SharesOfSides& shares,
  const CellExitance& exitance, std::size_t most, SidesMet& met)
  : Gathered(scene)
  , Shares(shares)
  , Replicates(exitance.Replicates())
  , Lamps(std::max<std::size_t>(1, exitance.lamps))
  , Channels(exitance.channels)
  , Met(met)
  , Strata(std::min(most, StrataFor(scene.cells.Number(), exitance.Replicates())))
{
}

LinkTable LinkTracer::Trace(
  const std::vector<std::uint32_t>& sides, std::size_t first, std::size_t number) const
{
  constexpr std::size_t InChunk = 32;
  std::vector<LinkTable> chunks((number + InChunk - 1) / InChunk);
  ForEach(
    chunks.size(),
    [&](std::size_t chunk)
    {
      Workspace work(this->Gathered);
      chunks[chunk] = this->Empty();
      for (std::size_t i = chunk * InChunk; i < std::min(number, (chunk + 1) * InChunk); ++i)
      {
        this->AddSide(sides[first + i], work, chunks[chunk]);
      }
    },
    1);
  return LinkTable::Of(chunks);
}

std::size_t LinkTracer::StrataFor(std::size_t cells, std::size_t replicates)
{
  constexpr double Rays = 0x1p25;
  return static_cast<std::size_t>(
    std::clamp(std::sqrt(Rays / static_cast<double>(cells * 2 * replicates)), 2.0, 4.0));
}

LinkTable LinkTracer::Empty() const
{
  LinkTable table;
  table.channels = this->Channels;
  table.values = this->Channels * this->Lamps;
  return table;
}

void LinkTracer::AddSide(std::uint32_t side, Workspace& work, LinkTable& table) const
{
  table.sides.push_back(side);
  work.facet = this->Gathered.cells.FacetOf(CellOf(side));
  const glm::vec3& normal = this->Gathered.scene.Facets()[work.facet].normal;
  work.start.normal = IsFront(side) ? normal : -normal;
  for (std::size_t r = 0; r < this->Replicates; ++r)
  {
    table.direct.resize(table.direct.size() + table.values, 0.0f);
    this->AddReplicate(side, r, work, table);
    table.ends.push_back(static_cast<std::uint32_t>(table.links.size()));
  }
}

void LinkTracer::AddReplicate(
  std::uint32_t side, std::size_t replicate, Workspace& work, LinkTable& table) const
{
  const GatherSequence sequence{ ReceiverStream::Links,
    (std::uint64_t{ side } + FirstSide) * this->Replicates + replicate };
  const auto rays = static_cast<std::uint32_t>(this->Strata * this->Strata);
  Sink sink{ this->Shares, table, this->Met, this->Lamps, 1.0f / static_cast<float>(rays),
    &table.direct[table.direct.size() - table.values] };
  work.rays.clear();
  for (std::uint32_t i = 0; i < rays; ++i)
  {
    this->AddRay(side, i, sequence, work, sink);
  }
  work.through.assign(rays, { LightThrough::NoOpening });
  work.walk.Follow(work.rays, work.through, sequence, sink);
  this->AddOpenings(sequence, work, sink);
}

/// A ray, and one sample of the lamps' direct light where it starts.
void LinkTracer::AddRay(std::uint32_t side, std::uint32_t ray, const GatherSequence& sequence,
  Workspace& work, Sink& sink) const
{
  const GatherScene& g = this->Gathered;
  const std::array<std::uint32_t, 4> bits = sequence.Numbers(g.seed, ray, sequence.AtStart);
  const glm::vec2 place = PlaceInStratum(bits, ray, this->Strata);
  const glm::vec3 origin = g.scene.SafeOrigin(work.facet,
    g.cells.PointIn(work.facet, CellOf(side), UnitFloat(bits[2]), UnitFloat(bits[3])),
    IsFront(side));
  const Frame frame(work.start.normal);
  work.rays.push_back({ origin, frame.ToWorld(CosineHemisphere(place.x, place.y)) });
  if (g.lamps.HasOthersThanSkies())
  {
    work.start.starts.assign(1, { origin, work.start.normal });
    work.start.position = origin;
    std::uint32_t lamp = 0;
    const Colour lux = g.lamps.Sample(work.start,
      LampNumber(sequence.Numbers(g.seed, ray, sequence.AtStart, sequence.OfLamps)), lamp);
    sink.OnLamp({ ray }, lux, lamp);
  }
}

/// As many rays to openings, from where the first ray of the replicate starts. Openings are drawn
/// by the solid angles under which they are seen.
void LinkTracer::AddOpenings(const GatherSequence& sequence, Workspace& work, Sink& sink) const
{
  const GatherScene& g = this->Gathered;
  const glm::vec3 origin = work.rays.front().origin;
  const SeenOpenings openings(g.openings, origin);
  if (!(openings.SolidAngle() > 0.0))
  {
    return;
  }
  const GatherSequence own{ ReceiverStream::Openings, FirstSide + sequence.receiver };
  sink.factors.assign(work.rays.size(), 0.0f);
  work.through.assign(work.rays.size(), {});
  for (std::uint32_t i = 0; i < work.rays.size(); ++i)
  {
    const std::array<std::uint32_t, 4> bits = own.Numbers(g.seed, i, own.AtStart);
    const double place = (i + bits[2] * 0x1p-32) / static_cast<double>(work.rays.size());
    const SeenOpenings::Sample sample =
      openings.Draw(place, UnitFloat(bits[0]), UnitFloat(bits[1]));
    sink.factors[i] = sample.FactorOf(work.start.normal);
    work.rays[i] = { origin, sink.factors[i] > 0.0f ? sample.direction : glm::vec3(0.0f) };
    work.through[i] = { sample.opening };
  }
  work.walk.Follow(work.rays, work.through, own, sink);
}

} // namespace PhotonTransport
