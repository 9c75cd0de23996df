// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace PhotonTransport
{

/// What two triangles have in common is a sliver if it is no wider, relative to their reach:
/// neighbours in a plane that is tilted, or of points that once were floats far from their origin,
/// overlap by less.
constexpr float SliverWidth = 0x1p-17f;

/// A facet seen along one of the three axes, counter-clockwise.
struct PlaneTriangle
{
  /// @param axis Which coordinate to leave out.
  PlaneTriangle(
    std::uint32_t facet, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, int axis);

  std::uint32_t facet;
  bool turned; ///< Corners are in the order a, c, b.
  glm::vec2 corners[3];
  glm::vec2 low, high; ///< Bounds.
  float reach;         ///< Largest coordinate of a corner; its rounding is relative to this.
  /// By how much the data's rounding may widen what it has in common with a neighbour.
  float rounding = 0.0f;
};

/// The axis along which a plane with this normal shows the largest part of its area.
int BestAxis(const glm::vec3& normal);

/// Whether two triangles have more in common than a sliver. Neighbours may have a sliver in common
/// by rounding.
bool Meet(const PlaneTriangle& one, const PlaneTriangle& other);

/// The convex polygon that two triangles have in common, and its area.
struct CommonPart
{
  std::vector<glm::dvec2> corners;
  double area = 0.0;
};
CommonPart Intersection(const PlaneTriangle& one, const PlaneTriangle& other);

/// Finds the triangles near another one without looking at all of them: a grid of cells lists the
/// triangles that touch each cell.
class TriangleGrid
{
public:
  /// @param members Indices of triangles. @param triangles Must outlive this.
  TriangleGrid(
    const std::vector<PlaneTriangle>& triangles, const std::vector<std::uint32_t>& members);

  /// Calls f(index) once for each member that may meet a triangle, until f returns true.
  /// @return Whether f did.
  template <typename F>
  bool AnyNear(const PlaneTriangle& triangle, const F& f)
  {
    ++this->Query;
    return this->AnyCell(triangle,
      [&](std::size_t cell)
      {
        for (std::size_t i = this->Offsets[cell]; i < this->Offsets[cell + 1]; ++i)
        {
          const std::uint32_t member = this->Members[i];
          if (this->Seen[member] != this->Query)
          {
            this->Seen[member] = this->Query;
            if (f(member))
            {
              return true;
            }
          }
        }
        return false;
      });
  }

private:
  /// Calls f(cell) for the cells that a triangle touches, until f returns true.
  template <typename F>
  bool AnyCell(const PlaneTriangle& triangle, const F& f) const
  {
    const std::pair<int, int> rows = this->RangeOf(triangle.low.y, triangle.high.y, 1);
    const std::pair<int, int> bounds = this->RangeOf(triangle.low.x, triangle.high.x, 0);
    // Bounds are quick to find, and of few cells they are hardly more than the triangle touches.
    const bool small = rows.second - rows.first < 2 || bounds.second - bounds.first < 2;
    for (int row = rows.first; row <= rows.second; ++row)
    {
      const std::pair<int, int> columns = small ? bounds : this->ColumnsOf(triangle, row);
      for (int column = columns.first; column <= columns.second; ++column)
      {
        if (f(static_cast<std::size_t>(row) * static_cast<std::size_t>(this->Size) +
              static_cast<std::size_t>(column)))
        {
          return true;
        }
      }
    }
    return false;
  }
  /// First and last cell of a range along an axis, within the grid; (0, -1) for a range outside it.
  std::pair<int, int> RangeOf(float low, float high, int axis) const
  {
    // Rounding must not lose a cell.
    constexpr float Reserve = 0x1p-10f;
    const float last = static_cast<float>(this->Size - 1);
    const float first = (low - this->Low[axis]) * this->CellsPerUnit[axis] - Reserve;
    const float end = (high - this->Low[axis]) * this->CellsPerUnit[axis] + Reserve;
    if (!(first <= last + 1.0f && end >= 0.0f))
    {
      return { 0, -1 };
    }
    return { static_cast<int>(std::clamp(first, 0.0f, last)),
      static_cast<int>(std::clamp(end, 0.0f, last)) };
  }
  /// First and last cell of a row that a triangle touches.
  std::pair<int, int> ColumnsOf(const PlaneTriangle& triangle, int row) const;

  int Size = 1; ///< Cells along each side.
  glm::vec2 Low, Cell, CellsPerUnit;
  std::vector<std::size_t> Offsets;
  std::vector<std::uint32_t> Members;
  std::vector<std::uint32_t> Seen; ///< The last query that met it.
  std::uint32_t Query = 0;
};

} // namespace PhotonTransport
