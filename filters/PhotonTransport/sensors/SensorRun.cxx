// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/sensors/SensorRun.h"

#include "PhotonTransport/gathering/GatherPass.h"
#include "PhotonTransport/gathering/ReportedLoop.h"
#include "PhotonTransport/lights/Clearance.h"
#include "PhotonTransport/transport/MemoryBudget.h"
#include "PhotonTransport/transport/SecondPass.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace PhotonTransport
{

TraceSettings SensorRun::WithCells(TraceSettings settings)
{
  settings.method = Method::FinalGathering;
  settings.registerBackSide = false;
  settings.lampsApart = false;
  return settings;
}

SensorRun::SensorRun(const Scene& scene, const Lighting& lighting, const TraceSettings& settings,
  Openings openings, MemoryBudget* memory)
  : LitScene(scene)
  , Settings(WithCells(settings))
  , ToSky(std::move(openings))
  , Cells(SecondPass::CellsFor(scene, this->Settings))
  , Tracer(scene, lighting, this->Settings, this->Cells.get())
  , Gathering(scene, *this->Cells, this->Tracer.Source(), this->ToSky, this->Tracer.EffectsInUse(),
      GatherSettings{ this->Settings.seed, this->Settings.maximumPathLength, false, false,
        this->Settings.threads })
{
  if (memory)
  {
    memory->KnowScene(scene.NumberOfParts(), this->Cells->Number());
    this->Gathering.WatchLinks([memory](std::uint64_t bytes) { memory->KnowLinks(bytes); });
  }
  this->Sums = ReplicateSums(this->Settings.replicates, this->Tracer.EmptySums());
}

void SensorRun::ShareWith(Ranks& ranks)
{
  this->Sharing = &ranks;
  this->Gathering.ShareWith(ranks);
}

bool SensorRun::Trace(std::uint64_t photons, const Progress& progress)
{
  const std::uint64_t inOneOfEach = this->Settings.replicates * PhotonBlock;
  const std::uint64_t blocks =
    std::max<std::uint64_t>(1, (photons + inOneOfEach - 1) / inOneOfEach);
  const std::uint64_t begin = blocks * this->Sharing->Index() / this->Sharing->Number();
  const std::uint64_t end = blocks * (this->Sharing->Index() + 1) / this->Sharing->Number();
  bool goOn = true;
  for (std::uint32_t r = 0; r < this->Settings.replicates && goOn; ++r)
  {
    const Monitor monitor = [&](std::uint64_t done)
    {
      const double ofReplicate =
        static_cast<double>(done) / static_cast<double>(std::max<std::uint64_t>(1, end - begin));
      return progress((r + ofReplicate) / this->Settings.replicates);
    };
    goOn = this->Tracer.Trace(
      r, begin, end - begin, [&](IlluminationSums& part) { this->Sums.Add(r, part); },
      progress ? monitor : Monitor());
    goOn = !this->Sharing->Any(!goOn);
  }
  for (IlluminationSums& replicate : this->Sums.replicates)
  {
    SumOver(*this->Sharing, replicate);
  }
  return goOn;
}

/// A sensor on a facet is put a little in front of it.
Receiver SensorRun::ReceiverAt(const Sensor& sensor) const
{
  const glm::dvec3 point = this->LitScene.GetPlacement().PointToScene(sensor.position);
  const glm::vec3 start(point + WayClearOfFacets(this->LitScene, { point }, sensor.normal));
  Receiver receiver;
  receiver.normal = glm::vec3(0.0f);
  receiver.starts.push_back({ start, glm::vec3(0.0f) });
  receiver.position = start;
  return receiver;
}

bool SensorRun::Read(const std::vector<Sensor>& sensors, const SensorDirections& directions,
  std::uint32_t rays, const Progress& progress, std::vector<SensorReading>& readings)
{
  readings.assign(sensors.size(), {});
  const Viewers viewers{ sensors.size(),
    [&](std::uint64_t i, Receiver& receiver) { receiver = this->ReceiverAt(sensors[i]); } };
  bool done = false;
  this->Gathering.Run(viewers, CountsOf(this->Sums), rays,
    [&](const GatherPass& pass)
    { done = this->ReadShare(sensors, directions, pass, progress, readings); });
  this->Sharing->SumAll(readings); // each has values on one rank
  return !this->Sharing->Any(!done);
}

/// Reads the sensors of this rank, which are those that follow each other in space as a rule.
bool SensorRun::ReadShare(const std::vector<Sensor>& sensors, const SensorDirections& directions,
  const GatherPass& pass, const Progress& progress, std::vector<SensorReading>& readings) const
{
  const std::uint64_t begin = sensors.size() * this->Sharing->Index() / this->Sharing->Number();
  const std::uint64_t end = sensors.size() * (this->Sharing->Index() + 1) / this->Sharing->Number();
  const LoopReport report = [&](std::uint64_t done)
  { return progress(static_cast<double>(done) / static_cast<double>(end - begin)); };
  return ReportedFor(end - begin, pass.ReportingThread(), progress ? report : LoopReport(),
    [&]
    {
      return [&, reader = SensorReader(pass, directions)](std::uint64_t k) mutable
      {
        const std::uint64_t i = begin + k;
        reader.Read(this->ReceiverAt(sensors[i]), sensors[i].normal, i, readings[i]);
      };
    });
}

ShareOfLight SensorRun::Caustics() const
{
  double all = 0.0, caustic = 0.0;
  for (const IlluminationSums& replicate : this->Sums.replicates)
  {
    all = std::accumulate(replicate.cells.all.begin(), replicate.cells.all.end(), all);
    caustic =
      std::accumulate(replicate.cells.caustic.begin(), replicate.cells.caustic.end(), caustic);
  }
  all /= this->Sums.replicates.front().cells.OfPhoton();
  caustic /= this->Sums.replicates.front().cells.OfPhoton();
  // A photon counts each time that it meets the surface.
  const double each =
    std::max(1.0, all / std::max(1.0, static_cast<double>(this->Sums.Balance().emitted)));
  return { caustic, all, each * caustic, each * all };
}

} // namespace PhotonTransport
