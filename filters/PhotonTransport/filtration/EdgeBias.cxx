// SPDX-License-Identifier: BSD-3-Clause
#include "PhotonTransport/filtration/EdgeBias.h"

#include "PhotonTransport/threads/Threads.h"

#include <algorithm>
#include <cmath>

namespace PhotonTransport
{
namespace
{

/// Bias over slope and over curvature, as measured in the rows beside the shadows of plates, at the
/// feet of boxes and in dim creases. Each alone finds them; gentle light has one without the other.
constexpr double BiasOfSlope = 0.65;
constexpr double BiasOfCurvature = 3.5;
/// Bias over curvature and squared width at the border of a patch: a kernel that lies on one side
/// of it levels a slope there. By a twiced heat kernel of width w a slope s becomes a curvature
/// of 1.29 s q / w at the border, with q = sqrt(2 / pi), and the value errs by 0.59 s q w. On a
/// mesh of squares the mean difference from the neighbours of a border vertex is a quarter of the
/// curvature.
constexpr double BiasAtBorder = 4.0 * 0.59 / 1.29;
/// Share of the noise variance of the map that the squared bias reaches. Larger biases stand out of
/// the noise: RelativeRisk does not admit them, and Stein's estimate shows what is left of them.
constexpr double MostOfNoise = 0.3;
/// In vertex distances. A kernel narrower than one is a blend with the map itself, which has no
/// bias. The wider the kernel, the gentler is the light that it was chosen for.
constexpr double LeastWidth = 1.0;
constexpr double MostWidth = 2.0;

double ShareOfWidth(double width)
{
  return width > MostWidth ? MostWidth / width : std::min(width / LeastWidth, 1.0);
}

/// Mean over the neighbours of a function of their vertices, weighed by the conductances.
template <typename Function>
double MeanOverNeighbours(const SmoothingGraph& graph, std::size_t v, const Function& function)
{
  double sum = 0.0;
  double weights = 0.0;
  for (const SmoothingGraph::Edge& edge : graph.At(v))
  {
    sum += double{ edge.conductance } * function(edge.neighbour);
    weights += double{ edge.conductance };
  }
  return weights > 0.0 ? sum / weights : 0.0;
}

/// How the light changes around each vertex, lx.
struct Changes
{
  std::vector<double> slope;     ///< Root mean square difference from the neighbours.
  std::vector<double> curvature; ///< Mean difference from the neighbours.

  Changes(const SmoothingGraph& graph, const std::vector<double>& light)
    : slope(light.size())
    , curvature(light.size())
  {
    ForEach(light.size(),
      [&](std::size_t v)
      {
        const auto difference = [&](std::size_t u) { return light[u] - light[v]; };
        this->slope[v] = std::sqrt(
          MeanOverNeighbours(graph, v, [&](std::size_t u) { return Square(difference(u)); }));
        this->curvature[v] = MeanOverNeighbours(graph, v, difference);
      });
  }

  /// Root mean square of the vertex and its neighbours: curvature changes its sign at an edge.
  double CurvatureAround(const SmoothingGraph& graph, std::size_t v) const
  {
    const double around =
      MeanOverNeighbours(graph, v, [&](std::size_t u) { return Square(this->curvature[u]); });
    return std::sqrt(0.5 * (Square(this->curvature[v]) + around));
  }
};

/// Variance (lx^2) of the map at a vertex. In proportion to the units, it is a mean of those of the
/// neighbours too.
double NoiseAround(const SmoothingGraph& graph, const GroupColumns& map,
  const std::vector<double>& units, std::size_t v)
{
  double variance = Variance(map[v]);
  double sum = units[v];
  for (const SmoothingGraph::Edge& edge : graph.At(v))
  {
    if (edge.conductance > 0.0f)
    {
      variance += Variance(map[edge.neighbour]);
      sum += units[edge.neighbour];
    }
  }
  return sum > 0.0 ? units[v] * (variance / sum) : 0.0;
}

} // namespace

std::vector<double> SquaredEdgeBias(const SmoothingGraph& graph, const GroupColumns& before,
  const Selection& after, const std::vector<double>& units)
{
  std::vector<double> light(before.size());
  ForEach(light.size(), [&](std::size_t v) { light[v] = std::max(MeanOf(after.groups[v]), 0.0); });
  const Changes changes(graph, light);
  std::vector<double> squares(before.size());
  ForEach(squares.size(),
    [&](std::size_t v)
    {
      double bias = ShareOfWidth(double{ after.width[v] }) *
        std::min(
          BiasOfSlope * changes.slope[v], BiasOfCurvature * changes.CurvatureAround(graph, v));
      if (graph.IsAtBorder(v))
      {
        bias = std::max(
          bias, BiasAtBorder * Square(double{ after.width[v] }) * std::fabs(changes.curvature[v]));
      }
      // No more light than there is has come across an edge.
      squares[v] = std::min(
        Square(std::min(bias, light[v])), MostOfNoise * NoiseAround(graph, before, units, v));
    });
  return squares;
}

} // namespace PhotonTransport
