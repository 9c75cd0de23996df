// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/gathering/Guide.h"

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{

void Guide::Set(std::size_t size, const std::vector<float>& values)
{
  // What is spread evenly over all cells, so that nothing is missed where the probe saw nothing: a
  // defensive mixture (Hesterberg, "Weighted Average Importance Sampling and Defensive Mixture
  // Distributions", Technometrics 37(2), 1995).
  constexpr float Defensive = 0.2f;
  this->Size = size;
  this->Smooth(values);
  float sum = 0.0f;
  for (const float share : this->Shares)
  {
    sum += share;
  }
  const auto cells = static_cast<float>(size * size);
  this->RowEnds.resize(size);
  this->Ends.resize(size * size);
  float upToRow = 0.0f;
  for (std::size_t row = 0; row < size; ++row)
  {
    float inRow = 0.0f;
    for (std::size_t column = 0; column < size; ++column)
    {
      float& share = this->Shares[row * size + column];
      share = sum > 0.0f ? Defensive / cells + (1.0f - Defensive) * share / sum : 1.0f / cells;
      inRow += share;
      this->Ends[row * size + column] = inRow;
    }
    for (std::size_t column = 0; column < size; ++column)
    {
      this->Ends[row * size + column] /= inRow;
    }
    upToRow += inRow;
    this->RowEnds[row] = upToRow;
  }
  for (float& end : this->RowEnds)
  {
    end /= upToRow;
  }
}

/// Root mean squares over neighbours, weighed 1, 1/2, 1/4: the least variance comes with a density
/// in proportion to the root mean square of the light (Rath et al., "Variance-Aware Path Guiding",
/// ACM TOG 39(4), 2020).
void Guide::Smooth(const std::vector<float>& values)
{
  const auto size = static_cast<std::ptrdiff_t>(this->Size);
  this->Shares.assign(values.size(), 0.0f);
  for (std::ptrdiff_t row = 0; row < size; ++row)
  {
    for (std::ptrdiff_t column = 0; column < size; ++column)
    {
      float squares = 0.0f;
      float weights = 0.0f;
      for (std::ptrdiff_t r = std::max<std::ptrdiff_t>(0, row - 1); r < std::min(size, row + 2);
           ++r)
      {
        for (std::ptrdiff_t c = std::max<std::ptrdiff_t>(0, column - 1);
             c < std::min(size, column + 2); ++c)
        {
          const float weight = (r == row ? 1.0f : 0.5f) * (c == column ? 1.0f : 0.5f);
          const float value = values[static_cast<std::size_t>(r * size + c)];
          squares += weight * value * value;
          weights += weight;
        }
      }
      this->Shares[static_cast<std::size_t>(row * size + column)] = std::sqrt(squares / weights);
    }
  }
}

/// The interval that holds a place, and how far within it the place is.
std::size_t Guide::Find(const float* ends, std::size_t count, float place, float& within)
{
  const float* end = std::upper_bound(ends, ends + count - 1, place);
  const float begin = end == ends ? 0.0f : end[-1];
  within = std::clamp((place - begin) / (*end - begin), 0.0f, 1.0f - 0x1p-24f);
  return static_cast<std::size_t>(end - ends);
}

GuidedPlace Guide::At(float u, float v) const
{
  glm::vec2 within;
  const std::size_t row = Find(this->RowEnds.data(), this->Size, u, within.x);
  const std::size_t column = Find(&this->Ends[row * this->Size], this->Size, v, within.y);
  const auto size = static_cast<float>(this->Size);
  return { { (static_cast<float>(row) + within.x) / size,
             (static_cast<float>(column) + within.y) / size },
    this->Shares[row * this->Size + column] * size * size };
}

} // namespace PhotonTransport
