// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/CellExitance.h"
#include "PhotonTransport/gathering/GatherWalk.h"
#include "PhotonTransport/gathering/GatheredMap.h"
#include "PhotonTransport/gathering/Gatherer.h"
#include "PhotonTransport/gathering/Receiver.h"
#include "PhotonTransport/gathering/ReportedLoop.h"
#include "PhotonTransport/threads/Ranks.h"

#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace PhotonTransport
{

/// Receivers that take places of a map, one after another.
struct ReceiverList
{
  std::uint64_t first; ///< Place in the map. Random numbers are a function of the place.
  std::uint64_t number;
  /// Makes the receiver for a place, on one side.
  std::function<void(std::uint64_t place, bool front, Receiver& receiver)> make;
};

/// What one first pass tells, and the effort with which it is gathered at receivers.
class GatherPass
{
public:
  using Report = LoopReport;

  /// @param luxPerUnit lx in a unit of light, see FinalGathering. @param reporter The thread that
  /// reports. @param ranks Which share the receivers; must outlive it.
  GatherPass(const GatherScene& scene, CellExitance exitance, const GatherEffort& effort,
    double luxPerUnit, std::thread::id reporter, Ranks& ranks)
    : Gathered(scene)
    , FirstPass(std::move(exitance))
    , Effort(effort)
    , LuxPerUnit(luxPerUnit)
    , Reporter(reporter)
    , Sharing(ranks)
  {
  }

  const GatherScene& Through() const { return this->Gathered; }
  const GatherEffort& WithEffort() const { return this->Effort; }
  double LuxOfUnit() const { return this->LuxPerUnit; }
  std::thread::id ReportingThread() const { return this->Reporter; }
  const CellExitance& Exitance() const { return this->FirstPass; }
  /// The light on a side of a cell by the first pass, lx.
  double IlluminanceOf(std::uint32_t cell, bool front) const
  {
    return this->LuxPerUnit * double{ this->FirstPass.illuminance[SideIndex(cell, front)] };
  }

  /// Receives light on one side, on the threads on which it is called and on all ranks. The result
  /// has the same bits for any number of both.
  /// @param map Has the places, which are 0. @param done Gets a 1 for each receiver that is done.
  /// @return Whether all are. If it was stopped, on any rank, some are not.
  bool Receive(const ReceiverList& receivers, bool front, const Report& report, GatheredMap& map,
    std::vector<std::uint8_t>& done) const;

private:
  bool ReceiveOwn(const ReceiverList& receivers, bool front, const Report& report, GatheredMap& map,
    std::vector<std::uint8_t>& done) const;
  void Store(
    const ReceivedLight& light, double variance, std::uint64_t place, GatheredMap& map) const;

  GatherScene Gathered;
  CellExitance FirstPass;
  GatherEffort Effort;
  double LuxPerUnit;
  std::thread::id Reporter;
  Ranks& Sharing;
};

} // namespace PhotonTransport
