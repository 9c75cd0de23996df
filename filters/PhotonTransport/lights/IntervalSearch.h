// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// Finds the interval of a rising list that holds a value. The list's range has four equal parts
/// for each interval, and each part knows the first interval that reaches into it, so that a search
/// takes a step or none where the intervals are about alike.
class IntervalSearch
{
public:
  IntervalSearch() = default;

  /// @param edges Rising, at least two.
  explicit IntervalSearch(const std::vector<double>& edges)
    : Edges(edges)
    , Parts(4 * (edges.size() - 1))
    , PartsPerUnit(static_cast<double>(this->Parts) / (edges.back() - edges.front()))
  {
    std::uint32_t first = 1;
    for (std::size_t part = 0; part < this->Parts; ++part)
    {
      this->FirstOfPart.push_back(first);
      while (first + 1 < edges.size() && this->PartOf(edges[first]) <= part)
      {
        ++first;
      }
    }
  }

  /// The end of the interval, an index of the list: the first edge above the value, but neither the
  /// first edge of all nor beyond the last.
  std::size_t EndOf(double value) const
  {
    std::size_t end = this->FirstOfPart[this->PartOf(value)];
    while (end + 1 < this->Edges.size() && this->Edges[end] <= value)
    {
      ++end;
    }
    return end;
  }

private:
  std::size_t PartOf(double value) const
  {
    const double place = (value - this->Edges.front()) * this->PartsPerUnit;
    return std::min(this->Parts - 1, static_cast<std::size_t>(std::max(0.0, place)));
  }

  std::vector<double> Edges;
  std::size_t Parts = 0;
  double PartsPerUnit = 0.0;
  std::vector<std::uint32_t> FirstOfPart;
};

} // namespace PhotonTransport
