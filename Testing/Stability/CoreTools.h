// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Shapes.h"

#include "PhotonTransport/transport/IlluminationRun.h"

#include <gtest/gtest.h>

#include <string>

/// How a case is traced: each is tried with all registrations, on one thread and on two.
struct Way
{
  PhotonTransport::Registration registration;
  int threads;

  PhotonTransport::TraceSettings Settings() const;
};

/// A test that is run in each way.
class EveryWay : public ::testing::TestWithParam<Way>
{
};
::testing::internal::ParamGenerator<Way> AllWays();
std::string NameOfWay(const ::testing::TestParamInfo<Way>& instance);

/// For the table in Testing/README.md.
void Report(const std::string& protects, const std::string& measured);

/// Whether the long versions are asked for: ILLUMINATION_LONG_TESTS=1.
bool LongTests();

/// A run to a number of photons whose result is sound: photons balance, all values are finite and
/// not below 0, and no more flux is registered than arrived times the weight bound, on each facet
/// in one place.
class SoundRun
{
public:
  SoundRun(const Shapes::Surface& surface, const PhotonTransport::Lamp& lamp,
    const PhotonTransport::TraceSettings& settings, std::uint64_t photons);

  PhotonTransport::Scene scene;
  PhotonTransport::IlluminationMap front, back;
  PhotonTransport::PhotonBalance balance;
  double fluxCut = 0.0; ///< By the weight bound, lm.
  double flux = 0.0;    ///< Of the lamp, lm.

  /// sum A E of a side, lm.
  double RegisteredFlux(const PhotonTransport::IlluminationMap& side) const;
  /// Standard error of RegisteredFlux(front) as if vertices were independent, which is too small by
  /// less than sqrt(3), lm.
  double FluxError() const;

private:
  void ExpectSound(const PhotonTransport::IlluminationMap& side) const;
};
