// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <cstddef>

namespace PhotonTransport
{

/// How little a luminaire disturbs in a direction away from the line of sight: Guth's position
/// index, by the formula of the IES Lighting Handbook, 9th edition, chapter 9, which the table of
/// CIE 117:1995 is rounded from. It is 1 in the line of sight. Below the line of sight, where
/// neither says anything, it is that of the same place above.
/// @param direction Unit, to the luminaire. @param view, up Unit, at right angles.
/// @return 0 from a right angle to the line of sight on, where nothing is seen.
double PositionIndex(const glm::dvec3& direction, const glm::dvec3& view, const glm::dvec3& up);

/// The sum over luminaires in CIE 117's formula, L^2 omega / p^2, from samples.
struct GlareSum
{
  double sum = 0.0;
  double variance = 0.0;
};

struct GlareRating
{
  double ugr = 0.0;
  double standardError = 0.0;
};

/// The unified glare rating of CIE 117:1995, 8 lg(0.25 / Lb sum(L^2 omega / p^2)), within [0, 100]:
/// 0 where no luminaire with an area is seen, 100 at most where the surroundings are black.
/// @param glare In (cd/m^2)^2 sr. @param background Indirect illuminance at the eye, lx: pi Lb.
/// @param backgroundError Its standard error, lx.
GlareRating RatingOf(const GlareSum& glare, double background, double backgroundError);

} // namespace PhotonTransport
