// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "PhotonTransport/filtration/Columns.h"
#include "PhotonTransport/filtration/FiltrationMonitor.h"
#include "PhotonTransport/filtration/SmoothingGraph.h"

#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace PhotonTransport
{

/// A function p of M = A^-1 L, L the graph's Laplacian, as a polynomial: x -> p(M) x. Since p(0) =
/// 1, constants stay and sum(A x) is conserved on every patch; since the polynomial is fixed, the
/// filter is linear and its result depends on no thread and no tolerance of a solver.
class SpectralFilter
{
public:
  /// @param response p(eigenvalue) over [0, SmoothingGraph::LargestEigenvalue], smooth, p(0) = 1.
  explicit SpectralFilter(const std::function<double(double)>& response);

  /// exp(-t M): the light spreads as heat does in time t, to a kernel of standard deviation
  /// sqrt(2 t) in units of the distance between vertices.
  static SpectralFilter Heat(double t);
  /// 2 exp(-t M) - exp(-2 t M), "twicing" (Tukey, "Exploratory Data Analysis", 1977): what the heat
  /// kernel takes away is smoothed and given back, which leaves curvature where it was.
  static SpectralFilter TwicedHeat(double t);

  /// Of the Chebyshev polynomials in 2 M / LargestEigenvalue - 1.
  const std::vector<float>& Series() const { return this->Coefficients; }

private:
  std::vector<float> Coefficients;
};

/// Applies several filters to the same columns at the price of the longest, by Chebyshev's
/// recurrence as in Hammond, Vandergheynst and Gribonval, "Wavelets on Graphs via Spectral Graph
/// Theory", 2011, section 6. Made for N = 4 and 12.
/// @return [filter][vertex][column].
template <std::size_t N>
std::vector<Columns<N>> Apply(const SmoothingGraph& graph,
  const std::vector<SpectralFilter>& filters, Columns<N> x, const FiltrationMonitor& monitor);

/// Means over a neighbourhood, by the heat kernel of a time.
template <std::size_t N>
Columns<N> Pool(
  const SmoothingGraph& graph, double time, Columns<N> values, const FiltrationMonitor& monitor)
{
  return std::move(
    Apply<N>(graph, { SpectralFilter::Heat(time) }, std::move(values), monitor).front());
}

} // namespace PhotonTransport
