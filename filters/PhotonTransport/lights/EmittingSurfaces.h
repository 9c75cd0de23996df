// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/lights/PrepareEmitter.h"

namespace PhotonTransport
{

// Surfaces that shine, made ready; see PrepareEmitter.

PreparedEmitter Prepare(const EmittingFacets& lamp, const Scene& scene);
PreparedEmitter Prepare(const EmittingMesh& lamp, const Scene& scene);

} // namespace PhotonTransport
