// SPDX-License-Identifier: BSD-3-Clause
#ifndef LuminaireNames_h
#define LuminaireNames_h

#include "PhotonTransport/lights/Lamp.h"

#include <vector>

namespace Illumination
{

/// Makes names unique and not blank, such as "Lamp 2" and "Spot (2)". The first luminaire with a
/// given name keeps it.
void GiveNames(std::vector<PhotonTransport::Luminaire>& luminaires);

} // namespace Illumination

#endif
