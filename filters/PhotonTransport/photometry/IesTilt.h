// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/photometry/TextReader.h"

#include <string>

namespace PhotonTransport
{

/// The factor of a luminaire that is not tilted: 1 for NONE, else the tilt factor at 0 degrees,
/// from the lines that follow (INCLUDE) or from a file. Throws PhotometricFileError. @param tilt
/// What follows TILT=. @param folder In which the file is looked for.
double ReadIesTilt(TextReader& reader, const std::string& tilt, const std::string& folder);

} // namespace PhotonTransport
