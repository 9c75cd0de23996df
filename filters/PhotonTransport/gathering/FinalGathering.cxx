// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/gathering/FinalGathering.h"

#include "PhotonTransport/gathering/CellLinks.h"
#include "PhotonTransport/gathering/DirectLight.h"
#include "PhotonTransport/gathering/GatherPass.h"
#include "PhotonTransport/gathering/VertexReceivers.h"
#include "PhotonTransport/materials/Colour.h"

#include <algorithm>
#include <cmath>
#include <thread>

namespace PhotonTransport
{
namespace
{

/// The light on a side of a cell but for caustics.
double WithoutCaustics(const CellExitance& exitance, std::size_t side)
{
  double light = exitance.illuminance[side];
  if (const float* caustic = exitance.caustic.Of(side))
  {
    for (const double share : exitance.shareOf)
    {
      for (std::size_t c = 0; c < exitance.channels; ++c)
      {
        light -= share * double{ *caustic++ };
      }
    }
  }
  return std::max(0.0, light);
}

} // namespace

FinalGathering::FinalGathering(const Scene& scene, const FacetCells& cells, const Emitter& source,
  const Openings& openings, const Effects& effects, const GatherSettings& settings)
  : LitScene(scene)
  , Cells(cells)
  , ToSky(openings)
  , EffectsInUse(effects)
  , Lamps(settings.lampsApart ? source.Lamps() : 0)
  , LuxPerUnit(source.Flux() / scene.SquareMetresPerSceneArea())
  , Settings(settings)
  , Workers(settings.threads)
  , Materials(std::make_unique<FacetRoulettes>(
      MakeRoulettes(scene.Materials(), scene.MaterialOfFacet(), effects.colouredFacets)))
  , DirectFromLamps(std::make_unique<DirectLight>(scene, source, *this->Materials,
      effects.simulated, this->LuxPerUnit > 0.0 ? this->LuxPerUnit : 1.0))
  , Receivers(std::make_unique<VertexReceivers>(scene, cells))
{
}

FinalGathering::~FinalGathering() = default;

void FinalGathering::Run(const PhotonCounts& counts, std::uint32_t rays,
  const std::function<void(const GatherPass& pass)>& work)
{
  const std::uint64_t sides = this->Settings.backSide ? 2 : 1;
  const auto make = [&](std::uint64_t i, Receiver& receiver)
  { this->Receivers->Make(static_cast<std::uint32_t>(i / sides), i % sides == 0, receiver); };
  this->Run({ this->LitScene.NumberOfMapVertices() * sides, make }, counts, rays, work);
}

void FinalGathering::Run(const Viewers& viewers, const PhotonCounts& counts, std::uint32_t rays,
  const std::function<void(const GatherPass& pass)>& work)
{
  const std::thread::id caller = std::this_thread::get_id();
  this->Workers.Run(
    [&]
    {
      const GatherScene scene{ this->LitScene, this->Cells, *this->DirectFromLamps,
        *this->Materials, this->ToSky, this->EffectsInUse.simulated, this->Settings.seed,
        this->Settings.maximumPathLength };
      work(GatherPass(scene, this->FirstPass(scene, viewers, counts, rays), GatherEffort(rays),
        this->LuxPerUnit, caller, *this->Sharing));
    });
}

bool FinalGathering::Gather(
  const PhotonCounts& counts, std::uint32_t rays, const Progress& progress)
{
  bool done = false;
  this->Run(
    counts, rays, [&](const GatherPass& pass) { done = this->GatherSides(pass, progress); });
  return done;
}

void FinalGathering::ShowFirstPass(const PhotonCounts& counts)
{
  this->OfFirstPass = true;
  this->Workers.Run(
    [&]
    {
      const CellExitance exitance =
        ExitanceByPhotons(this->LitScene, this->Cells, this->EffectsInUse, counts);
      const std::vector<std::uint8_t> none(this->LitScene.NumberOfMapVertices(), 0);
      this->FrontMap = this->EmptyMap();
      this->FillFromFacets(exitance, true, none, this->FrontMap);
      if (this->Settings.backSide)
      {
        this->BackMap = this->EmptyMap();
        this->FillFromFacets(exitance, false, none, this->BackMap);
      }
    });
}

bool FinalGathering::GatherSides(const GatherPass& pass, const Progress& progress)
{
  const std::size_t vertices = this->LitScene.NumberOfMapVertices();
  const ReceiverList all{ 0, vertices,
    [this](std::uint64_t place, bool front, Receiver& receiver)
    { this->Receivers->Make(static_cast<std::uint32_t>(place), front, receiver); } };
  const std::uint64_t sides = this->Settings.backSide ? 2 : 1;
  GatheredMap maps[2];
  bool goOn = true;
  for (std::uint64_t side = 0; side < sides; ++side)
  {
    maps[side] = this->EmptyMap();
    std::vector<std::uint8_t> done(vertices, 0);
    const GatherPass::Report report = [&](std::uint64_t number)
    {
      return progress(
        static_cast<double>(side * vertices + number) / static_cast<double>(sides * vertices));
    };
    goOn = goOn &&
      pass.Receive(all, side == 0, progress ? report : GatherPass::Report(), maps[side], done);
    if (!goOn)
    {
      this->FillFromFacets(pass.Exitance(), side == 0, done, maps[side]);
    }
  }
  if (goOn || this->OfFirstPass || this->FrontMap.direct.empty())
  {
    this->OfFirstPass = false;
    this->FrontMap = std::move(maps[0]);
    this->BackMap = std::move(maps[1]);
  }
  return goOn;
}

CellExitance FinalGathering::FirstPass(const GatherScene& scene, const Viewers& viewers,
  const PhotonCounts& counts, std::uint32_t rays) const
{
  CellExitance exitance =
    ExitanceByPhotons(this->LitScene, this->Cells, this->EffectsInUse, counts);
  if (this->DirectFromLamps->HasSky())
  {
    const CellLinks links(scene, viewers, this->EffectsInUse, rays);
    if (links.PhotonsAreFew(counts))
    {
      links.Solve(exitance, this->OnLinks);
    }
  }
  return exitance;
}

GatheredMap FinalGathering::EmptyMap() const
{
  GatheredMap map;
  map.Resize(this->LitScene.NumberOfMapVertices(), this->EffectsInUse.colour, this->Lamps);
  return map;
}

/// Gives vertices that are not done the light on the facets around them, all of it as gathered
/// light, and an error as large. Caustics are left out, since photons have brought them to
/// vertices. Where there are colours it is white.
void FinalGathering::FillFromFacets(const CellExitance& exitance, bool front,
  const std::vector<std::uint8_t>& done, GatheredMap& map) const
{
  ForEach(done.size(),
    [&](std::size_t v)
    {
      if (done[v] != 0)
      {
        return;
      }
      double flux = 0.0;
      double area = 0.0;
      for (const std::uint32_t f : this->Receivers->Rings().Of(static_cast<std::uint32_t>(v)))
      {
        const double ofFacet = glm::length(this->LitScene.AreaVectors()[f]);
        this->Cells.ForEachOf(f,
          [&](std::uint32_t cell, double share)
          { flux += share * ofFacet * WithoutCaustics(exitance, SideIndex(cell, front)); });
        area += ofFacet;
      }
      const double light = area > 0.0 ? this->LuxPerUnit * flux / area : 0.0;
      map.gathered[v] = map.standardError[v] = light;
      if (!map.channels.empty())
      {
        map.channels[v] = { light * double{ LuminousWeights.x },
          light * double{ LuminousWeights.y }, light * double{ LuminousWeights.z } };
      }
    });
}

std::uint32_t RaysFor(std::uint64_t photons)
{
  constexpr double Rays = 64.0; // that suit this number of photons
  constexpr double Photons = 1e5;
  constexpr double Growth = 0.6;
  const double rays = Rays * std::pow(static_cast<double>(photons) / Photons, Growth);
  return static_cast<std::uint32_t>(std::clamp(rays, 16.0, 4096.0));
}

} // namespace PhotonTransport
