// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/gathering/GatherPass.h"

#include "PhotonTransport/statistics/ReplicateStatistics.h"

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{

bool GatherPass::Receive(const ReceiverList& receivers, bool front, const Report& report,
  GatheredMap& map, std::vector<std::uint8_t>& done) const
{
  done.assign(receivers.number, 0);
  const bool goOn = this->ReceiveOwn(receivers, front, report, map, done);
  // Each place has light on the one rank that received it.
  const std::size_t lamps = map.direct.empty() ? 0 : map.ofLamps.size() / map.direct.size();
  this->Sharing.SumAll(map.direct, receivers.first);
  this->Sharing.SumAll(map.gathered, receivers.first);
  this->Sharing.SumAll(map.standardError, receivers.first);
  this->Sharing.SumAll(map.channels, map.channels.empty() ? 0 : receivers.first);
  this->Sharing.SumAll(map.ofLamps, receivers.first * lamps);
  this->Sharing.SumAll(done);
  return goOn;
}

/// Receives light at the receivers of this rank, in groups of a few, which the ranks take in turn:
/// neighbours take about as long. Now and then all ranks agree on whether to go on.
bool GatherPass::ReceiveOwn(const ReceiverList& receivers, bool front, const Report& report,
  GatheredMap& map, std::vector<std::uint8_t>& done) const
{
  constexpr std::uint64_t Group = 4;
  constexpr std::uint64_t RaysBetween = 1u << 19; // of a rank, from one agreement to the next
  const std::uint64_t ranks = this->Sharing.Number();
  const std::uint64_t rounds = (receivers.number + Group * ranks - 1) / (Group * ranks);
  const std::uint64_t own = Group * rounds; // of which the last ones may be none
  const std::uint64_t between = this->Sharing.AreSeveral()
    ? Group * std::max<std::uint64_t>(1, RaysBetween / (Group * this->Effort.Rays()))
    : own;
  bool goOn = true;
  for (std::uint64_t first = 0; first < own && goOn; first += between)
  {
    const LoopReport reportAll = [&](std::uint64_t number)
    { return report(std::min((first + number) * ranks, receivers.number)); };
    const auto makeWork = [&]
    {
      return [&, gatherer = Gatherer(this->Gathered, this->FirstPass, this->Effort),
               receiver = Receiver(), light = ReceivedLight()](std::uint64_t k) mutable
      {
        const std::uint64_t group = (first + k) / Group * ranks + this->Sharing.Index();
        const std::uint64_t i = group * Group + (first + k) % Group;
        if (i < receivers.number)
        {
          const std::uint64_t place = receivers.first + i;
          receivers.make(place, front, receiver);
          const double variance = gatherer.Receive(receiver, 2 * place + (front ? 0 : 1), light);
          this->Store(light, variance, place, map);
          done[i] = 1;
        }
      };
    };
    goOn = ReportedFor(
      std::min(between, own - first), this->Reporter, report ? reportAll : LoopReport(), makeWork);
    goOn = !this->Sharing.Any(!goOn);
  }
  return goOn;
}

void GatherPass::Store(
  const ReceivedLight& light, double variance, std::uint64_t place, GatheredMap& map) const
{
  ReplicateStatistics statistics;
  for (std::size_t r = 0; r < light.indirect.size(); ++r)
  {
    statistics.Add(light.indirect[r], this->FirstPass.shareOf[r]);
  }
  // What rays and lamps' samples miss does not depend on what photons missed: variances add up.
  const double unit = this->LuxPerUnit;
  map.direct[place] = unit * light.direct;
  map.gathered[place] = unit * statistics.Mean();
  map.standardError[place] = unit * std::sqrt(variance + std::pow(statistics.StandardError(), 2.0));
  if (!map.channels.empty())
  {
    map.channels[place] = { unit * light.channels.x, unit * light.channels.y,
      unit * light.channels.z };
  }
  std::transform(light.ofLamps.begin(), light.ofLamps.end(),
    map.ofLamps.begin() + static_cast<std::ptrdiff_t>(place * light.ofLamps.size()),
    [&](double ofLamp) { return unit * ofLamp; });
}

} // namespace PhotonTransport
