// SPDX-License-Identifier: BSD-3-Clause
#include "CoreTools.h"

#include "TracedMap.h"

#include <cmath>
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

SoundRun::SoundRun(const Shapes::Surface& surface, const Lamp& lamp, const TraceSettings& settings,
  std::uint64_t photons)
  : scene(surface)
{
  IlluminationRun run(this->scene, lamp, settings);
  run.Advance({ photons });
  this->front = run.Front();
  this->balance = run.Balance();
  this->fluxCut = run.FluxCutByWeightBound();
  this->flux = run.Flux();
  EXPECT_EQ(balance.emitted, balance.absorbed + balance.escaped + balance.cutOff);
  this->ExpectSound(this->front);
  if (settings.registerBackSide)
  {
    this->back = run.Back();
    this->ExpectSound(this->back);
    const double arrived = this->flux * static_cast<double>(balance.segments - balance.escaped) /
      static_cast<double>(balance.emitted);
    const double registered = this->RegisteredFlux(this->front) + this->RegisteredFlux(this->back);
    const double most = arrived * static_cast<double>(MostFacetsInOnePlace(this->scene));
    // Three weights of a hit are rounded to 2^-28 each, and sums of floats to 2^-24.
    EXPECT_LE(registered, most * double{ settings.weightBound } * (1.0 + 1e-6));
    if (settings.registration == Registration::Flat)
    {
      EXPECT_GE(registered, arrived * (1.0 - 1e-6));
      EXPECT_LE(registered, most * (1.0 + 1e-6));
    }
  }
}

void SoundRun::ExpectSound(const IlluminationMap& side) const
{
  for (std::size_t v = 0; v < side.direct.size(); ++v)
  {
    ASSERT_TRUE(std::isfinite(side.direct[v]) && side.direct[v] >= 0.0) << "vertex " << v;
    ASSERT_TRUE(std::isfinite(side.indirect[v]) && side.indirect[v] >= 0.0) << "vertex " << v;
    ASSERT_TRUE(std::isfinite(side.standardError[v]) && side.standardError[v] >= 0.0) << v;
  }
}

double SoundRun::RegisteredFlux(const IlluminationMap& side) const
{
  double sum = 0.0;
  for (std::size_t v = 0; v < side.direct.size(); ++v)
  {
    sum += this->scene.VertexAreas()[v] * (side.direct[v] + side.indirect[v]);
  }
  return sum;
}

double SoundRun::FluxError() const
{
  double square = 0.0;
  for (std::size_t v = 0; v < this->front.direct.size(); ++v)
  {
    square += std::pow(this->scene.VertexAreas()[v] * this->front.standardError[v], 2);
  }
  return std::sqrt(square);
}
