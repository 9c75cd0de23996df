// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/openings/PolygonTriangles.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace PhotonTransport
{
namespace
{

/// Relative to the extent, or its square for areas.
constexpr double Straight = 1e-7;
/// How far the triangles' area may be off the polygon's.
constexpr double AreaTolerance = 1e-5;

/// Clips ears (Meisters, "Polygons Have Ears", 1975) off a polygon.
class EarClipping
{
public:
  EarClipping(const std::vector<glm::dvec3>& corners, const glm::dvec3& normal)
    : Normal(normal)
    , Rest(corners)
  {
    for (const glm::dvec3& corner : corners)
    {
      this->Extent = std::max(this->Extent, glm::distance(corner, corners.front()));
    }
    this->Area = this->AreaOfRest();
    this->LeaveOutStraight();
    for (std::size_t i = 0; i < this->Rest.size(); ++i)
    {
      const auto corner = static_cast<std::ptrdiff_t>(i);
      if (!(this->TwiceArea(this->At(corner, -1), this->Rest[i], this->At(corner, 1)) > 0.0))
      {
        this->Inward.push_back(this->Rest[i]);
      }
    }
  }

  std::vector<TriangleCorners> Triangles()
  {
    double clipped = 0.0;
    std::vector<TriangleCorners> triangles;
    while (this->Rest.size() >= 3 && this->FindEar())
    {
      const TriangleCorners ear{ this->At(this->Ear, -1), this->At(this->Ear, 0),
        this->At(this->Ear, 1) };
      const double area = this->TwiceArea(ear[0], ear[1], ear[2]) / 2.0;
      clipped += area;
      if (area > 0.0)
      {
        triangles.push_back(ear);
      }
      this->Rest.erase(this->Rest.begin() + this->Ear);
    }
    const bool whole = std::fabs(clipped - this->Area) <= AreaTolerance * this->Area;
    return whole ? triangles : std::vector<TriangleCorners>{};
  }

private:
  const glm::dvec3& At(std::ptrdiff_t i, std::ptrdiff_t step) const
  {
    const auto size = static_cast<std::ptrdiff_t>(this->Rest.size());
    return this->Rest[static_cast<std::size_t>((i + step + size) % size)];
  }

  double TwiceArea(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const
  {
    return glm::dot(this->Normal, glm::cross(b - a, c - a));
  }

  double AreaOfRest() const
  {
    double area = 0.0;
    for (std::size_t i = 2; i < this->Rest.size(); ++i)
    {
      area += 0.5 * this->TwiceArea(this->Rest.front(), this->Rest[i - 1], this->Rest[i]);
    }
    return area;
  }

  /// Corners on a line through those beside them, on it or back along it, until none is left.
  void LeaveOutStraight()
  {
    std::size_t kept = 0; // since the last one that was left out
    for (std::ptrdiff_t i = 0; kept < this->Rest.size() && this->Rest.size() > 3;)
    {
      const glm::dvec3 a = this->At(i, -1), b = this->At(i, 0), c = this->At(i, 1);
      const double longest = std::max(glm::distance(a, b), glm::distance(b, c));
      if (std::fabs(this->TwiceArea(a, b, c)) <= Straight * this->Extent * longest)
      {
        this->Rest.erase(this->Rest.begin() + i);
        i = std::max<std::ptrdiff_t>(0, i - 1);
        kept = 0;
      }
      else
      {
        ++kept;
        ++i;
      }
      i %= static_cast<std::ptrdiff_t>(this->Rest.size());
    }
  }

  /// Whether a corner lies in a triangle without being one of its corners. If any does, one does at
  /// which the polygon turns inwards.
  bool HasCornerIn(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const
  {
    return std::any_of(this->Inward.begin(), this->Inward.end(),
      [&](const glm::dvec3& p)
      {
        return p != a && p != b && p != c && this->TwiceArea(a, b, p) >= 0.0 &&
          this->TwiceArea(b, c, p) >= 0.0 && this->TwiceArea(c, a, p) >= 0.0;
      });
  }

  /// Finds a corner whose neighbours see each other, the first after the last ear's place.
  bool FindEar()
  {
    const auto size = static_cast<std::ptrdiff_t>(this->Rest.size());
    const std::ptrdiff_t first = this->Ear % size;
    for (std::ptrdiff_t step = 0; step < size; ++step)
    {
      this->Ear = (first + step) % size;
      const glm::dvec3 &a = this->At(this->Ear, -1), &b = this->At(this->Ear, 0),
                       &c = this->At(this->Ear, 1);
      const double area = this->TwiceArea(a, b, c);
      if (area == 0.0 || (area > 0.0 && !this->HasCornerIn(a, b, c)))
      {
        return true;
      }
    }
    return false;
  }

  glm::dvec3 Normal;
  std::vector<glm::dvec3> Rest;
  std::vector<glm::dvec3> Inward; ///< Corners at which the polygon turns clockwise.
  std::ptrdiff_t Ear = 0;
  double Extent = 0.0;
  double Area = 0.0;
};

} // namespace

std::vector<TriangleCorners> TrianglesOfPolygon(
  const std::vector<glm::dvec3>& corners, const glm::dvec3& normal)
{
  return EarClipping(corners, normal).Triangles();
}

} // namespace PhotonTransport
