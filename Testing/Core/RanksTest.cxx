// SPDX-License-Identifier: BSD-3-Clause
// Runs that several ranks share. Ranks are threads here: what they tell each other is the same.
#include "PhotonTransport/adaptive/AdaptiveLimits.h"
#include "PhotonTransport/transport/IlluminationRun.h"
#include "PhotonTransport/transport/RefinedMap.h"

#include "Shapes.h"

#include <gtest/gtest.h>

#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

using namespace PhotonTransport;

namespace
{

/// Where threads that are ranks meet.
class Meeting
{
public:
  explicit Meeting(std::uint64_t ranks)
    : Number(ranks)
  {
  }

  void Sum(std::uint64_t* values, std::size_t count)
  {
    std::unique_lock lock(this->Mutex);
    if (this->Came++ == 0)
    {
      this->Total.assign(count, 0);
    }
    EXPECT_EQ(this->Total.size(), count); // or the ranks do not do the same
    EXPECT_LE(count, Ranks::MostAtOnce);
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Total[i] += values[i];
    }
    this->Sums += count;
    const std::uint64_t meeting = this->Meetings;
    if (this->Came == this->Number)
    {
      this->Came = 0;
      this->Result = this->Total;
      ++this->Meetings;
      this->Changed.notify_all();
    }
    this->Changed.wait(lock, [&] { return this->Meetings > meeting; });
    std::copy(this->Result.begin(), this->Result.end(), values);
  }

  const std::uint64_t Number;
  std::uint64_t Sums = 0; ///< Values that ranks have given.

private:
  std::mutex Mutex;
  std::condition_variable Changed;
  std::uint64_t Came = 0;
  std::uint64_t Meetings = 0;
  std::vector<std::uint64_t> Total, Result;
};

class ThreadRanks : public Ranks
{
public:
  ThreadRanks(Meeting& meeting, std::uint64_t index)
    : All(meeting)
    , Own(index)
  {
  }
  std::uint64_t Number() const override { return this->All.Number; }
  std::uint64_t Index() const override { return this->Own; }
  void Sum(std::uint64_t* values, std::size_t count) override { this->All.Sum(values, count); }

private:
  Meeting& All;
  std::uint64_t Own;
};

/// Calls work(ranks) on so many ranks at a time.
void OnRanks(std::uint64_t number, const std::function<void(Ranks& ranks)>& work)
{
  Meeting meeting(number);
  std::vector<std::thread> threads;
  for (std::uint64_t r = 0; r < number; ++r)
  {
    threads.emplace_back(
      [&, r]
      {
        ThreadRanks ranks(meeting, r);
        work(ranks);
      });
  }
  for (std::thread& thread : threads)
  {
    thread.join();
  }
}

const Lamp RoomLamp = PointLamp{ glm::dvec3(-1.0, 0.5, 0.8), 1000.0 };

Surface Room()
{
  return Shapes::WithReflectance(Shapes::RoomWithSphere(300), 0.6f);
}

void ExpectSame(const IlluminationMap& a, const IlluminationMap& b)
{
  EXPECT_EQ(a.direct, b.direct);
  EXPECT_EQ(a.indirect, b.indirect);
  EXPECT_EQ(a.caustic, b.caustic);
  EXPECT_EQ(a.standardError, b.standardError);
  EXPECT_EQ(a.photonHits, b.photonHits);
}

TraceSettings Settings(Method method)
{
  TraceSettings settings;
  settings.method = method;
  settings.gatherRays = 40;
  settings.registerBackSide = true;
  settings.lampsApart = true;
  settings.threads = 1;
  return settings;
}

} // namespace

TEST(Ranks, SumsOfAnySizeAndWidth)
{
  OnRanks(3,
    [](Ranks& ranks)
    {
      std::vector<std::uint32_t> counts(2 * Ranks::MostAtOnce + 3, 1u << 30); // longer than a sum
      ranks.SumAll(counts);
      EXPECT_EQ(counts, std::vector<std::uint32_t>(counts.size(), 3u << 30));
      std::vector<double> light(7, ranks.Index() == 2 ? -0.1 : 0.0);
      ranks.SumAll(light, 1);
      EXPECT_EQ(light.back(), -0.1);
      EXPECT_EQ(light.front(), ranks.Index() == 2 ? -0.1 : 0.0);
      EXPECT_EQ(ranks.OfFirst(0.5 + static_cast<double>(ranks.Index())), 0.5);
      EXPECT_TRUE(ranks.Any(ranks.Index() == 1));
      EXPECT_FALSE(ranks.Any(false));
    });
}

