// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/registration/IlluminationSums.h"

namespace PhotonTransport
{
namespace
{

void Add(VertexSums& total, const VertexSums& part)
{
  total.direct += part.direct;
  total.indirect += part.indirect;
}

void Add(std::uint64_t& total, std::uint64_t part)
{
  total += part;
}

template <typename Element>
void MoveInto(std::vector<Element>& total, std::vector<Element>& part)
{
  for (std::size_t i = 0; i < total.size(); ++i)
  {
    Add(total[i], part[i]);
    part[i] = Element{};
  }
}

} // namespace

void MoveInto(IlluminationSums& total, IlluminationSums& part)
{
  MoveInto(total.front, part.front);
  MoveInto(total.back, part.back);
  MoveInto(total.frontHits, part.frontHits);
  total.cutByWeightBound += part.cutByWeightBound;
  total.balance += part.balance;
  part.cutByWeightBound = 0;
  part.balance = {};
}

} // namespace PhotonTransport
