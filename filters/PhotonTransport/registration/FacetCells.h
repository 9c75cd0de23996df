// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec3.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

class Scene;

/// Divides facets into cells, so that light on them is known as finely as it varies, whatever mesh
/// the user gives. A cell is found from barycentric coordinates alone: cells need no points and no
/// rays see them. A facet falls into strips along its longest edge, and each strip into as many
/// cells.
class FacetCells
{
public:
  /// @param lengths Of cells at most, one a facet, scene units, > 0. @param most Cells are made
  /// longer, all by the same factor, until there are no more of them, or one a facet.
  FacetCells(const Scene& scene, const std::vector<float>& lengths, std::size_t most);

  /// So many cells suffice for the second pass of a scene of so many facets: 2^18 beyond one a
  /// facet.
  static constexpr std::size_t MostFor(std::size_t facets)
  {
    return facets + (std::size_t{ 1 } << 18);
  }

  std::size_t Number() const { return this->All; }

  /// @param barycentric Within the facet.
  std::uint32_t At(std::uint32_t facet, const glm::vec3& barycentric) const
  {
    const Division& division = this->Divisions[facet];
    if (division.columns * division.strips == 1)
    {
      return division.first;
    }
    const float height = barycentric[division.apex];
    const float along = barycentric[division.apex == 2 ? 0 : division.apex + 1];
    const unsigned strip = Interval(height, division.strips);
    const unsigned column = Interval(along / std::max(1e-12f, 1.0f - height), division.columns);
    return division.first + strip * division.columns + column;
  }

  /// Calls f(cell, share of the facet's area) for each cell of a facet.
  template <typename Function>
  void ForEachOf(std::uint32_t facet, const Function& f) const
  {
    const Division& division = this->Divisions[facet];
    std::uint32_t cell = division.first;
    for (unsigned strip = 0; strip < division.strips; ++strip)
    {
      // The part of the facet above a height is similar to the whole.
      const double below = 1.0 - static_cast<double>(strip) / division.strips;
      const double above = 1.0 - static_cast<double>(strip + 1) / division.strips;
      const double share = (below - above) * (below + above) / division.columns;
      for (unsigned column = 0; column < division.columns; ++column, ++cell)
      {
        f(cell, share);
      }
    }
  }

  /// The facet of a cell.
  std::uint32_t FacetOf(std::uint32_t cell) const
  {
    const auto after = std::upper_bound(this->Divisions.begin(), this->Divisions.end(), cell,
      [](std::uint32_t c, const Division& division) { return c < division.first; });
    return static_cast<std::uint32_t>(after - this->Divisions.begin() - 1);
  }

  /// The facet's barycentric coordinates of a point of a cell, uniform over it for uniform numbers.
  /// @param u, v In [0, 1).
  glm::vec3 PointIn(std::uint32_t facet, std::uint32_t cell, float u, float v) const;

  /// The longest side of a cell, scene units; 0 unless it was made from a scene.
  float Length(std::uint32_t facet) const { return this->Divisions[facet].length; }

private:
  struct Division
  {
    std::uint32_t first = 0; ///< Cell.
    std::uint16_t strips = 1;
    std::uint16_t columns = 1;
    float length = 0.0f;
    std::uint8_t apex = 0; ///< The corner opposite to the longest edge.
  };

  static unsigned Interval(float place, unsigned intervals)
  {
    return std::min(
      static_cast<unsigned>(place * static_cast<float>(intervals)), intervals - 1); // place >= 0
  }
  static Division Divide(const Scene& scene, std::uint32_t facet, float length);

  std::vector<Division> Divisions;
  std::size_t All = 0;
};

} // namespace PhotonTransport
