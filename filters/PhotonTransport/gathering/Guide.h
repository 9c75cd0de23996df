// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec2.hpp>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace PhotonTransport
{

/// A place of the unit square, and its density there.
struct GuidedPlace
{
  glm::vec2 place;
  float density;
};

/// Where in the square of cosine-distributed directions light comes from, as it was found by one
/// value in each cell of a grid. It is used to draw directions with a density that follows the
/// values, and is nowhere below a fifth, since a single value tells little of its cell.
class Guide
{
public:
  /// @param size Cells along each side. @param values [row][column] >= 0.
  void Set(std::size_t size, const std::vector<float>& values);

  /// Well spread numbers give well spread places: the first decides the row, the second the column.
  /// @param u, v In [0, 1).
  GuidedPlace At(float u, float v) const;

  /// The density with which At draws a place; 1 on average over the square.
  float DensityAt(const glm::vec2& place) const
  {
    const auto size = static_cast<float>(this->Size);
    const auto cell = [&](float x)
    { return std::min(static_cast<std::size_t>(std::max(0.0f, x) * size), this->Size - 1); };
    return this->Shares[cell(place.x) * this->Size + cell(place.y)] * size * size;
  }

private:
  void Smooth(const std::vector<float>& values);
  static std::size_t Find(const float* ends, std::size_t count, float place, float& within);

  std::size_t Size = 0;
  std::vector<float> Shares;  ///< [row][column] Of all light; sum 1.
  std::vector<float> RowEnds; ///< Sums of rows up to and with each row, the last 1.
  std::vector<float> Ends;    ///< [row][column] The same within each row, its last 1.
};

} // namespace PhotonTransport
