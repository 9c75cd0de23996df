// SPDX-License-Identifier: BSD-3-Clause
#ifndef OpeningLines_h
#define OpeningLines_h

#include "PhotonTransport/openings/FindOpenings.h"
#include "PhotonTransport/scene/Scene.h"

#include <string>
#include <vector>

namespace Illumination
{

/// The openings in words. The first line says how many are used, with the area, the centre and the
/// kind of the largest, such as "openings used: 2 (4.5 m^2 in all): 2.5 m^2 at (4, 2, 1.65), a hole
/// of the mesh; 2 m^2 at (0, 2, 1.65), a pane". Another line says what was found and is not used,
/// and why, if there is any. Centres are in the data's unit.
/// @param tellsOfNone Whether there is a line also where no opening is used.
std::vector<std::string> OpeningLines(const PhotonTransport::FoundOpenings& found,
  const PhotonTransport::Scene& scene, bool tellsOfNone);

} // namespace Illumination

#endif
