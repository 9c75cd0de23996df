// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/filtration/SpectralFilter.h"

#include "PhotonTransport/filtration/Row.h"
#include "PhotonTransport/threads/Threads.h"

#include <glm/gtc/constants.hpp>

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
  std::vector<double> cosines(4 * nodes); // of multiples of a quarter turn over the nodes
  for (std::size_t i = 0; i < cosines.size(); ++i)
  {
    cosines[i] =
      std::cos(glm::pi<double>() * static_cast<double>(i) / (2.0 * static_cast<double>(nodes)));
  }
  std::vector<double> series(nodes / 2, 0.0);
  for (std::size_t i = 0; i < nodes; ++i)
  {
    const double value =
      response(0.5 * double{ SmoothingGraph::LargestEigenvalue } * (1.0 + cosines[2 * i + 1]));
    std::size_t angle = 0; // (2 i + 1) k, less whole turns
    for (double& coefficient : series)
    {
      coefficient += value * cosines[angle];
      angle += 2 * i + 1;
      angle -= angle < cosines.size() ? 0 : cosines.size();
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

/// What T_{k-1}, T_k and T_{k+1} count in one filter's series, and where its sum is kept.
template <std::size_t N>
struct SeriesPart
{
  std::array<float, 3> coefficients;
  std::array<float, N>* sums;
};

/// Of the filters whose series has terms in [first, last], which are at most three.
template <std::size_t N>
std::vector<SeriesPart<N>> PartsOf(const std::vector<SpectralFilter>& filters, std::size_t first,
  std::size_t last, std::vector<Columns<N>>& results)
{
  std::vector<SeriesPart<N>> parts;
  for (std::size_t i = 0; i < filters.size(); ++i)
  {
    const std::vector<float>& series = filters[i].Series();
    if (first < series.size())
    {
      parts.push_back({ {}, results[i].data() });
      for (std::size_t k = first; k <= std::min(last, series.size() - 1); ++k)
      {
        parts.back().coefficients[k + 2 - last] = series[k];
      }
    }
  }
  return parts;
}

/// y x at one vertex, y = 2 M / largest - 1.
template <std::size_t N>
Row<N> Product(const SmoothingGraph& graph, std::size_t v, const std::array<float, N>* x)
{
  const Row<N> own(x[v]);
  Row<N> inflow; // -L x
  for (const SmoothingGraph::Edge& edge : graph.At(v))
  {
    inflow.Add(edge.conductance, Row<N>(x[edge.neighbour]) - own);
  }
  return -2.0f / SmoothingGraph::LargestEigenvalue * graph.InverseArea(v) * inflow - own;
}

/// A step of Chebyshev's recurrence, T_{k+1} x = 2 y T_k x - T_{k-1} x. It replaces T_{k-1}. The
/// first step, T_1 x = y x, finds neither that nor the sums set.
template <std::size_t N>
void Step(const SmoothingGraph& graph, bool isFirst, const Columns<N>& currentTerm,
  Columns<N>& termBefore, const std::vector<SeriesPart<N>>& parts)
{
  ParallelFor(
    0, graph.Vertices(),
    [&](std::size_t first, std::size_t last)
    {
      // Stores could change what is reached through references; copies stay in registers.
      const std::array<float, N>* const current = currentTerm.data();
      std::array<float, N>* const before = termBefore.data();
      const SeriesPart<N>* const firstPart = parts.data();
      const SeriesPart<N>* const lastPart = firstPart + parts.size();
      const bool unset = isFirst;
      for (std::size_t v = first; v < last; ++v)
      {
        const Row<N> old = unset ? Row<N>() : Row<N>(before[v]);
        const Row<N> next = (unset ? 1.0f : 2.0f) * Product<N>(graph, v, current) - old;
        next.StoreTo(before[v]);
        for (const SeriesPart<N>* part = firstPart; part != lastPart; ++part)
        {
          Row<N> sum = unset ? Row<N>() : Row<N>(part->sums[v]);
          sum.Add(part->coefficients[0], old);
          sum.Add(part->coefficients[1], Row<N>(current[v]));
          sum.Add(part->coefficients[2], next);
          sum.StoreTo(part->sums[v]);
        }
      }
    },
    SimpleCalls);
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
  const std::vector<SpectralFilter>& filters, Columns<N> x, const FiltrationMonitor& monitor)
{
  std::size_t length = 2;
  for (const SpectralFilter& filter : filters)
  {
    length = std::max(length, filter.Series().size());
  }
  std::vector<Columns<N>> results;
  for (std::size_t i = 0; i < filters.size(); ++i)
  {
    results.emplace_back(graph.Vertices());
  }
  Columns<N> before(graph.Vertices());
  Columns<N>& current = x;
  std::size_t added = 0; // terms
  for (std::size_t k = 0; k + 1 < length; ++k)
  {
    monitor(static_cast<double>(k) / static_cast<double>(length));
    // Memory is what this waits for, so the sums are fetched once for three terms.
    std::vector<SeriesPart<N>> parts;
    if (k == 0 || k == added + 1 || k + 2 == length)
    {
      parts = PartsOf<N>(filters, added, k + 1, results);
      added = k + 2;
    }
    Step(graph, k == 0, current, before, parts);
    std::swap(before, current);
  }
  return results;
}

template std::vector<Columns<4>> Apply(
  const SmoothingGraph&, const std::vector<SpectralFilter>&, Columns<4>, const FiltrationMonitor&);
template std::vector<Columns<12>> Apply(
  const SmoothingGraph&, const std::vector<SpectralFilter>&, Columns<12>, const FiltrationMonitor&);

} // namespace PhotonTransport
