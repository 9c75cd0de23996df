// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <glm/vec2.hpp>

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

  /// Cells along each side.
  std::size_t Side() const { return this->Size; }
  /// How much of all light comes from a cell; 1 in sum. @param cell row * Side() + column.
  float ShareOf(std::size_t cell) const { return this->Shares[cell]; }

private:
  void Smooth(const std::vector<float>& values);
  static std::size_t Find(const float* ends, std::size_t count, float place, float& within);

  std::size_t Size = 0;
  std::vector<float> Shares;  ///< [row][column] Of all light; sum 1.
  std::vector<float> RowEnds; ///< Sums of rows up to and with each row, the last 1.
  std::vector<float> Ends;    ///< [row][column] The same within each row, its last 1.
};

} // namespace PhotonTransport
