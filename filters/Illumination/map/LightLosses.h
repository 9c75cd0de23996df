// SPDX-License-Identifier: BSD-3-Clause
// By which rules light is said to be missing from a map.
#ifndef LightLosses_h
#define LightLosses_h

#include "PhotonTransport/transport/IlluminationRun.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace Illumination
{

class SceneBlocks;

/// What a filter has traced, and what its user calls it.
struct TracedScene
{
  const SceneBlocks& blocks;
  const PhotonTransport::Lighting& lighting;
  const PhotonTransport::IlluminationRun& run;
  bool backSide;        ///< Whether backs are registered.
  double metresPerUnit; ///< As it was set.
};

/// How most of the light of a lamp, or of scattered light, is lost; see MissingLight.
enum class Loss
{
  None,
  OnBacks,       ///< Of a lamp in the scene.
  Escaped,       ///< Of a lamp in the scene.
  OutsideClosed, ///< Light from outside fell on backs.
  OutsideMissed  ///< Light from outside met nothing.
};

/// All lamps that lost light in one way.
struct Lost
{
  PhotonTransport::ArrivedFlux sum;
  std::vector<std::size_t> lamps;
  std::size_t worst = 0; ///< Of the lamps.
};

/// For each lamp how it loses light.
std::vector<Loss> LossesByLamp(const TracedScene& traced);
Lost AllThatLost(Loss way, const std::vector<Loss>& losses, const TracedScene& traced);

/// Whether a lamp's light starts over the whole scene: parallel light and skies.
bool ComesFromOutside(const PhotonTransport::Luminaire& luminaire);

/// Of scattered light what fell on backs; nothing where backs are registered or let light through.
PhotonTransport::ShareOfLight ScatteredLightOnBacks(const TracedScene& traced);

/// What of a lamp's light met the surface, lm.
double MetBy(const PhotonTransport::ArrivedFlux& light);

/// 0 where the whole is.
double Share(double part, double whole);

} // namespace Illumination

#endif
