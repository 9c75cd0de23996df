// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/registration/IlluminationSums.h"

namespace PhotonTransport
{
namespace
{

template <typename Part>
void MoveInto(std::vector<Part>& total, std::vector<Part>& part)
{
  for (std::size_t i = 0; i < total.size(); ++i)
  {
    total[i] += part[i];
    part[i] = {};
  }
}

} // namespace

void MoveInto(IlluminationSums& total, IlluminationSums& part)
{
  MoveInto(total.front, part.front);
  MoveInto(total.back, part.back);
  MoveInto(total.arrivals, part.arrivals);
  total.cutByWeightBound += part.cutByWeightBound;
  total.balance += part.balance;
  part.cutByWeightBound = 0;
  part.balance = {};
}

void MoveInto(LightLayers& total, LightLayers& part)
{
  for (std::size_t i = 0; i < total.sums.size(); ++i)
  {
    total.sums[i] += part.sums[i];
    part.sums[i] = 0;
  }
}

} // namespace PhotonTransport