// Going on, too, and on a refined surface.
TEST(Ranks, AnyNumberGivesTheSameBits)
{
  for (const Method method : { Method::PhotonTracing, Method::FinalGathering })
  {
    const Surface surface = Room();
    const Scene scene(surface);
    IlluminationRun alone(scene, RoomLamp, Settings(method));
    alone.Advance({ 50'000 });
    const std::optional<RefinedMap> refined = alone.Refine(surface, AdaptiveLimits());
    EXPECT_EQ(refined.has_value(), method == Method::FinalGathering);
    for (const std::uint64_t number : { 2u, 3u })
    {
      OnRanks(number,
        [&](Ranks& ranks)
        {
          const Scene own(surface);
          IlluminationRun run(own, RoomLamp, Settings(method));
          run.ShareWith(ranks);
          EXPECT_EQ(run.Advance({ 20'000 }), StopReason::PhotonLimit);
          EXPECT_EQ(run.Advance({ 50'000 }), StopReason::PhotonLimit);
          ExpectSame(run.Front(), alone.Front());
          ExpectSame(run.Back(), alone.Back());
          EXPECT_EQ(run.FrontOfLamp(0), alone.FrontOfLamp(0));
          EXPECT_EQ(run.FrontByGroups().direct, alone.FrontByGroups().direct);
          EXPECT_EQ(run.Balance().segments, alone.Balance().segments);
          EXPECT_EQ(run.ArrivalsByLamp()[0].front, alone.ArrivalsByLamp()[0].front);
          const std::optional<RefinedMap> own2 = run.Refine(surface, AdaptiveLimits());
          ASSERT_EQ(own2.has_value(), refined.has_value());
          if (own2)
          {
            ExpectSame(own2->front, refined->front);
          }
        });
    }
  }
}

// Each rank's part of the work is less than all of it.
TEST(Ranks, ShareTheWork)
{
  const Scene scene(Room());
  std::vector<std::uint64_t> asked(2, 0);
  OnRanks(2,
    [&](Ranks& ranks)
    {
      IlluminationRun run(scene, RoomLamp, Settings(Method::PhotonTracing));
      run.ShareWith(ranks);
      // The monitor is called once a block.
      run.Advance({ 400'000 },
        [&](const RunProgress&)
        {
          ++asked[ranks.Index()];
          return true;
        });
    });
  const std::uint64_t blocks = (400'000 + 256 * 8 - 1) / (256 * 8) * 8;
  EXPECT_EQ(asked[0] + asked[1], blocks);
  EXPECT_NEAR(static_cast<double>(asked[0]), static_cast<double>(asked[1]), 100.0);
}

TEST(Ranks, OneAbortsForAll)
{
  const Scene scene(Room());
  for (const Method method : { Method::PhotonTracing, Method::FinalGathering })
  {
    std::vector<std::vector<double>> maps(3);
    OnRanks(3,
      [&](Ranks& ranks)
      {
        TraceSettings settings = Settings(method);
        settings.gatherRays = 16'384; // would take long
        IlluminationRun run(scene, RoomLamp, settings);
        run.ShareWith(ranks);
        const std::uint64_t photons = method == Method::PhotonTracing ? 4'000'000'000 : 20'000;
        EXPECT_EQ(run.Advance({ photons },
                    [&](const RunProgress& progress)
                    { return ranks.Index() != 1 || !(progress.fraction > 1e-4); }),
          StopReason::Abort);
        EXPECT_EQ(
          run.CanGoOn(), method == Method::FinalGathering && run.Balance().emitted > 20'000);
        maps[ranks.Index()] = run.Front().indirect;
      });
    EXPECT_EQ(maps[0], maps[1]);
    EXPECT_EQ(maps[0], maps[2]);
  }
}

TEST(Ranks, TheFirstTellsTheTime)
{
  const Scene scene(Room());
  std::vector<double> seconds(2);
  OnRanks(2,
    [&](Ranks& ranks)
    {
      IlluminationRun run(scene, RoomLamp, Settings(Method::PhotonTracing));
      run.ShareWith(ranks);
      EXPECT_EQ(run.Advance({ 4'000'000'000, 0.0, 0.2 }), StopReason::TimeLimit);
      seconds[ranks.Index()] = run.Rounds().back().seconds;
    });
  EXPECT_EQ(seconds[0], seconds[1]);
  EXPECT_GE(seconds[0], 0.2);
}
