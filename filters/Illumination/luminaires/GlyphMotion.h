// SPDX-License-Identifier: BSD-3-Clause
// How a set of points was moved, from where they were and where they are.
#ifndef GlyphMotion_h
#define GlyphMotion_h

#include "PhotonTransport/geometry/Similarity.h"

#include <vector>

namespace Illumination
{

/// The motion that takes each point from where it was to where it is. No point may be off by more
/// than 0.1 % of the largest distance of a point from the first one: that is room for the rounding
/// of coordinates, and too little to be seen in the light. Where a rotation and a mirror image fit
/// equally well, as for points on a plane or a line, the rotation is taken. Throws InputError if no
/// such motion fits.
/// @param was, is As many points each.
PhotonTransport::Similarity FindMotion(
  const std::vector<glm::dvec3>& was, const std::vector<glm::dvec3>& is);

} // namespace Illumination

#endif
