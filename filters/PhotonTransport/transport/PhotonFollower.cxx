// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/PhotonFollower.h"

#include "PhotonTransport/threads/Threads.h"
#include "PhotonTransport/transport/Walk.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace PhotonTransport
{

/// Collects the hits of a block.
class HitCollector
{
public:
  /// @param first Of the block. @param most Hits that are kept of the block.
  HitCollector(std::uint64_t first, std::uint64_t most, bool escapes)
    : First(first)
    , End(first + PhotonBlock)
    , Most(most)
    , Escapes(escapes)
  {
  }

  void Add(const PhotonHit& hit)
  {
    if (hit.photon < this->End && (this->Escapes || !hit.HasEscaped()))
    {
      this->Kept.push_back(hit);
      if (this->Kept.size() > this->Most)
      {
        this->DropLastPhotons();
      }
    }
  }

  /// The hits in the order of photons and along each path. Photons from Complete() on are not in
  /// it, since the block has more than the most hits.
  std::vector<PhotonHit> Hits()
  {
    std::sort(this->Kept.begin(), this->Kept.end(),
      [](const PhotonHit& a, const PhotonHit& b)
      { return std::pair(a.photon, a.scatterings) < std::pair(b.photon, b.scatterings); });
    return std::move(this->Kept);
  }
  std::uint64_t Complete() const { return this->End; }

private:
  /// Ends before the photon with which the most is exceeded. Later hits can only move that forward.
  void DropLastPhotons()
  {
    std::vector<std::uint64_t> counts(PhotonBlock, 0);
    for (const PhotonHit& hit : this->Kept)
    {
      ++counts[hit.photon - this->First];
    }
    std::uint64_t room = this->Most;
    this->End = this->First;
    while (counts[this->End - this->First] <= room)
    {
      room -= counts[this->End - this->First];
      ++this->End;
    }
    this->Kept.erase(std::remove_if(this->Kept.begin(), this->Kept.end(),
                       [&](const PhotonHit& hit) { return hit.photon >= this->End; }),
      this->Kept.end());
  }

  std::uint64_t First;
  std::uint64_t End;
  std::uint64_t Most;
  bool Escapes;
  std::vector<PhotonHit> Kept;
};

namespace
{

/// Takes the place of a registrar in a walk: keeps hits and registers nothing.
struct HitKeeper
{
  HitCollector& collector;

  void operator()(const Ray&, const Hit&, bool, const PhotonOrigin&, unsigned = AllCorners) const {}
  void Finish() const {}
  void Arrived(const Hit&, bool, const PhotonOrigin&) const {}
  void Prefetch(const Hit&) const {}
  void Keep(const PhotonHit& hit) const { this->collector.Add(hit); }
};

/// One block of one replicate.
struct BlockOfReplicate
{
  std::uint32_t replicate;
  std::uint64_t block;
};

/// Blocks in turn from each replicate that has so many.
class BlocksInTurn
{
public:
  explicit BlocksInTurn(const std::vector<std::uint64_t>& blocks)
    : Blocks(blocks)
    , Last(*std::max_element(blocks.begin(), blocks.end()))
  {
  }

  /// Fewer than `count` at the end.
  std::vector<BlockOfReplicate> Next(std::size_t count)
  {
    std::vector<BlockOfReplicate> next;
    while (next.size() < count && this->At.block < this->Last)
    {
      if (this->At.block < this->Blocks[this->At.replicate])
      {
        next.push_back(this->At);
      }
      if (++this->At.replicate == this->Blocks.size())
      {
        this->At = { 0, this->At.block + 1 };
      }
    }
    return next;
  }

private:
  const std::vector<std::uint64_t>& Blocks;
  std::uint64_t Last;
  BlockOfReplicate At{ 0, 0 };
};

/// The hits of one block.
struct BlockHits
{
  std::vector<PhotonHit> hits;
  std::uint64_t photons = 0; ///< That all hits are known of.
};

/// Adds the photons of a block while there is room. @return Whether all were added.
bool Append(const BlockHits& block, std::uint64_t first, std::uint64_t most, StoredPhotons& stored)
{
  std::uint64_t photons = block.photons;
  auto end = block.hits.end();
  const std::uint64_t room = most - stored.hits.size();
  if (block.hits.size() > room)
  {
    const std::uint64_t without = block.hits[room].photon; // has no room for all of its hits
    photons = without - first;
    end = std::find_if(block.hits.begin(), block.hits.end(),
      [&](const PhotonHit& hit) { return hit.photon >= without; });
  }
  stored.hits.insert(stored.hits.end(), block.hits.begin(), end);
  stored.photons += photons;
  return photons == PhotonBlock;
}

} // namespace

PhotonFollower::PhotonFollower(
  const Scene& scene, const PhotonTracer& tracer, const TraceSettings& settings)
  : LitScene(scene)
  , Source(tracer.Source())
  , Openings(tracer.OpeningsInUse())
  , Settings(settings)
  , Simulated(tracer.EffectsInUse().simulated)
  , Materials(MakeRoulettes(
      scene.Materials(), scene.MaterialOfFacet(), tracer.EffectsInUse().colouredFacets))
{
}

SequenceKey PhotonFollower::Key(std::uint32_t replicate) const
{
  return { this->Settings.seed, replicate, this->Settings.sampling };
}

void PhotonFollower::Follow(
  std::uint32_t replicate, std::uint64_t first, std::uint64_t last, HitCollector& collector) const
{
  // The walk with every effect, which all photons take with the same bits.
  const WalkSettings walk{ this->LitScene, this->Materials, this->Source, this->Key(replicate),
    this->Settings.maximumPathLength, this->Simulated, nullptr, this->Openings };
  std::vector<PhotonBalance> balances(this->Source.Sources());
  std::vector<Arrivals> arrivals(this->Source.Sources());
  WalkPhotons<Walk::General>(
    walk, first, last, HitKeeper{ collector }, balances.data(), arrivals.data());
}

StoredPhotons PhotonFollower::Hits(const std::vector<std::uint64_t>& blocks, std::uint64_t most,
  const std::function<bool(std::uint64_t hits)>& goOn) const
{
  constexpr std::size_t BlocksOfThread = 4;
  StoredPhotons stored;
  Threads threads(this->Settings.threads);
  BlocksInTurn all(blocks);
  const std::size_t together =
    BlocksOfThread * static_cast<std::size_t>(ThreadCount(this->Settings.threads));
  bool hasRoom = true;
  while (hasRoom && goOn(stored.hits.size()))
  {
    const std::vector<BlockOfReplicate> next = all.Next(together);
    std::vector<BlockHits> found(next.size());
    threads.Run(
      [&]
      {
        ForEach(
          next.size(),
          [&](std::size_t i)
          {
            const std::uint64_t first = next[i].block * PhotonBlock;
            HitCollector collector(first, most - stored.hits.size(), false);
            this->Follow(next[i].replicate, first, first + PhotonBlock, collector);
            found[i].photons = collector.Complete() - first;
            found[i].hits = collector.Hits();
          },
          1);
      });
    hasRoom = !next.empty();
    for (std::size_t i = 0; hasRoom && i < next.size(); ++i)
    {
      hasRoom = Append(found[i], next[i].block * PhotonBlock, most, stored);
    }
  }
  return stored;
}

Ray PhotonFollower::StartOf(std::uint64_t photon) const
{
  const Emission emission = this->Source.Emit(PhotonSequence(this->Key(0), photon));
  const bool isWayOut = this->Source.PartOf(emission.source) != LightPart::Whole;
  return { emission.ray.origin, isWayOut ? -emission.ray.direction : emission.ray.direction };
}

std::vector<PhotonPath> PhotonFollower::Paths(std::uint64_t photons, std::uint64_t blocks) const
{
  std::vector<PhotonPath> paths;
  for (std::uint64_t block = 0; block < blocks && paths.size() < photons; ++block)
  {
    // All of the block, as in the run: what Embree finds may depend on the rays beside.
    const std::uint64_t first = block * PhotonBlock;
    HitCollector collector(first, std::numeric_limits<std::uint64_t>::max(), true);
    this->Follow(0, first, first + PhotonBlock, collector);
    std::uint64_t last = first + PhotonBlock; // none yet
    for (const PhotonHit& hit : collector.Hits())
    {
      if (hit.photon != last)
      {
        if (paths.size() == photons)
        {
          break;
        }
        paths.push_back({ this->StartOf(hit.photon), {} });
        last = hit.photon;
      }
      paths.back().hits.push_back(hit);
    }
  }
  return paths;
}

} // namespace PhotonTransport
