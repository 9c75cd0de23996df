// SPDX-License-Identifier: BSD-3-Clause
// How a set of points was moved, from where they were and where they are.
#ifndef GlyphMotion_h
#define GlyphMotion_h

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>

#include <vector>

/// A rotation, a translation, a uniform scale, and perhaps a mirror image.
struct GlyphMotion
{
  bool isNone = true;       ///< Every point is where it was, to the last bit.
  bool mirrors = false;     ///< Left and right change places.
  double scale = 1.0;       ///< > 0.
  glm::dmat3 turn{ 1.0 };   ///< Orthogonal.
  glm::dvec3 before{ 0.0 }; ///< One point ...
  glm::dvec3 after{ 0.0 };  ///< ... and where it went.

  glm::dvec3 Direction(const glm::dvec3& v) const { return this->turn * v; }
  glm::dvec3 Point(const glm::dvec3& p) const
  {
    return this->after + this->scale * (this->turn * (p - this->before));
  }
};

/// The motion that takes each point from where it was to where it is. No point may be off by more
/// than 0.1 % of the largest distance of a point from the first one: that is room for the rounding
/// of coordinates, and too little to be seen in the light. Where a rotation and a mirror image fit
/// equally well, as for points on a plane or a line, the rotation is taken. Throws InputError if no
/// such motion fits.
/// @param was, is As many points each.
GlyphMotion FindMotion(const std::vector<glm::dvec3>& was, const std::vector<glm::dvec3>& is);

#endif
