// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/photometry/TextReader.h"

#include <string>

namespace PhotonTransport
{

/// The factor of a luminaire that is not tilted. @param tilt What follows TILT=. @param folder
/// Where its file is, if it names one.
double ReadIesTilt(TextReader& reader, const std::string& tilt, const std::string& folder);

} // namespace PhotonTransport
