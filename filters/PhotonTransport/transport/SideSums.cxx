// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/SideSums.h"

#include "PhotonTransport/threads/Threads.h"

namespace PhotonTransport
{

SideSums::SideSums(
  std::size_t slots, std::size_t replicates, std::size_t parts, std::size_t lampsApart)
  : lamps(lampsApart)
  , weights(replicates, std::vector<FixedPoint>(slots, 0))
  , direct(parts, std::vector<FixedPoint>(slots, 0))
  , hits(slots, 0)
{
}

void SideSums::Add(std::size_t replicate, std::vector<VertexSums>& sums)
{
  std::vector<FixedPoint>& ofReplicate = this->weights[replicate];
  std::vector<FixedPoint>& ofPart = this->direct[replicate % this->direct.size()];
  ForEach(this->Slots(),
    [&](std::size_t v)
    {
      if (this->lamps > 1 && sums[v].hits == 0 && sums[v].direct == 0 &&
        sums[v].indirect == 0) // as are most slots of many lamps after a slice
      {
        return;
      }
      ofReplicate[v] += sums[v].direct + sums[v].indirect;
      ofPart[v] += sums[v].direct;
      this->hits[v] += sums[v].hits;
      sums[v] = {};
    });
}

VertexSums SideSums::Total(std::size_t slot) const
{
  VertexSums total;
  total.hits = this->hits[slot];
  for (const std::vector<FixedPoint>& part : this->direct)
  {
    total.direct += part[slot];
  }
  for (const std::vector<FixedPoint>& ofReplicate : this->weights)
  {
    total.indirect += ofReplicate[slot];
  }
  total.indirect -= total.direct;
  return total;
}

} // namespace PhotonTransport
