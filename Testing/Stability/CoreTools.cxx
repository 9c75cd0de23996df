// SPDX-License-Identifier: BSD-3-Clause
#include "CoreTools.h"

#include <cstdlib>

using namespace PhotonTransport;

TraceSettings Way::Settings() const
{
  TraceSettings settings;
  settings.registration = this->registration;
  settings.threads = this->threads;
  settings.registerBackSide = true;
  return settings;
}

::testing::internal::ParamGenerator<Way> AllWays()
{
  return ::testing::Values(Way{ Registration::Flat, 1 }, Way{ Registration::Flat, 2 },
    Way{ Registration::FacetRatio, 1 }, Way{ Registration::FacetRatio, 2 },
    Way{ Registration::VertexNormalised, 1 }, Way{ Registration::VertexNormalised, 2 });
}

std::string NameOfWay(const ::testing::TestParamInfo<Way>& instance)
{
  const char* names[] = { "Flat", "FacetRatio", "VertexNormalised" };
  return names[static_cast<int>(instance.param.registration)] +
    (instance.param.threads == 1 ? std::string("OneThread") : std::string("TwoThreads"));
}

void Report(const std::string& protects, const std::string& measured)
{
  ::testing::Test::RecordProperty("protects", protects);
  ::testing::Test::RecordProperty("measured", measured);
}

bool LongTests()
{
  const char* asked = std::getenv("ILLUMINATION_LONG_TESTS");
  return asked && std::string(asked) == "1";
}
