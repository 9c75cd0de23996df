// SPDX-License-Identifier: BSD-3-Clause
// Case 12: what the core takes, told as it becomes known, not exceeded, and refused where it is too
// much.
#include "CoreTools.h"
#include "ProcessMemory.h"

#include "PhotonTransport/scene/InvalidInput.h"
#include "PhotonTransport/transport/MemoryBudget.h"
#include "PhotonTransport/transport/SkyOpenings.h"

#include <cmath>
#include <cstdint>

using namespace PhotonTransport;
using namespace ProcessMemory;

namespace
{

#if defined(__SANITIZE_ADDRESS__)
constexpr bool MeasuresMemory = false; // it keeps freed memory for a while
#else
constexpr bool MeasuresMemory = true;
#endif

constexpr std::uint64_t MoreThanEnough = std::uint64_t{ 1 } << 40;
const Lamp Point = PointLamp{ { -1.0, 0.5, 0.8 }, 1000.0 };

struct Kind
{
  const char* name;
  Method method;
  std::uint32_t replicates;
  bool sky;
};

TraceSettings SettingsOf(const Kind& kind)
{
  TraceSettings settings;
  settings.method = kind.method;
  settings.replicates = kind.replicates;
  settings.gatherRays = LeastGatherRays;
  settings.threads = 2;
  return settings;
}

/// A room with a window, or with a ball and a lamp.
Shapes::Surface RoomOf(const Kind& kind, int triangles)
{
  const int cells = static_cast<int>(std::sqrt(triangles / 2));
  return Shapes::WithReflectance(kind.sky
      ? Shapes::RoomWithWindow(4.0, 3.0, { -1.0, 0.9, 1.0, 2.4 }, cells)
      : Shapes::RoomWithSphere(triangles),
    0.5f);
}

/// Bytes, of which nothing is known at first but the surface.
struct Memory
{
  double told = 0.0;
  double toldAtFirst = 0.0;
  double taken = 0.0;
};

/// A run to a map and the error of facet size. Throws InvalidInput if it takes more than the limit.
Memory Measure(const Kind& kind, int triangles, std::uint64_t limit)
{
  const Shapes::Surface surface = RoomOf(kind, triangles);
  const TraceSettings settings = SettingsOf(kind);
  const Lighting lighting = kind.sky ? Lamp(UniformSky{}) : Point;
  GiveBack();
  ForgetPeak();
  const double before = Status("VmRSS:");
  MemoryBudget budget(MemoryNeed(surface, lighting, settings), {}, MemoryLimit(limit));
  Memory memory;
  memory.toldAtFirst = static_cast<double>(budget.Bytes());
  const Scene scene(surface);
  const FoundOpenings openings = OpeningsToSkies(surface, scene, lighting, settings);
  IlluminationRun run(scene, lighting, settings, openings.openings, &budget);
  StopRules rules;
  rules.photons = 10'000;
  run.Advance(rules);
  run.FacetErrorOf(run.Front());
  memory.told = static_cast<double>(budget.Bytes());
  memory.taken = Status("VmHWM:") - before +
    static_cast<double>(surface.points.size() * 2 * sizeof(glm::dvec3) +
      surface.facets.size() * (sizeof(glm::uvec3) + sizeof(std::uint32_t)));
  return memory;
}

} // namespace

class Case12 : public ::testing::TestWithParam<Kind>
{
};

INSTANTIATE_TEST_SUITE_P(Stability, Case12,
  ::testing::Values(Kind{ "TwoReplicates", Method::PhotonTracing, 2, false },
    Kind{ "ManyReplicates", Method::PhotonTracing, 32, false },
    Kind{ "Gathered", Method::FinalGathering, 8, false },
    Kind{ "GatheredFromManyReplicates", Method::FinalGathering, 32, false },
    Kind{ "GatheredUnderASky", Method::FinalGathering, 8, true }),
  [](const ::testing::TestParamInfo<Kind>& instance) { return instance.param.name; });

TEST_P(Case12, ARunTakesNoMoreThanItSaid)
{
  if (!MeasuresMemory || Status("VmRSS:") == 0.0)
  {
    GTEST_SKIP() << "not measured here";
  }
  Measure(GetParam(), 1000, MoreThanEnough); // what every process takes: libraries, threads
  const Memory memory = Measure(GetParam(), 200'000, MoreThanEnough);
  EXPECT_LT(memory.taken, memory.told);
  EXPECT_GT(memory.taken, 0.8 * memory.told) << "it would refuse what could be run";
  Report("a run that the system ends for want of memory", "between 80 % and all of what it said");
}

TEST(Case12, MoreThanTheLimitIsRefusedOnceItIsKnown)
{
  const Kind underSky{ "", Method::FinalGathering, 8, true };
  const Memory memory = Measure(underSky, 1000, MoreThanEnough);
  EXPECT_LT(memory.toldAtFirst, 0.5 * memory.told) << "links between cells are not known yet";
  EXPECT_NO_THROW(Measure(underSky, 1000, static_cast<std::uint64_t>(memory.told)));
  EXPECT_THROW(
    Measure(underSky, 1000, static_cast<std::uint64_t>(0.99 * memory.told)), InvalidInput)
    << "by links, when they are found";
  EXPECT_THROW(
    Measure(underSky, 1000, static_cast<std::uint64_t>(0.99 * memory.toldAtFirst)), InvalidInput)
    << "before there is a scene";
  Report("a run that the system ends for want of memory",
    "refused by its surface, and by links between cells as they are found");
}
