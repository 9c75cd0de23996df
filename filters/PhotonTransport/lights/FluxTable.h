// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace PhotonTransport
{

/// Chooses among many, each as often as its share of the whole. A larger number never chooses an
/// earlier one, so that well spread numbers give well spread choices.
class FluxTable
{
public:
  FluxTable() = default;

  /// @param fluxes >= 0, their sum above 0.
  explicit FluxTable(const std::vector<double>& fluxes)
  {
    double sum = 0.0;
    for (const double flux : fluxes)
    {
      sum += flux;
      this->Cumulative.push_back(sum);
    }
    for (double& value : this->Cumulative)
    {
      value /= sum;
    }
    std::uint32_t chosen = 0;
    const std::size_t parts = fluxes.size();
    for (std::size_t part = 0; part < parts; ++part)
    {
      const double start = static_cast<double>(part) / static_cast<double>(parts);
      while (chosen + 1 < parts && this->Cumulative[chosen] <= start)
      {
        ++chosen;
      }
      this->FirstOfPart.push_back(chosen);
    }
  }

  /// @param place In [0, 1).
  std::size_t At(double place) const
  {
    const auto parts = static_cast<double>(this->Cumulative.size());
    std::size_t chosen = this->FirstOfPart[static_cast<std::size_t>(place * parts)];
    while (chosen + 1 < this->Cumulative.size() && this->Cumulative[chosen] <= place)
    {
      ++chosen;
    }
    return chosen;
  }

  /// The slice of [0, 1) for which At() chooses this one begins and ends here.
  double Begin(std::size_t chosen) const
  {
    return chosen == 0 ? 0.0 : this->Cumulative[chosen - 1];
  }
  double End(std::size_t chosen) const { return this->Cumulative[chosen]; }

private:
  std::vector<double> Cumulative; ///< Of the shares, the last 1.
  /// [0, 1) has as many equal parts as there are choices; this is the first choice in each part. A
  /// search that starts there takes at most one step on average (the guide table of Chen and Asau,
  /// "On Generating Random Variates from an Empirical Distribution", 1974).
  std::vector<std::uint32_t> FirstOfPart;
};

} // namespace PhotonTransport
