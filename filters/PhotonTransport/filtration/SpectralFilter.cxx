// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/filtration/SpectralFilter.h"

#include "PhotonTransport/filtration/Parallel.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace PhotonTransport
{
namespace
{

/// Largest difference between a response and its polynomial.
constexpr double Tolerance = 1e-3;

/// The series that meets the response at so many of Chebyshev's nodes; half as many terms, since
/// those above are mirror images of those below.
std::vector<double> SeriesFromNodes(
  const std::function<double(double)>& response, std::size_t nodes)
{
  constexpr double Pi = 3.14159265358979323846;
  std::vector<double> cosines(4 * nodes); // of multiples of a quarter turn over the nodes
  for (std::size_t i = 0; i < cosines.size(); ++i)
  {
    cosines[i] = std::cos(Pi * static_cast<double>(i) / (2.0 * static_cast<double>(nodes)));
  }
  std::vector<double> series(nodes / 2, 0.0);
  for (std::size_t i = 0; i < nodes; ++i)
  {
    const double value =
      response(0.5 * double{ SmoothingGraph::LargestEigenvalue } * (1.0 + cosines[2 * i + 1]));
    for (std::size_t k = 0; k < series.size(); ++k)
    {
      series[k] += value * cosines[(2 * i + 1) * k % cosines.size()];
    }
  }
  for (std::size_t k = 0; k < series.size(); ++k)
  {
    series[k] *= (k == 0 ? 1.0 : 2.0) / static_cast<double>(nodes);
  }
  return series;
}

/// From as many nodes as it takes: a response that decays fast needs more.
std::vector<double> ChebyshevSeries(const std::function<double(double)>& response)
{
  constexpr std::size_t MostNodes = 4096;
  std::vector<double> series;
  for (std::size_t nodes = 64; nodes <= MostNodes; nodes *= 2)
  {
    series = SeriesFromNodes(response, nodes);
    const double rest = std::accumulate(series.begin() + nodes / 4, series.end(), 0.0,
      [](double sum, double coefficient) { return sum + std::abs(coefficient); });
    if (rest < 1e-3 * Tolerance)
    {
      break;
    }
  }
  return series;
}

/// One term of Chebyshev's recurrence, T_1 x = y x and T_{k+1} x = 2 y T_k x - T_{k-1} x with
/// y = 2 M / largest - 1, at one vertex.
template <std::size_t N>
std::array<float, N> NextTerm(const SmoothingGraph& graph, std::size_t v, const Columns<N>& current,
  const std::array<float, N>* before)
{
  std::array<float, N> flow{};
  const std::array<float, N> own = current[v];
  for (const SmoothingGraph::Edge& edge : graph.At(v))
  {
    const std::array<float, N>& other = current[edge.neighbour];
    for (std::size_t n = 0; n < N; ++n)
    {
      flow[n] += edge.conductance * (own[n] - other[n]);
    }
  }
  const float scale = 2.0f / SmoothingGraph::LargestEigenvalue * graph.InverseArea(v);
  std::array<float, N> next;
  for (std::size_t n = 0; n < N; ++n)
  {
    const float product = scale * flow[n] - own[n];
    next[n] = before ? 2.0f * product - (*before)[n] : product;
  }
  return next;
}

} // namespace

SpectralFilter::SpectralFilter(const std::function<double(double)>& response)
{
  std::vector<double> series = ChebyshevSeries(response);
  for (double rest = std::abs(series.back()); series.size() > 1 && rest < Tolerance;
       rest += std::abs(series.back()))
  {
    series.pop_back();
  }
  double atZero = 0.0; // T_k(-1) = (-1)^k
  for (std::size_t k = 0; k < series.size(); ++k)
  {
    atZero += k % 2 == 0 ? series[k] : -series[k];
  }
  for (const double coefficient : series)
  {
    this->Coefficients.push_back(static_cast<float>(coefficient / atZero));
  }
}

SpectralFilter SpectralFilter::Heat(double t)
{
  return SpectralFilter([t](double eigenvalue) { return std::exp(-t * eigenvalue); });
}

SpectralFilter SpectralFilter::TwicedHeat(double t)
{
  return SpectralFilter(
    [t](double eigenvalue)
    {
      const double once = std::exp(-t * eigenvalue);
      return once * (2.0 - once);
    });
}

template <std::size_t N>
std::vector<Columns<N>> Apply(const SmoothingGraph& graph,
  const std::vector<SpectralFilter>& filters, const Columns<N>& x, const FiltrationMonitor& monitor)
{
  std::size_t length = 0;
  for (const SpectralFilter& filter : filters)
  {
    length = std::max(length, filter.Series().size());
  }
  std::vector<Columns<N>> results(filters.size(), Columns<N>(graph.Vertices()));
  Columns<N> before(graph.Vertices());
  Columns<N> current = x;
  for (std::size_t term = 0; term < length; ++term)
  {
    monitor(static_cast<double>(term) / static_cast<double>(length));
    ForEach(graph.Vertices(),
      [&](std::size_t v)
      {
        for (std::size_t i = 0; i < filters.size(); ++i)
        {
          if (term < filters[i].Series().size())
          {
            const float coefficient = filters[i].Series()[term];
            for (std::size_t n = 0; n < N; ++n)
            {
              results[i][v][n] += coefficient * current[v][n];
            }
          }
        }
        before[v] = NextTerm<N>(graph, v, current, term == 0 ? nullptr : &before[v]);
      });
    std::swap(before, current);
  }
  return results;
}

template std::vector<Columns<1>> Apply(const SmoothingGraph&, const std::vector<SpectralFilter>&,
  const Columns<1>&, const FiltrationMonitor&);
template std::vector<Columns<4>> Apply(const SmoothingGraph&, const std::vector<SpectralFilter>&,
  const Columns<4>&, const FiltrationMonitor&);
template std::vector<Columns<12>> Apply(const SmoothingGraph&, const std::vector<SpectralFilter>&,
  const Columns<12>&, const FiltrationMonitor&);

} // namespace PhotonTransport
