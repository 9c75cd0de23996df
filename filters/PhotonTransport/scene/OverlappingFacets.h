// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/scene/FacetOverlap.h"

#include <functional>

namespace PhotonTransport
{

/// Calls f for all pairs of facets that overlap; for some of them more than once. Pairs that are
/// not in one plane are found up to MostExcess, or up to 1024 where the rounding to single
/// precision would explain how far they are apart; not all of them are found.
///
/// A floor of many facets is looked through in linear time: facets that are joined along all their
/// edges can't overlap each other unless others do at the outline, see Outline.
void ForEachOverlap(const FacetPlaces& places, const std::function<void(const FacetOverlap&)>& f);

} // namespace PhotonTransport
