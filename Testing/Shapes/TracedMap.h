// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/transport/IlluminationRun.h"

#include <array>
#include <memory>
#include <vector>

/// How many facets a hit registers on at most: 1, unless some lie in one place and face the same
/// way.
std::size_t MostFacetsInOnePlace(const PhotonTransport::Scene& scene);

/// A whole run to a number of photons. It expects a sound result: photons balance, all values are
/// finite and not below 0, and photon tracing registers no more flux than arrived times the weight
/// bound, on each facet in one place.
class TracedMap
{
public:
  /// The scene must outlive this. @param openings See IlluminationRun.
  TracedMap(const PhotonTransport::Scene& scene, const PhotonTransport::Lighting& lighting,
    const PhotonTransport::TraceSettings& settings, std::uint64_t photons,
    const PhotonTransport::Openings& openings = {});
  /// In a scene of its own.
  TracedMap(const PhotonTransport::Surface& surface, const PhotonTransport::Lighting& lighting,
    const PhotonTransport::TraceSettings& settings, std::uint64_t photons);

private:
  using ScenePointer = std::shared_ptr<const PhotonTransport::Scene>;
  TracedMap(const ScenePointer& scene, const PhotonTransport::Lighting& lighting,
    const PhotonTransport::TraceSettings& settings, std::uint64_t photons,
    const PhotonTransport::Openings& openings);

  ScenePointer Owned;

public:
  const PhotonTransport::Scene& scene;
  PhotonTransport::IlluminationMap front, back;     ///< No back unless the settings register it.
  std::vector<std::array<double, 3>> frontByColour; ///< lx; empty unless there are colours.
  std::vector<std::vector<double>> frontOfLamps;    ///< lx; empty unless lamps are kept apart.
  PhotonTransport::PhotonBalance balance;
  PhotonTransport::Effects effects;
  double fluxCut = 0.0; ///< By the weight bound, lm.
  double flux = 0.0;    ///< Of the lamps, lm.
  double fluxMet = 0.0; ///< Of light that met the surface, each time it did, lm.

  /// sum A E of a side, lm.
  double RegisteredFlux(const PhotonTransport::IlluminationMap& side) const;
  /// Standard error of RegisteredFlux(front) as if vertices were independent, which is too small by
  /// less than sqrt(3), lm.
  double FluxError() const;
  /// Whether all that the photons have left behind is the same to the last bit.
  bool HasTheBitsOf(const TracedMap& other) const;

private:
  void ExpectSound(const PhotonTransport::IlluminationMap& side) const;
  void ExpectFluxWithinBounds(const PhotonTransport::TraceSettings& settings) const;
};
