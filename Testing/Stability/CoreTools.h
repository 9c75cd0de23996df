// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "Shapes.h"
#include "TracedMap.h"

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
