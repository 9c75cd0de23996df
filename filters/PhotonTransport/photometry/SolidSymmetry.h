// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/photometry/PhotometricSolid.h"

namespace PhotonTransport
{

/// Adds what is mirrored at the last azimuth.
void MirrorAtLastAzimuth(PhotometricSolid& solid);

/// Adds what is mirrored at the first azimuth.
void MirrorAtFirstAzimuth(PhotometricSolid& solid);

/// Adds what is mirrored at the last polar angle, 90 degrees.
void MirrorAtEquator(PhotometricSolid& solid);

/// Repeats the first plane after a full turn, unless the last one is that already; a single plane
/// makes a solid of revolution.
void CloseCircle(PhotometricSolid& solid);

/// Whether the gap from the last azimuth to a full turn after the first is one step of many: no
/// wider than the widest step.
bool GapIsOneStep(const std::vector<double>& azimuth);

} // namespace PhotonTransport
