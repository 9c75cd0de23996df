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

/// The motion that takes each point from where it was to where it is, within 0.1 % of the distance
/// between them: that is room for the rounding of coordinates and too little to see in the light.
/// Points on one plane or line are turned rather than mirrored. Throws InputError where no such
/// motion is.
/// @param was, is As many points each.
GlyphMotion FindMotion(const std::vector<glm::dvec3>& was, const std::vector<glm::dvec3>& is);

#endif
