// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/registration/IlluminationSums.h"

#include <algorithm>

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
  }
  std::fill(part.begin(), part.end(), Part{});
}

} // namespace

void MoveInto(IlluminationSums& total, LightLayers& layers, IlluminationSums& part)
{
  MoveInto(total.front, part.front);
  MoveInto(total.back, part.back);
  MoveInto(layers.sums, part.layers.sums);
  MoveInto(total.arrivals, part.arrivals);
  total.cutByWeightBound += part.cutByWeightBound;
  total.balance += part.balance;
  part.cutByWeightBound = 0;
  part.balance = {};
}

} // namespace PhotonTransport
