// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/filtration/ScaleSelection.h"

#include <vector>

namespace PhotonTransport
{

// What stands in for the groups where they are not known: noise is drawn that is like photon noise,
// so that the selection of widths can measure what each width leaves of it. Groups are better: they
// know direct and indirect light apart, and noise that is correlated otherwise.

/// Four estimates with the values as their mean that differ by noise of a given standard error,
/// correlated between neighbours as hits are that three vertices share.
GroupColumns GroupsFromStandardError(const SmoothingGraph& graph, const std::vector<double>& values,
  const std::vector<double>& standardError);

/// The standard error of a map that nothing is known about, from its roughness: takes fine detail
/// for noise. Assumes noise that falls with the vertex area as photon noise does.
std::vector<double> StandardErrorFromRoughness(
  const SmoothingGraph& graph, const std::vector<double>& values, const FiltrationMonitor& monitor);

} // namespace PhotonTransport
