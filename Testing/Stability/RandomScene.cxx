// SPDX-License-Identifier: BSD-3-Clause
#include "RandomChoices.h"

using namespace PhotonTransport;

namespace
{

TraceSettings DrawSettings()
{
  TraceSettings settings;
  settings.replicates = 2;
  settings.seed = static_cast<std::uint32_t>(Below(1000));
  settings.sampling = OneIn(2) ? Sampling::Random : Sampling::Sobol;
  settings.registration =
    OneOf({ Registration::VertexNormalised, Registration::FacetRatio, Registration::Flat });
  settings.scatterings =
    OneIn(4) ? static_cast<ScatteringSet>(Below(AllScatterings + 1)) : AllScatterings;
  settings.colour = !OneIn(4);
  settings.lampsApart = OneIn(2);
  settings.registerBackSide = OneIn(2);
  settings.curvedSurface = OneIn(4);
  settings.weightBound = OneOf({ 16.0f, 1.0f, 2.5f, 0x1p20f });
  settings.maximumPathLength = OneOf({ 20u, 1u, 2u, 200u });
  settings.threads = 1 + Below(2);
  // Patches of arbitrary normals have hundreds of parts, each with many cells.
  const bool gathered = !settings.curvedSurface && OneIn(240);
  settings.method = gathered ? Method::FinalGathering : Method::PhotonTracing;
  settings.gatherRays = LeastGatherRays;
  return settings;
}

} // namespace

RandomScene DrawScene()
{
  const double size = OneIn(8) ? OneOf({ 1e-310, 1e-200, 1e-100, 1e100, 1e200, 1e300 })
                               : OneOf({ 1.0, 1.0, 1e-6, 1e6, 1e-30, 1e30 });
  const double far = size * OneOf({ 0.0, 0.0, 1.0, 1e3, 1e7 });
  const Site site{ size, far * glm::dvec3(1.0, -0.7, 0.3) };
  RandomScene scene;
  scene.surface = DrawSurface(site);
  scene.lighting = DrawLighting(scene.surface, site);
  scene.settings = DrawSettings();
  scene.photons = 512;
  return scene;
}

RandomScene DrawSceneWithMistake()
{
  RandomScene scene = DrawScene();
  if (OneIn(2))
  {
    SpoilSurface(scene);
    return scene;
  }
  // The surface is looked at before the lamp, so it must not be refused.
  scene.surface.points = { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 } };
  scene.surface.normals.resize(3);
  scene.surface.facets.assign(scene.surface.facets.size(), { 0, 1, 2 });
  SpoilLighting(scene);
  return scene;
}
