// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/photometry/PhotometricSolid.h"

namespace PhotonTransport
{

/// Adds the mirror image of all planes at the last azimuth.
void MirrorAtLastAzimuth(PhotometricSolid& solid);

/// Adds the mirror image of all planes at the first azimuth.
void MirrorAtFirstAzimuth(PhotometricSolid& solid);

/// Adds the mirror image of all polar angles at the last one, which must be 90 degrees.
void MirrorAtEquator(PhotometricSolid& solid);

/// Repeats the first plane after a full turn, unless the last plane is there already. A single
/// plane becomes a solid of revolution.
void CloseCircle(PhotometricSolid& solid);

/// Whether the gap from the last azimuth to a full turn after the first is no wider than the widest
/// step between the others (up to 1 %, for rounded angles).
bool GapIsOneStep(const std::vector<double>& azimuth);

} // namespace PhotonTransport
