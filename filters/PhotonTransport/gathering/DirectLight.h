// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/gathering/LampChoice.h"
#include "PhotonTransport/gathering/LightSampler.h"
#include "PhotonTransport/gathering/Receiver.h"
#include "PhotonTransport/lights/Emitter.h"
#include "PhotonTransport/materials/FacetRoulettes.h"
#include "PhotonTransport/scene/Scene.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace PhotonTransport
{

/// Light of a place of a lamp as it has arrived at a receiver.
struct ArrivedLight
{
  glm::vec3 towards; ///< Unit, to the place.
  float distance;    ///< To it, scene units; infinity from afar.
  std::uint32_t lamp;
  /// One of two samples that follow each other and whose difference tells their error: the variance
  /// of any sum over them is on average the square of the difference of what they add to it.
  bool paired;
  double light;     ///< Its part of the sum, in the units of DirectResult.
  double luminance; ///< Of the place as it is seen, light per steradian; 0 if it has no area.
};

/// Direct light at one receiver, lx by channel: the sum of a colour's components is the
/// illuminance, and without colour all of it is in the first.
struct DirectResult
{
  std::vector<Colour> ofLamp;
  double variance = 0.0; ///< lx^2, of the sum over all lamps: an estimate without bias.
  /// At a receiver in free space: all that adds up to its light, so that each direction can be
  /// weighed as wanted.
  std::vector<ArrivedLight> arrived;
};

/// The light that comes to a point straight from lamps, through clear panes too, by shadow rays to
/// places on the lamps (next-event estimation; Shirley, Wang and Zimmerman, "Monte Carlo Techniques
/// for Direct Lighting Calculations", ACM TOG 15(1), 1996). Skies are left to rays that escape; see
/// SkyRadiance.
class DirectLight
{
public:
  /// All arguments must outlive this.
  /// @param materials May be empty where no facet lets light through.
  /// @param switchedOn Scatterings that are simulated. @param luxPerUnit All light is given in
  /// units of so many lx, > 0, in which single precision must hold it.
  DirectLight(const Scene& scene, const Emitter& emitter, const FacetRoulettes& materials,
    ScatteringSet switchedOn, double luxPerUnit = 1.0)
    : Sampler(scene, emitter, materials, switchedOn, luxPerUnit)
  {
  }

  std::size_t Lamps() const { return this->Sampler.Pieces().Source().Lamps(); }

  /// Every estimate is without bias. A point-like lamp and the sun get one ray and have no
  /// variance. Up to MostApart pieces are sampled one by one. More are drawn by about how bright
  /// they are here, so that the cost stays bounded.
  /// Where most of a piece is seen whose light has a closed form, rays tell what is missing: that
  /// is exact where all of it is seen, and may come out a little below 0 where rays to its outline
  /// pass and most of its middle is hidden.
  /// @param samples Shadow rays to a piece where it is hidden in part, >= 4; a quarter where rays
  /// to its outline find that it is not. For more than MostApart pieces four times as many for all.
  /// @param index Of the receiver: the result is a function of this and the seed alone.
  void At(const Receiver& receiver, unsigned samples, std::uint32_t seed, std::uint64_t index,
    DirectResult& result) const;

  /// One sample, without bias, of the light of all lamps. @param number In [0, 1).
  /// @param lamp Gets the lamp that was chosen.
  Colour Sample(const Receiver& receiver, double number, std::uint32_t& lamp) const
  {
    return SampleOfAllLamps(this->Sampler, receiver, number, lamp);
  }

  bool HasOthersThanSkies() const
  {
    const LightPieces& pieces = this->Sampler.Pieces();
    return !pieces.Near().empty() || !pieces.FromAfar().empty();
  }
  bool HasSky() const { return !this->Sampler.Pieces().Skies().empty(); }

  /// The radiance of all skies in a direction from the point, by channel: its integral times the
  /// cosine is lx. @param ofLamp If given, is called with each sky's lamp and radiance.
  Colour SkyRadiance(const glm::vec3& towards,
    const std::function<void(std::uint32_t lamp, const Colour& radiance)>& ofLamp = {}) const;

  static constexpr std::size_t MostApart = 16;

private:
  struct Task;
  struct Outline;
  void AddPointLike(const Task& task, DirectResult& result) const;
  void AddPiece(Task& task, const LightPiece& piece, DirectResult& result) const;
  Outline LookAtOutline(const Task& task, const LightPiece& piece) const;
  void Keep(const std::optional<LightSample>& sample, const Colour& transmittance, double share,
    DirectResult& result) const;
  template <class Draw>
  void AddPairs(
    Task& task, unsigned pairs, bool stopped, const Draw& draw, DirectResult& result) const;

  LightSampler Sampler;
};

} // namespace PhotonTransport
