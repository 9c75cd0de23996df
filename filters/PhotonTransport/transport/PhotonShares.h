// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/Emitter.h"
#include "PhotonTransport/transport/OpeningPhotons.h"

#include <vector>

namespace PhotonTransport
{

/// [source] Shares of the photons where light comes through openings, whose flux is a small part of
/// that of the sky: by their flux these sources would have hardly any photons. The shares are a
/// function of scene and lamps alone. A few photons of each source tell what they are good for:
/// - The Whole of lamps from afar, light outdoors, gets half of the photons, or less in proportion
/// to
///   how much of what meets the surface meets a side that registers; 1/16 at least, and no more
///   than its share of the flux.
/// - All other sources, which are parts through openings and lamps in the scene, have the rest
/// among
///   them in proportion to flux times root of the share of photons that bring light to a side that
///   registers: with these numbers the variance of all their light together is least. A part of
///   which no photon has done so gets 1/256.
/// - No photon counts by less than 2^-22, so that fixed-point sums hold it well.
std::vector<double> PhotonShares(const Scene& scene, const Emitter& source,
  const OpeningPhotons& openings, bool backSideRegisters);

/// [source] Shares for maps of each lamp. One in twenty photons is divided evenly between the lamps
/// that have a flux, so that each of them has photons enough for a map; all others are divided as
/// before. That takes at most one in twenty from any lamp, so that the variance of all light
/// together rises by at most 1/19, its error by 2.6 %. A photon counts by 2^-22 at least.
/// @param shares [source] As they were; empty: by flux.
std::vector<double> SharesForLampsApart(const Emitter& source, std::vector<double> shares);

} // namespace PhotonTransport
