// SPDX-License-Identifier: BSD-3-Clause
#ifndef MovedLamp_h
#define MovedLamp_h

#include "Illumination/luminaires/GlyphMotion.h"

#include "PhotonTransport/lights/Lamp.h"

/// The lamp after the motion. Its place, axes and size are moved; its flux, or the illuminance of
/// the sun or a sky, stays, and so do a photometric lamp's intensities. Throws InputError for the
/// mirror image of a photometric lamp that is not its own.
PhotonTransport::Lamp Moved(const PhotonTransport::Lamp& lamp, const GlyphMotion& motion);

#endif
