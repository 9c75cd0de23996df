// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace PhotonTransport
{

/// A flat rectangle as it is seen from a point. Its places are drawn with even density by solid
/// angle. Urena, Fajardo and King, "An Area-Preserving Parametrization for Spherical Rectangles",
/// EGSR 2013.
class SphericalRectangle
{
public:
  /// In the rectangle's own axes. @param corner The least corner, as seen from the point at the
  /// origin; its z is the distance of the plane and not 0. @param size > 0.
  SphericalRectangle(const glm::dvec3& corner, const glm::dvec2& size);

  double SolidAngle() const { return this->Angle; }

  /// x and y of a place in the rectangle. @param u, v In [0, 1).
  glm::dvec2 Place(double u, double v) const;

private:
  double X0, X1, Y0, Y1; ///< Of the edges.
  double Z;              ///< Of the plane, below 0.
  double B0, B1;         ///< z of the normals of the planes through the point and the edges in x.
  double K;              ///< 2 pi less two of the angles.
  double Angle;
};

} // namespace PhotonTransport
