// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/transport/SideSums.h"

#include "PhotonTransport/threads/Threads.h"

namespace PhotonTransport
{

SideSums::SideSums(std::size_t vertices, std::size_t replicates, std::size_t parts)
  : weights(replicates, std::vector<FixedPoint>(vertices, 0))
  , direct(parts, std::vector<FixedPoint>(vertices, 0))
  , hits(vertices, 0)
{
}

void SideSums::Add(std::size_t replicate, std::vector<VertexSums>& sums)
{
  std::vector<FixedPoint>& ofReplicate = this->weights[replicate];
  std::vector<FixedPoint>& ofPart = this->direct[replicate % this->direct.size()];
  ForEach(this->Vertices(),
    [&](std::size_t v)
    {
      ofReplicate[v] += sums[v].direct + sums[v].indirect;
      ofPart[v] += sums[v].direct;
      this->hits[v] += sums[v].hits;
      sums[v] = {};
    });
}

VertexSums SideSums::Total(std::size_t vertex) const
{
  VertexSums total;
  total.hits = this->hits[vertex];
  for (const std::vector<FixedPoint>& part : this->direct)
  {
    total.direct += part[vertex];
  }
  for (const std::vector<FixedPoint>& ofReplicate : this->weights)
  {
    total.indirect += ofReplicate[vertex];
  }
  total.indirect -= total.direct;
  return total;
}

} // namespace PhotonTransport
