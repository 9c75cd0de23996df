// SPDX-License-Identifier: BSD-3-Clause
#ifndef MovedLamp_h
#define MovedLamp_h

#include "Illumination/luminaires/GlyphMotion.h"

#include "PhotonTransport/lights/Lamp.h"

/// The lamp after the motion, which changes its place, axes and size. Its flux, the illuminance of
/// the sun or a sky and the intensities of a photometric lamp stay. Throws InputError if a motion
/// mirrors a photometric lamp whose intensities are symmetric neither left and right nor fore and
/// aft.
PhotonTransport::Lamp Moved(const PhotonTransport::Lamp& lamp, const GlyphMotion& motion);

#endif
